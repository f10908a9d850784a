"""Failures: the exit code, the message, the report, and no file left behind."""
import errno
import json
import os
import resource
import unittest

from support import CANNOT_READ, CANNOT_WRITE, OUT_OF_MEMORY, CommandTest, cleft, write_nrrd


class Failures(CommandTest):
    def test_input_that_is_not_there(self):
        done = cleft("mesh", self.path("none.nrrd"), "-o", self.path("out.vtu"))
        self.assert_fails(CANNOT_READ, done, "none.nrrd")
        self.assertEqual(done.stdout, "")
        done = cleft("info", self.path("none") / "*.png")
        self.assert_fails(CANNOT_READ, done, "the folder '%s' cannot be read" % self.path("none"))

    def test_input_that_is_cut_short(self):
        self.volume.write_bytes(self.volume.read_bytes()[:-100])
        self.assert_fails(CANNOT_READ, cleft("mesh", self.volume, "-o", self.path("out.vtu")))
        self.path("a.raw").write_bytes(bytes(100))
        done = cleft("mesh", self.path("a.raw"), "--dims", 16, 16, 16, "-o", self.path("out.vtu"))
        self.assert_fails(CANNOT_READ, done, "a.raw")

    def test_names_that_the_system_refuses(self):
        """Too long, in a circle of links, or behind a folder that is closed."""
        links = self.path("links")
        links.mkdir()
        for end in (".nrrd", ".nii", ".img", ".vtu", ".vtk", ".raw"):
            (links / ("a" + end)).symlink_to("b" + end)
            (links / ("b" + end)).symlink_to("a" + end)
            names = [(self.path("long" * 100 + end), errno.ENAMETOOLONG), (links / ("a" + end), errno.ELOOP)]
            if os.geteuid() != 0:
                closed = self.path("closed" + end)
                closed.mkdir(mode=0)
                names.append((closed / ("a" + end), errno.EACCES))
            for name, number in names:
                command = "check" if end == ".vtu" else "info"
                raw = ["--dims", 4, 4, 4] if end == ".raw" else []
                done = cleft(command, name, *raw, "--json", self.path("r.json"))
                self.assert_fails(CANNOT_READ, done, name, os.strerror(number))
                error = json.loads(self.path("r.json").read_text())["error"]
                self.assertEqual(error["status"], -13)  # CLEFT_ERROR_FILE

    @unittest.skipIf(os.geteuid() == 0, "no folder is closed to root")
    def test_closed_folders(self):
        closed = self.path("closed")
        closed.mkdir(mode=0o100)  # its names cannot be listed
        for name in (closed, closed / "*.png", closed / "s%d.png"):
            done = cleft("info", name)
            self.assert_fails(CANNOT_READ, done, closed)
            if name.name != "s%d.png":
                self.assertIn("the folder '%s' cannot be read: %s" % (closed, os.strerror(errno.EACCES)), done.stderr)
        (self.path("open") / "closed").mkdir(parents=True)
        (self.path("open") / "closed").chmod(0)
        self.assert_fails(CANNOT_READ, cleft("info", self.path("open")), "the folder holds no DICOM series")

    def test_pipes_are_no_volumes(self):
        os.mkfifo(self.path("pipe.nrrd"))
        done = cleft("mesh", self.path("pipe.nrrd"), "-o", self.path("out.vtu"))
        self.assert_fails(CANNOT_READ, done, self.path("pipe.nrrd"), "it is a device or pipe, not a file")

    def test_inputs_on_different_grids(self):
        for name, n in (("a.nrrd", 4), ("b.nrrd", 5)):
            write_nrrd(self.path(name), (n, n, n), [0.5] * n**3, "float")
        done = cleft("mesh", self.path("a.nrrd"), self.path("b.nrrd"), "-o", self.path("out.vtu"))
        self.assert_fails(CANNOT_READ, done)

    def test_outputs_are_looked_at_before_the_work(self):
        # The input is not there either: if it were read first, the exit code would say so.
        missing = self.path("none.nrrd")
        for output in ("no/such/folder/out.vtu", "out.unknown", "out", "."):
            done = cleft("mesh", missing, "-o", self.path(output))
            self.assert_fails(CANNOT_WRITE, done, self.path(output))
        done = cleft("mesh", missing, "-o", self.path("out.vtu"), "--json", self.path("no/such/r.json"))
        self.assert_fails(CANNOT_WRITE, done, "r.json")
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["balls.nrrd"])

    def test_an_output_that_was_there_survives_a_failure(self):
        self.path("out.vtu").write_text("precious")
        cleft("mesh", self.path("none.nrrd"), "-o", self.path("out.vtu"))
        self.assertEqual(self.path("out.vtu").read_text(), "precious")

    def test_report_of_a_failure(self):
        cleft("mesh", self.path("none.nrrd"), "-o", self.path("out.vtu"), "--json", self.path("r.json"))
        error = json.loads(self.path("r.json").read_text())["error"]
        self.assertEqual(error["exit_code"], CANNOT_READ)
        self.assertLess(error["status"], 0)
        self.assertIn("none.nrrd", error["message"])

    @unittest.skipIf(os.environ.get("SANITIZERS"), "sanitizers reserve more addresses than the limit allows")
    def test_out_of_memory(self):
        def little_memory():
            resource.setrlimit(resource.RLIMIT_AS, (600_000_000, 600_000_000))

        with open(self.path("large.raw"), "wb") as file:
            file.truncate(1000**3)
        done = cleft(
            "mesh",
            self.path("large.raw"),
            "--dims",
            1000,
            1000,
            1000,
            "-o",
            self.path("out.vtu"),
            "--threads",
            1,
            preexec_fn=little_memory,
        )
        self.assert_fails(OUT_OF_MEMORY, done, "memory")
        self.assertFalse(self.path("out.vtu").exists())


if __name__ == "__main__":
    unittest.main()
