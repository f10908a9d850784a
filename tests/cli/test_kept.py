"""Labels that are left out: checking, counting and estimating what is kept; contacts that the voxels do not have."""
import json
import math
import unittest

from support import DATA, LABEL_LOST, OK, USAGE, CommandTest, cleft, write_nrrd

BACKGROUNDS = ("particles", "lattice", "octree")


def socket(n=24):
    """A ball 1 in a socket 2, between them a gap of a voxel that opens to the outside, 0; they touch at corners."""

    def label(x, y, z):
        square = (x - n / 2) ** 2 + (y - n / 2) ** 2 + (z - n / 2) ** 2
        return 1 if square < 6.2**2 else 2 if 7.4**2 < square < 10.5**2 and z - n / 2 < 2 else 0

    return [label(x + 0.5, y + 0.5, z + 0.5) for z in range(n) for y in range(n) for x in range(n)]


class Checked(CommandTest):
    def assert_checked(self, volume, *arguments):
        done = cleft("mesh", volume, *arguments, "--check", "--quiet", "-o", self.path("part.vtu"))
        self.assertEqual(done.returncode, OK, f"{arguments}: {done.stderr}")
        self.assertEqual(cleft("check", self.path("part.vtu")).returncode, OK, arguments)

    def test_every_strip_and_only_passes_the_check(self):
        for background in BACKGROUNDS:
            for option in ("--strip", "--only"):
                for label in (0, 3, 7):
                    self.assert_checked(self.volume, option, label, "--background", background)

    def test_every_strip_and_only_of_a_real_volume(self):
        volume = DATA / "mickey.nrrd"
        self.run_ok("info", volume, "--json", self.path("i.json"), "--quiet")
        labels = [row["label"] for row in json.loads(self.path("i.json").read_text())["volume"]["labels"]]
        for i, label in enumerate(labels):
            for option in ("--strip", "--only"):
                self.assert_checked(volume, option, label, "--background", ("particles", "octree")[i % 2])

    def test_on_a_background_of_ones_own(self):
        self.run_ok("mesh", self.volume, "--only", "0", "--size", 3, "--quiet", "-o", self.path("own.vtu"))
        for option in ([], ["--strip", "0"], ["--only", "3", "7"]):
            self.assert_checked(self.volume, "--background", self.path("own.vtu"), *option)

    def test_lists_of_labels_that_are_not_there(self):
        done = self.run_ok("mesh", self.volume, "--strip", "0", "9", "-5", "-o", self.path("out.vtu"))
        self.assertIn("warning: strip names labels -5 and 9, which the volume does not have\n", done.stderr)
        done = cleft("mesh", self.volume, "--only", "9", "-o", self.path("none.vtu"))
        self.assert_fails(USAGE, done, "only would leave nothing of the volume, which has labels 0, 3 and 7")
        done = cleft("mesh", self.volume, "--strip", "0", "3", "7", "-o", self.path("none.vtu"))
        self.assert_fails(USAGE, done, "strip would leave nothing of the volume")
        self.assertFalse(self.path("none.vtu").exists())


class Counted(CommandTest):
    def test_the_wanted_number_is_that_of_what_is_kept(self):
        for background in BACKGROUNDS:
            report = self.mesh(self.volume, "--strip", "0", "--tets", 20000, "--background", background)
            # Cells fit the box in whole numbers: a lattice may jump over the wanted one, and says so.
            is_met = abs(report["mesh"]["tets"] / 20000 - 1) < 0.1
            self.assertEqual(is_met, report["warnings"] == [], report["warnings"])
            self.assertTrue(is_met or background != "particles")
            self.assertLessEqual(report["metrics"]["pipeline.rounds.count"], 8)

    def test_the_estimate_is_of_what_is_kept(self):
        def estimate(*arguments):
            self.run_ok("mesh", self.volume, "--estimate", "--quiet", "--json", self.path("e.json"), *arguments)
            return json.loads(self.path("e.json").read_text())["estimate"]

        whole, parts = estimate(), [estimate(option, 0) for option in ("--strip", "--only")]
        self.assertAlmostEqual(parts[0]["tets"] + parts[1]["tets"], whole["tets"], delta=0.02 * whole["tets"])
        for part in parts:
            self.assertLess(part["tets"], 0.9 * whole["tets"])
            self.assertAlmostEqual(part["whole_tets"], whole["tets"], delta=0.02 * whole["tets"])
            self.assertAlmostEqual(part["peak_bytes"], whole["peak_bytes"], delta=0.001 * whole["peak_bytes"])
        self.assertLess(abs(math.log(parts[0]["tets"] / self.mesh(self.volume, "--strip", 0)["mesh"]["tets"])), 0.5)
        self.run_ok("mesh", self.volume, "--size", 1, "--quiet", "-o", self.path("own.vtu"))
        own = [estimate("--background", self.path("own.vtu"), *option) for option in ([], ["--strip", 0])]
        self.assertAlmostEqual(own[1]["whole_tets"], own[0]["tets"], delta=1)
        self.assertLess(own[1]["tets"], 0.5 * own[0]["tets"])
        done = self.run_ok("mesh", self.volume, "--estimate", "--strip", 0)
        self.assertIn("with the labels that are left out", done.stdout)


