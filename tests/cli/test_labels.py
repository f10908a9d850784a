"""Labels that are left out, and labels that get lost."""
import json
import unittest

from support import LABEL_LOST, CommandTest, cleft, write_nrrd


def labels_of(report):
    return [row["label"] for row in report["mesh"]["labels"]]


class Labels(CommandTest):
    def test_all_are_kept_unless_asked(self):
        self.assertEqual(labels_of(self.mesh(self.volume)), [0, 3, 7])

    def test_strip(self):
        self.assertEqual(labels_of(self.mesh(self.volume, "--strip", "0")), [3, 7])
        self.assertEqual(labels_of(self.mesh("--strip", "0", "7", self.volume)), [3])
        self.assertEqual(labels_of(self.mesh("--strip", "0,7", self.volume)), [3])
        self.assertEqual(labels_of(self.mesh(self.volume, "--strip", "0", "--strip", "3")), [7])

    def test_only(self):
        self.assertEqual(labels_of(self.mesh(self.volume, "--only", "7")), [7])
        self.assertEqual(labels_of(self.mesh(self.volume, "--only", "3", "7")), [3, 7])

    def test_what_is_left_is_the_same_mesh(self):
        whole = self.mesh(self.volume)
        part = self.mesh(self.volume, "--strip", "0")
        rows = [{row["label"]: row for row in report["mesh"]["labels"]} for report in (whole, part)]
        for label in (3, 7):
            self.assertEqual(rows[0][label]["tets"], rows[1][label]["tets"])
            self.assertAlmostEqual(rows[0][label]["volume"], rows[1][label]["volume"], places=9)
        out = {row["label"]: row["left_out"] for row in part["labels"]}
        self.assertEqual(out, {0: True, 3: False, 7: False})
        self.assertFalse(any(row["lost"] for row in part["labels"]))

    def test_values_come_out_as_they_went_in(self):
        values = [-30000 if x < 4 else 12 if x < 8 else 30000 for _ in range(144) for x in range(12)]
        write_nrrd(self.path("wide.nrrd"), (12, 12, 12), values, "int16")
        self.assertEqual(labels_of(self.mesh(self.path("wide.nrrd"))), [-30000, 12, 30000])
        self.assertEqual(labels_of(self.mesh(self.path("wide.nrrd"), "--strip", "-30000")), [12, 30000])

    def make_speck(self):
        values = [0] * 24**3
        values[12 * 24 * 24 + 12 * 24 + 12] = 5
        write_nrrd(self.path("speck.nrrd"), (24, 24, 24), values)
        return self.path("speck.nrrd")

    def test_a_single_voxel_is_kept_by_default(self):
        self.assertEqual(labels_of(self.mesh(self.make_speck(), "--strict")), [0, 5])

    def test_a_lost_label_is_told_and_with_strict_refused(self):
        speck = self.make_speck()
        done = self.run_ok("mesh", speck, "-o", self.path("out.vtu"), "--size", 11, "--json", self.path("r.json"))
        self.assertIn("label 5", done.stderr)
        self.assertIn("LOST", done.stdout)
        report = json.loads(self.path("r.json").read_text())
        self.assertTrue(any("label 5" in warning for warning in report["warnings"]))
        done = cleft("mesh", speck, "-o", self.path("strict.vtu"), "--size", 11, "--strict")
        self.assert_fails(LABEL_LOST, done, "label 5")
        self.assertFalse(self.path("strict.vtu").exists())


if __name__ == "__main__":
    unittest.main()
