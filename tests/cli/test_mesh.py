"""cleft mesh: outputs, report, summary, determinism, wanted numbers."""
import json
import os
import unittest

from support import DATA, OK, CommandTest, cleft


class Mesh(CommandTest):
    def test_report_has_its_fields(self):
        report = self.mesh(self.volume, "--seed", 4, "--label-size", "3=0.8")
        self.assertEqual(report["program"], "cleft")
        self.assertEqual(report["command"], "mesh")
        self.assertRegex(report["version"], r"^\d+\.\d+\.\d+$")
        self.assertEqual(report["options"]["seed"], 4)
        self.assertEqual(report["options"]["background"], "particles")
        self.assertEqual(report["options"]["gradation"], 0.3)
        self.assertEqual(report["options"]["label_sizes"], ["3=0.8"])
        self.assertEqual(report["volume"]["dims"], [16, 16, 16])
        self.assertGreater(report["mesh"]["points"], 100)
        self.assertGreater(report["mesh"]["interface_triangles"], 100)
        self.assertEqual(report["warnings"], [])
        self.assertIsInstance(report["metrics"], dict)
        for key in ("seconds", "cpu_seconds", "peak_bytes"):
            self.assertGreater(report[key], 0)

    def test_report_figures_agree_with_each_other(self):
        report = self.mesh(self.volume)
        quality, labels = report["quality"], report["labels"]
        self.assertEqual(
            quality["tet_count"] if "tet_count" in quality else report["mesh"]["tets"], report["mesh"]["tets"]
        )
        self.assertEqual(sum(quality["dihedral_histogram"]), 6 * report["mesh"]["tets"])
        self.assertEqual(sum(row["tets"] for row in labels), report["mesh"]["tets"])
        self.assertEqual([row["label"] for row in labels], [0, 3, 7])
        self.assertEqual(sum(row["voxels"] for row in labels), 16**3)
        self.assertAlmostEqual(sum(row["mesh_volume"] for row in labels), 16**3, places=6)
        self.assertAlmostEqual(quality["total_volume"], 16**3, places=6)
        self.assertGreater(quality["min_dihedral"], 0)

    def test_every_stage_is_measured(self):
        report = self.mesh(self.volume)
        names = [stage["name"] for stage in report["stages"]]
        for name in ("read", "sizing", "background", "cleaving", "mesh", "report", "write"):
            self.assertIn(name, names)
        for stage in report["stages"]:
            self.assertGreaterEqual(stage["seconds"], 0)
            self.assertGreaterEqual(stage["cpu_seconds"], 0)
            self.assertGreater(stage["peak_bytes"], 1e6)
        metrics = report["metrics"]
        for name in ("sizing", "background", "cleaving", "improving", "fitting"):
            serial = metrics[name + ".serial_seconds"]
            self.assertTrue(0 <= serial <= metrics[name + ".cpu_seconds"], name)

    @unittest.skipIf(os.environ.get("SANITIZERS"), "sanitizers take memory of their own")
    def test_memory_is_that_of_the_command_alone(self):
        held = bytearray(os.urandom(4096) * 75000)  # of the program that starts it: 300 MB
        report = self.mesh(self.volume)
        for stage in report["stages"]:
            self.assertLess(stage["peak_bytes"], len(held) / 2)

    def test_summary_on_a_pipe_has_no_progress_bar(self):
        done = self.run_ok("mesh", self.volume, "-o", self.path("out.vtu"))
        for word in ("tetrahedra", "Angles", "Dihedral angles", "Labels", "out.vtu", "voxel volume"):
            self.assertIn(word, done.stdout)
        self.assertNotIn("\r", done.stdout)
        self.assertEqual(done.stderr, "")

    def test_quiet_prints_nothing(self):
        done = self.run_ok("mesh", self.volume, "-o", self.path("out.vtu"), "--quiet")
        self.assertEqual(done.stdout + done.stderr, "")
        self.assertGreater(self.path("out.vtu").stat().st_size, 1000)

    def test_report_on_standard_output_is_all_there_is(self):
        done = self.run_ok("mesh", self.volume, "-o", self.path("out.vtu"), "--json", "-")
        self.assertEqual(json.loads(done.stdout)["command"], "mesh")

    def test_several_outputs(self):
        names = ["a.vtu", "b.msh", "c.mesh", "d.inp", "e.stl", "f.ply", "g.vtk"]
        self.run_ok("mesh", self.volume, *[word for name in names for word in ("-o", self.path(name))])
        for name in names:
            self.assertGreater(self.path(name).stat().st_size, 1000, name)
        self.assertEqual(len(list(self.folder.iterdir())), len(names) + 1)

    def test_msh_version(self):
        for version in ("2.2", "4.1"):
            self.run_ok("mesh", self.volume, "-o", self.path("a.msh"), "--msh-version", version)
            self.assertIn(b"$MeshFormat\n" + version.encode(), self.path("a.msh").read_bytes()[:40])

    def test_same_bytes_for_every_thread_count_and_run(self):
        texts = []
        for threads in (1, 2, 1):
            self.run_ok("mesh", DATA / "mickey.nrrd", "-o", self.path("out.mesh"), "--threads", threads)
            texts.append(self.path("out.mesh").read_bytes())
        self.assertEqual(texts[0], texts[1])
        self.assertEqual(texts[0], texts[2])

    def test_seed_varies_the_mesh(self):
        texts = []
        for seed in (1, 2):
            self.run_ok("mesh", self.volume, "-o", self.path("out.mesh"), "--seed", seed)
            texts.append(self.path("out.mesh").read_bytes())
        self.assertNotEqual(*texts)

    def test_a_lattice_that_is_coarser_than_the_thinnest_parts_warns_once(self):
        def reported(volume, *arguments):
            report = self.mesh(volume, *arguments)
            return report, [warning for warning in report["warnings"] if "lattice" in warning]

        mickey = DATA / "mickey.nrrd"
        report, sentences = reported(mickey, "--background", "lattice", "--tets", 9000)
        self.assertEqual(len(sentences), 1)
        least = report["metrics"]["sizing.least"]
        self.assertIn("a size of %.6g resolves them" % least, sentences[0])
        self.assertGreater(float(sentences[0].split("one size, ")[1].split(",")[0]), 3 * least)
        self.assertEqual(reported(self.volume, "--background", "lattice")[1], [])
        self.assertEqual(reported(mickey, "--background", "octree", "--tets", 9000)[1], [])
        self.assertEqual(reported(mickey, "--background", "lattice", "--size", 3, "--tets", 9000)[1], [])

    def test_wanted_number_of_tetrahedra(self):
        for wanted in (20000, 100000):
            report = self.mesh(DATA / "mickey.nrrd", "--tets", wanted)
            self.assertLessEqual(abs(report["mesh"]["tets"] - wanted), 0.1 * wanted)

    def test_size_limits_the_edges(self):
        coarse = self.mesh(self.volume, "--size", 3)
        fine = self.mesh(self.volume, "--size", 1)
        self.assertGreater(fine["mesh"]["tets"], 8 * coarse["mesh"]["tets"])

    def test_background_from_a_file(self):
        self.mesh(self.volume, "--size", 2, output="background.vtu")
        report = self.mesh(self.volume, "--background", self.path("background.vtu"))
        self.assertEqual(report["options"]["background"], str(self.path("background.vtu")))
        self.assertAlmostEqual(report["quality"]["total_volume"], 16**3, places=6)

    def test_estimate_writes_no_mesh(self):
        report = json.loads(self.run_ok("mesh", self.volume, "--estimate", "--json", "-").stdout)
        tets = self.mesh(self.volume)["mesh"]["tets"]
        self.assertGreater(report["estimate"]["tets"], tets / 4)
        self.assertLess(report["estimate"]["tets"], tets * 4)
        self.assertGreater(report["estimate"]["peak_bytes"], 12 * 16**3)
        self.assertIn("tetrahedra", self.run_ok("mesh", self.volume, "--estimate").stdout)

    def test_checked_before_it_is_written(self):
        self.run_ok("mesh", self.volume, "-o", self.path("out.vtu"), "--check")


if __name__ == "__main__":
    unittest.main()
