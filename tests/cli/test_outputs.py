"""Outputs: all of a run or none, never in the place of an input, and never less than was said."""
import json
import os
import resource
import signal
import subprocess
import tempfile
import unittest

from support import CANNOT_WRITE, CLEFT, OK, USAGE, CommandTest, cleft

TETGEN = (".node", ".ele", ".face")


def limit_of_files(size):
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)  # Python ignores it, and children would, too
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        # The counters of a coverage build would be cut off, too, and every later run would complain of them.
        os.environ.update(GCOV_PREFIX="/dev/null", GCOV_ERROR_FILE="/dev/null")

    return limit


class Outputs(CommandTest):
    def setUp(self):
        super().setUp()
        self.bytes = self.volume.read_bytes()

    def assert_only(self, *names):
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), sorted((self.volume.name, *names)))
        self.assertEqual(self.volume.read_bytes(), self.bytes)

    def assert_refused(self, *arguments):
        before = {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        done = cleft(*arguments)
        self.assert_fails(USAGE, done)
        self.assertEqual(done.stderr.count("\n"), 1)
        self.assertEqual({path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}, before)

    def test_all_or_none(self):
        small, large, limit = self.path("small.vtu"), self.path("large.mesh"), 0
        for outputs in ((small, large), (large, small), (small, self.path("large.node"))):
            arguments = ["mesh", self.volume, "-q"] + [part for output in outputs for part in ("-o", output)]
            self.run_ok(*arguments)
            sizes = {path: path.stat().st_size for path in self.folder.iterdir() if path != self.volume}
            for path in sizes:
                path.unlink()
            limit = max(sizes.values()) - 1
            self.assertLess(sizes[small], limit)
            done = cleft(*arguments, preexec_fn=limit_of_files(limit))
            self.assert_fails(CANNOT_WRITE, done, "File too large", "'" + str(max(sizes, key=sizes.get)))
            self.assert_only()
        small.write_text("precious")
        small.chmod(0o640)
        done = cleft("mesh", self.volume, "-q", "-o", small, "-o", large, preexec_fn=limit_of_files(20000))
        self.assert_fails(CANNOT_WRITE, done)
        self.assertEqual(small.read_text(), "precious")
        self.run_ok(
            "mesh", self.volume, "-o", small, "-o", large, "-o", self.path("t.ele"), "--json", self.path("r.json")
        )
        self.assert_only("small.vtu", "large.mesh", "r.json", *("t" + extension for extension in TETGEN))
        self.assertEqual(small.stat().st_mode & 0o777, 0o640)
        for name in ("small.vtu", "large.mesh", "t.node"):
            self.run_ok("check", self.path(name))

    def test_the_report_is_one_of_them(self):
        for command in ("mesh", "sizing"):
            output = self.path({"mesh": "a.vtu", "sizing": "h.nrrd"}[command])
            for report in ("/dev/full", "-"):
                with open("/dev/full", "w") as full:
                    done = subprocess.run(
                        [CLEFT, command, self.volume, "-o", output, "--json", report],
                        stdout=full,
                        stderr=subprocess.PIPE,
                        text=True,
                    )
                self.assertEqual(done.returncode, CANNOT_WRITE)
                self.assertIn("No space left", done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1)
                self.assert_only()

    def test_standard_output_that_is_full_or_closed(self):
        commands = (
            ["mesh", self.volume, "-o", self.path("a.vtu")],
            ["info", self.volume],
            ["--help"],
            ["mesh", "--help"],
            ["--version"],
            ["sizing", self.volume, "-o", self.path("h.nrrd")],
        )
        for command in commands:
            with open("/dev/full", "w") as full:
                done = subprocess.run([CLEFT, *command], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual(done.returncode, CANNOT_WRITE, command)
            self.assertIn("standard output", done.stderr)
            done = subprocess.run([CLEFT, *command], stderr=subprocess.PIPE, preexec_fn=lambda: os.close(1))
            self.assertEqual(done.returncode, CANNOT_WRITE, command)
            self.assert_only()
        # the file must not be opened as standard output
        done = subprocess.run(
            [CLEFT, "mesh", self.volume, "-q", "-o", self.path("a.vtu")], preexec_fn=lambda: os.closerange(0, 3)
        )
        self.assertEqual(done.returncode, OK)
        self.run_ok("check", self.path("a.vtu"))

    def test_a_reader_that_goes_away_costs_no_mesh(self):
        reads, writes = os.pipe()
        os.close(reads)
        done = subprocess.run([CLEFT, "mesh", self.volume, "-o", self.path("a.vtu")], stdout=writes)
        os.close(writes)
        self.assertEqual(done.returncode, OK)
        self.assert_only("a.vtu")

    def test_an_output_that_is_an_input(self):
        v, mesh = self.volume, self.path("m.node")
        self.run_ok("mesh", v, "-o", mesh, "-o", self.path("m.vtu"))
        self.run_ok("sizing", v, "-o", self.path("h.vtk"))
        os.symlink(v.name, self.path("link.nrrd"))
        os.mkdir(self.path("d"))
        os.symlink("..", self.path("d/up"))
        for name in ("s1.nrrd", "s2.nrrd"):
            os.link(v, self.path(name))
        for arguments in (
            ("sizing", v, "-o", v),
            ("sizing", v, "-o", self.path("link.nrrd")),
            ("sizing", self.path("link.nrrd"), "-o", v),
            ("sizing", v, "-o", self.path("d/up/balls.nrrd")),
            ("sizing", self.path("s*.nrrd"), "-o", self.path("s2.nrrd")),
            ("sizing", self.path("s%02d.nrrd"), "-o", self.path("s1.nrrd")),
            ("mesh", self.path("h.vtk"), "--as", "indicators", "-o", self.path("h.vtk")),
            ("mesh", v, "--sizing", self.path("h.vtk"), "-o", self.path("h.vtk")),
            ("mesh", v, "--background", mesh, "-o", self.path("m.face")),
            ("convert", mesh, self.path("m.ele")),
            ("convert", self.path("m.vtu"), self.path("m.vtu")),
            ("mesh", v, "-o", self.path("a.vtu"), "--json", v),
            ("info", v, "--json", v),
            ("check", self.path("m.vtu"), "--json", self.path("m.vtu")),
            ("check", self.path("m.vtu"), "--json", self.path("m.face")),
        ):
            self.assert_refused(*arguments)

    def test_two_outputs_that_are_one_file(self):
        os.mkdir(self.path("d"))
        os.symlink("e.vtu", self.path("one.vtu"))
        os.symlink("e.vtu", self.path("two.vtu"))
        for first, second in (
            ("a.vtu", "a.vtu"),
            ("a.vtu", "d/../a.vtu"),
            ("a.node", "a.face"),
            ("one.vtu", "two.vtu"),
            ("one.vtu", "e.vtu"),
        ):
            self.assert_refused("mesh", self.volume, "-o", self.path(first), "-o", self.path(second))
        self.assert_refused("mesh", self.volume, "-o", self.path("a.vtu"), "--json", self.path("a.vtu"))

    def test_a_report_takes_the_place_of_a_report_alone(self):
        self.run_ok("info", self.volume, "--json", self.path("r.json"))
        self.run_ok("info", self.volume, "--json", self.path("r.json"))
        self.path("notes.txt").write_text("precious")
        self.assert_refused("info", self.volume, "--json", self.path("notes.txt"))

    def test_a_limit_on_the_size_of_files(self):
        for output in ("o.vtk", "o.node"):
            done = cleft("mesh", self.volume, "-q", "-o", self.path(output), preexec_fn=limit_of_files(8000))
            self.assert_fails(CANNOT_WRITE, done, "File too large")
            self.assert_only()
        done = cleft("info", self.volume, "-q", "--json", self.path("r.json"), preexec_fn=limit_of_files(0))
        self.assert_fails(CANNOT_WRITE, done, "File too large")
        self.assert_only()

    def test_links_stay_links(self):
        os.mkdir(self.path("d"))
        for link, target in (
            ("o.vtu", "target.vtu"),
            ("p.vtu", "d/p.vtu"),
            ("q.vtu", "o.vtu"),
            ("t.ele", "d/other.ele"),
        ):
            os.symlink(target, self.path(link))
            self.run_ok("mesh", self.volume, "-o", self.path(link))
            self.assertEqual(os.readlink(self.path(link)), target)
            self.run_ok("check", self.path(link))
        self.assert_only("o.vtu", "target.vtu", "d", "p.vtu", "q.vtu", *("t" + extension for extension in TETGEN))
        self.assertEqual(sorted(os.listdir(self.path("d"))), ["other.ele", "p.vtu"])
        os.symlink("r.vtu", self.path("r.vtu"))
        self.assert_fails(CANNOT_WRITE, cleft("mesh", self.volume, "-o", self.path("r.vtu")), "symbolic links")
        os.symlink("none/x.vtu", self.path("s.vtu"))
        self.assert_fails(CANNOT_WRITE, cleft("mesh", self.volume, "-o", self.path("s.vtu")), "No such file")

    def test_links_to_another_file_system(self):
        with tempfile.TemporaryDirectory(dir="/dev/shm") as other:
            if os.stat(other).st_dev == os.stat(self.folder).st_dev:
                self.skipTest("/dev/shm is no file system of its own")
            self.run_ok("mesh", self.volume, "-o", self.path("t.node"))
            expected = {name: self.path(name).read_bytes() for name in ("t.node", "t.ele", "t.face")}
            for link, target in (("t.face", "x.face"), ("t.node", "x.node")):
                self.path(link).unlink()
                os.symlink(os.path.join(other, target), self.path(link))
                self.run_ok("mesh", self.volume, "-o", self.path("t.node"))
                self.assertTrue(self.path(link).is_symlink())
                self.assertEqual({name: self.path(name).read_bytes() for name in expected}, expected)
            self.assert_only(*expected)
            self.assertEqual(sorted(os.listdir(other)), ["x.face", "x.node"])
            # A mesh that is there stays where the copy of another fails.
            sizes = [len(text) for text in expected.values()]
            done = cleft("mesh", self.volume, "-o", self.path("t.node"), preexec_fn=limit_of_files(min(sizes) - 1))
            self.assert_fails(CANNOT_WRITE, done, "File too large")
            self.assertEqual({name: self.path(name).read_bytes() for name in expected}, expected)

    def test_a_folder_in_the_way_of_a_file_beside(self):
        os.mkdir(self.path("t.face"))
        # The input is not there either: the output is looked at first.
        done = cleft("mesh", self.path("none.nrrd"), "-o", self.path("t.node"))
        self.assert_fails(CANNOT_WRITE, done, "t.face' is a folder")
        self.assert_only("t.face")

    def test_a_file_beside_that_links_to_no_folder(self):
        os.symlink("nowhere/x", self.path("t.face"))
        done = cleft("mesh", self.path("none.nrrd"), "-o", self.path("t.node"))
        self.assert_fails(CANNOT_WRITE, done, "t.face' cannot be written: no file can be made in the folder")
        self.assertTrue(self.path("t.face").is_symlink())

    def test_links_that_make_two_files_one(self):
        for link, target in (("a.ele", "a.face"), ("a.face", "a.ele"), ("a.node", "a.ele"), ("a.ele", "a.node")):
            os.symlink(target, self.path(link))
            done = cleft("mesh", self.volume, "-o", "a.node", cwd=self.folder)
            self.assert_fails(USAGE, done, f"two files of the output 'a.node' are one file: '{link}' is a link")
            self.path(link).unlink()
        self.path("a.ele").write_text("")
        os.link(self.path("a.ele"), self.path("a.face"))
        self.run_ok("mesh", self.volume, "-o", self.path("a.node"))
        self.run_ok("check", self.path("a.node"))

    def test_sentences_of_conflicts(self):
        os.symlink("a.vtu", self.path("b.vtu"))
        for outputs, sentence in (
            (("a.vtu", "a.vtu"), "the output 'a.vtu' is given twice"),
            (("a.vtu", "b.vtu"), "the outputs 'a.vtu' and 'b.vtu' are one file"),
            (("t.node", "t.ele"), "the outputs 't.node' and 't.ele' have one file: 't.ele'"),
        ):
            words = [part for output in outputs for part in ("-o", output)]
            done = cleft("mesh", self.volume, *words, cwd=self.folder)
            self.assert_fails(USAGE, done, sentence)
        self.assert_only("b.vtu")

    def test_what_is_no_regular_file_stays(self):
        os.mkfifo(self.path("f.vtu"))
        self.assert_fails(CANNOT_WRITE, cleft("mesh", self.volume, "-o", self.path("f.vtu")), "no regular file")
        self.assert_only("f.vtu")

    def test_names_as_long_as_names_can_be(self):
        for extension in (".vtu", ".mesh", ".face"):
            name = "x" * (255 - len(extension)) + extension
            self.run_ok("mesh", self.volume, "-o", self.path(name))
            self.run_ok("check", self.path(name.replace(".face", ".node")))
            self.path("y" * 250 + ".json").unlink(missing_ok=True)
            self.run_ok("info", self.path(name.replace(".face", ".node")), "--json", self.path("y" * 250 + ".json"))
            json.loads(self.path("y" * 250 + ".json").read_text())
            self.assert_fails(CANNOT_WRITE, cleft("mesh", self.volume, "-o", self.path("x" + name)), "too long")


if __name__ == "__main__":
    unittest.main()
