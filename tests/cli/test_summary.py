"""What a person reads of a run agrees with the report, and is cut where it would be long."""
import json
import re
import unittest

from support import CommandTest, write_nrrd

DIMS = (16, 12, 8)


def blocks():
    """24 cubes of 4 voxels a side, each with a label of its own."""
    return [1 + x // 4 + 4 * (y // 4) + 12 * (z // 4) for z in range(8) for y in range(12) for x in range(16)]


class Summary(CommandTest):
    def setUp(self):
        super().setUp()
        self.blocks = self.path("blocks.nrrd")
        write_nrrd(self.blocks, DIMS, blocks())

    def summary(self, *arguments):
        """The lines that are printed, and the report."""
        report = self.path("report.json")
        done = self.run_ok("mesh", self.blocks, "-o", self.path("out.vtu"), "--json", report, *arguments)
        return done.stdout.splitlines(), json.loads(report.read_text())

    def part(self, lines, heading):
        """The lines behind the one that begins so, up to a blank one."""
        start = [line.startswith(heading) for line in lines].index(True)
        return lines[start], lines[start + 1 : lines.index("", start)]

    def assert_rows(self, rows, wanted):
        """The rows of the table of labels are these of the report."""
        self.assertEqual(len(rows), len(wanted))
        for row, label in zip(rows, wanted):
            number, voxels, voxel_volume, mesh_volume, percent, sign, tets, *pieces = row.split()
            self.assertEqual((int(number), int(voxels), int(tets)), (label["label"], 64, label["tets"]))
            self.assertEqual(float(voxel_volume), 64)
            self.assertAlmostEqual(float(mesh_volume), label["mesh_volume"], delta=5e-4)
            self.assertAlmostEqual(float(percent), label["difference_percent"], delta=0.005001)
            self.assertEqual((sign, pieces), ("%", ["1", "->", "1"]))

    def test_of_many_labels_those_that_differ_most_are_shown(self):
        lines, report = self.summary()
        heading, (columns, *rows) = self.part(lines, "Labels")
        self.assertEqual(heading, "Labels, the 20 of 24 whose volumes differ most (all of them: --verbose, --json)")
        self.assertEqual(columns.split()[:2], ["label", "voxels"])
        most = sorted(report["labels"], key=lambda label: -abs(label["difference_percent"]))
        self.assert_rows(rows, most[:20])

    def test_labels_that_are_left_out_do_not_count(self):
        lines, report = self.summary("--strip", "1,2,3,4")
        heading, (_, *rows) = self.part(lines, "Labels")
        self.assertEqual(heading, "Labels, 4 left out as asked")
        self.assert_rows(rows, [label for label in report["labels"] if label["label"] > 4])
        self.assertEqual([label["left_out"] for label in report["labels"]], 4 * [True] + 20 * [False])

    def test_distances_are_shown_when_asked_for(self):
        lines, report = self.summary()
        self.assertNotIn("distances", report)
        self.assertFalse([line for line in lines if line.startswith("Distances")])
        lines, report = self.summary("--distances")
        heading, (columns, *rows) = self.part(lines, "Distances")
        self.assertIn(f"the 20 of {len(report['distances'])} with the greatest", heading)
        self.assertEqual(len(rows), 20)
        most = sorted(report["distances"], key=lambda d: -max(d["mesh"]["greatest"], d["volume"]["greatest"]))
        for row, wanted in zip(rows, most):
            figures = row.split()[len(wanted["labels"]) :]
            self.assertEqual([int(label) for label in row.split()[: len(wanted["labels"])]], wanted["labels"])
            self.assertEqual(int(figures[0]), wanted["triangles" if len(wanted["labels"]) == 2 else "edges"])
            self.assertAlmostEqual(float(figures[3]), wanted["mesh"]["greatest"], delta=0.005001)
            self.assertAlmostEqual(float(figures[6]), wanted["volume"]["greatest"], delta=0.005001)

    def test_verbose_shows_all_labels_and_the_stages(self):
        lines, report = self.summary("--verbose")
        heading, (_, *rows) = self.part(lines, "Labels")
        self.assertEqual(heading, "Labels")
        self.assert_rows(rows, report["labels"])
        _, rows = self.part(lines, "Stages")
        stages = {stage["name"]: stage for stage in report["stages"]}
        self.assertEqual(sorted(row.split()[0] for row in rows), sorted(stages))
        # Those within another one stand under it.
        self.assertEqual([row.split()[0] for row in rows if row[2] != " "], ["read", "mesh", "report", "write"])
        places = {row.split()[0]: place for place, row in enumerate(rows)}
        for name, stage in stages.items():
            self.assertIn(stage["part_of"], ["", *stages])
            if stage["part_of"]:
                self.assertLess(places[stage["part_of"]], places[name])
        self.assertEqual(stages["background.seed"]["part_of"], "background")
        self.assertEqual(stages["background"]["part_of"], "mesh")
        units = {"kB": 1e3, "MB": 1e6, "GB": 1e9}
        for row in rows:
            stage = stages[row.split()[0]]
            figures = re.fullmatch(r" +\S+ +([\d.]+) s +([\d.]+) % +([\d.]+) s of CPU +([\d.]+) (kB|MB|GB)", row)
            self.assertIsNotNone(figures, row)
            self.assertAlmostEqual(float(figures[1]), stage["seconds"], delta=0.0501)
            # The report is written before the summary, which has the longer time of the run.
            self.assertLessEqual(float(figures[2]), 100 * stage["seconds"] / report["seconds"] + 0.0501)
            self.assertAlmostEqual(float(figures[3]), stage["cpu_seconds"], delta=0.0501)
            self.assertAlmostEqual(float(figures[4]) * units[figures[5]] / stage["peak_bytes"], 1, delta=0.006)


if __name__ == "__main__":
    unittest.main()