class Contacts(CommandTest):
    def setUp(self):
        super().setUp()
        write_nrrd(self.path("socket.nrrd"), (24, 24, 24), socket())

    def report_of(self, *arguments):
        done = self.run_ok(
            "mesh", self.path("socket.nrrd"), "-o", self.path("s.vtu"), "--json", self.path("s.json"), *arguments
        )
        return json.loads(self.path("s.json").read_text()), done.stderr

    def test_are_told_and_with_strict_refused(self):
        report, reported = self.report_of("--size", 3.5)
        [contact] = report["contacts"]
        self.assertEqual(contact["labels"], [1, 2])
        self.assertGreater(contact["triangles"], 0)
        [warning] = [w for w in report["warnings"] if "no two of their voxels share a face or an edge" in w]
        self.assertIn(f"1 and 2 ({contact['triangles']} triangle", warning)
        self.assertIn(warning, reported)
        quiet, reported = self.report_of("--size", 3.5, "--quiet")
        self.assertEqual((quiet["warnings"], reported), (report["warnings"], ""))
        done = cleft(
            "mesh", self.path("socket.nrrd"), "--size", 3.5, "--strict", "--strip", 0, "-o", self.path("strict.vtu")
        )
        self.assert_fails(LABEL_LOST, done, "label 1 and label 2 share")
        self.assertFalse(self.path("strict.vtu").exists())

    def test_of_a_label_that_is_left_out_are_none(self):
        self.assertEqual(self.report_of("--size", 3.5, "--strip", 1)[0]["contacts"], [])
        self.assertEqual(len(self.report_of("--size", 3.5, "--strip", 0)[0]["contacts"]), 1)

    def test_default_sizes_make_none(self):
        for background in BACKGROUNDS:
            report, reported = self.report_of("--background", background, "--strict")
            self.assertEqual((report["contacts"], report["warnings"], reported), ([], [], ""), background)


class Reported(CommandTest):
    def test_volumes_that_differ(self):
        """Two sheets of a voxel among large tetrahedra: one sentence, on standard error and in the report."""
        values = [1 if v // 576 == 7 else 2 if v // 576 == 16 else 0 for v in range(24**3)]
        write_nrrd(self.path("sheets.nrrd"), (24, 24, 24), values)
        arguments = ["mesh", self.path("sheets.nrrd"), "--size", 6, "-o", self.path("o.vtu"), "--json"]
        done = self.run_ok(*arguments, self.path("r.json"))
        report = json.loads(self.path("r.json").read_text())
        [warning] = [w for w in report["warnings"] if "from that of the voxels" in w]
        self.assertIn(warning, done.stderr)
        for row in report["labels"]:
            named = f"label {row['label']} (" in warning
            self.assertEqual(named, abs(row["difference_percent"]) > 5, row)
        self.run_ok(*arguments, self.path("q.json"), "--quiet")
        self.assertEqual(json.loads(self.path("q.json").read_text())["warnings"], report["warnings"])
        done = self.run_ok(*arguments, "-")
        self.assertIn(warning, done.stderr)
        self.assertEqual(json.loads(done.stdout)["warnings"], report["warnings"])

    def test_smooth_of_functions(self):
        function = [6 - math.dist((x, y, z), (7.5, 7.5, 7.5)) for z in range(16) for y in range(16) for x in range(16)]
        write_nrrd(self.path("f.nrrd"), (16, 16, 16), function, "float")
        done = self.run_ok("mesh", self.path("f.nrrd"), "--smooth", 4, "-o", self.path("f.vtu"))
        self.assertIn("smooth has no effect on a volume of indicator functions", done.stderr)
        done = self.run_ok("mesh", self.volume, "--smooth", 4, "-o", self.path("f.vtu"))
        self.assertEqual(done.stderr, "")


if __name__ == "__main__":
    unittest.main()
