"""Series of slices: gaps in their numbers, and slices that do not fit each other."""
import json
import unittest

from support import CANNOT_READ, CommandTest, cleft, write_nrrd


class Slices(CommandTest):
    def info(self, pattern):
        self.run_ok("info", self.path(pattern), "--json", self.path("report.json"))
        report = json.loads(self.path("report.json").read_text())
        return {row["label"]: row["voxels"] for row in report["volume"]["labels"]}, report["warnings"]

    def slices(self, *numbers, pattern="s%03d.nrrd"):
        for number in numbers:
            write_nrrd(self.path(pattern % number), (4, 3, 1), [number] * 12)

    def test_a_missing_slice_is_named(self):
        self.slices(1, 2, 3, 5)
        done = cleft("info", self.path("s%03d.nrrd"))
        self.assert_fails(CANNOT_READ, done, "s004.nrrd", "missing", "s005.nrrd")
        labels, warnings = self.info("s*.nrrd")
        self.assertEqual(labels, {1: 12, 2: 12, 3: 12, 5: 12})
        self.assertEqual(len(warnings), 1)
        for word in ("s*.nrrd", "gap", "number 4"):
            self.assertIn(word, warnings[0])
        self.slices(4)
        for pattern in ("s%03d.nrrd", "s*.nrrd"):
            self.assertEqual(self.info(pattern), ({n: 12 for n in range(1, 6)}, []))

    def test_counting_begins_at_0_or_1_and_other_names_do_not_disturb(self):
        self.slices(0, 1, 2)
        self.slices(9, pattern="t%03d.nrrd")
        self.slices(9, pattern="s%03d_mask.nrrd")
        self.assertEqual(self.info("s%03d.nrrd")[0], {0: 12, 1: 12, 2: 12})

    def test_slices_at_one_place_are_told(self):
        for number in range(3):
            write_nrrd(self.path("p%d.nrrd" % number), (4, 3, 1), [number] * 12, origin=(5, 6, 7), spacing=(1, 1, 2))
        self.assertIn("at one place by their headers: they are put 2 apart", self.info("p*.nrrd")[1][0])

    def test_slices_without_a_pattern_are_no_masks(self):
        """A shell makes names of a pattern without quotes."""
        for values in ([0, 1], [0, 255], [0, 1, 2]):
            files = [self.path("m%d.nrrd" % k) for k in range(3)]
            for k, file in enumerate(files):
                write_nrrd(file, (4, 3, 1), [values[(i + k) % len(values)] for i in range(12)])
            self.assert_fails(CANNOT_READ, cleft("info", *files), "m0.nrrd", "pattern in quotes", "--as labels")
            self.assertEqual(sum(self.info("m*.nrrd")[0].values()), 36)
            self.run_ok("info", *files, "--as", "indicators")

    def test_slices_of_another_spacing_are_refused(self):
        self.slices(1, 2)
        write_nrrd(self.path("s003.nrrd"), (4, 3, 1), [3] * 12, spacing=(2, 1, 1))
        self.assert_fails(CANNOT_READ, cleft("info", self.path("s%03d.nrrd")), "s003.nrrd", "spacing")


if __name__ == "__main__":
    unittest.main()
