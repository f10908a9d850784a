"""The command cleft-mpi, as its users meet it: files, failures of one rank, and the ends of ranks."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

COMMAND, MPIRUN, FILES, CLEFT = sys.argv[1:5]
VOLUME = f"{FILES}/volume.h5"


def rounded(value):
    """Sums of parts differ in the last digits."""
    return round(value, 9) if isinstance(value, float) else value


class Command(unittest.TestCase):
    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = pathlib.Path(made.name)

    def start(self, ranks, script):
        """Runs a shell script on each rank; $R is its number, and "$C" the command."""
        script = f'R=$OMPI_COMM_WORLD_RANK; C="{COMMAND}"; cd "{self.folder}"; {script}'
        return subprocess.Popen(
            [MPIRUN, "-n", str(ranks), "sh", "-c", script],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def run_ranks(self, ranks, script):
        process = self.start(ranks, script)
        out, errors = process.communicate()
        return process.returncode, out, [line for line in errors.splitlines() if line.startswith("cleft")]

    def names(self):
        return {path.name for path in self.folder.iterdir() if not path.name.startswith("pid.")}

    def test_help_and_version(self):
        for words, said in ((["--help"], "Usage: cleft-mpi"), (["mesh", "--help"], "--dataset"), (["--version"], "0.")):
            done = subprocess.run([COMMAND, *words], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(said, done.stdout)

    def test_a_mesh(self):
        for ranks in (1, 3):
            code, out, errors = self.run_ranks(
                ranks, f"$C mesh {VOLUME} -o a.vtkhdf -o a.pvtu -o a.mfem --ghosts --threads 2"
            )
            alone = (
                "cleft-mpi: warning: the first rank makes the whole mesh alone, since block is 0 or more than half of "
                "the planes"
            )
            self.assertEqual((code, errors), (0, [alone] if ranks > 1 else []))
            # One rank prints.
            self.assertEqual(out.count("Mesh "), 1)
            self.assertIn(f"in {ranks} part", out)
            self.assertEqual(out.count("Angles "), 1)
            self.assertEqual((self.folder / "a.vtkhdf").read_bytes(), pathlib.Path(FILES, "1.vtkhdf").read_bytes())
        pieces = {name for rank in range(3) for name in (f"a_000{rank}.vtu", f"a.mfem.00000{rank}")}
        self.assertEqual(self.names(), {"a.vtkhdf", "a.pvtu", *pieces})

    def test_blocks_that_ranks_share(self):
        given = self.write_layers()
        meshes = set()
        for ranks in (1, 2, 5):
            # Some of the runs keep slabs in files.
            scratch = "--scratch ." if ranks > 1 else ""
            self.assertEqual(self.run_ranks(ranks, f"$C {given} {scratch} -o {ranks}.vtkhdf")[::2], (0, []))
            meshes.add((self.folder / f"{ranks}.vtkhdf").read_bytes())
        self.assertEqual(len(meshes), 1)
        # `cleft` reads the file, and makes the same mesh.
        for words in (
            [*given.split(), "-o", "one.vtu"],
            ["convert", "5.vtkhdf", "five.vtu"],
            ["check", "5.vtkhdf"],
            ["info", "5.vtkhdf"],
        ):
            done = subprocess.run([CLEFT, *words, "--quiet"], cwd=self.folder, capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(*((self.folder / name).read_bytes() for name in ("one.vtu", "five.vtu")))
        for name in ("one.vtu", "five.vtu"):
            (self.folder / name).unlink()
        self.assertEqual(self.names(), {"a.raw", "1.vtkhdf", "2.vtkhdf", "5.vtkhdf"})

    def cleft(self, *words):
        done = subprocess.run([CLEFT, *words, "--quiet"], cwd=self.folder, capture_output=True, text=True)
        return done.returncode, done.stderr

    def test_cleft_reads_pieces(self):
        given = self.write_layers()
        self.assertEqual(self.cleft(*given.split(), "-o", "one.vtu"), (0, ""))
        for ranks, ghosts in ((1, ""), (2, "--ghosts"), (5, "")):
            self.assertEqual(self.run_ranks(ranks, f"$C {given} {ghosts} -o a.pvtu -o a.mfem")[::2], (0, []))
            self.assertEqual(self.cleft("convert", "a.pvtu", "a.vtu"), (0, ""))
            self.assertEqual(*((self.folder / name).read_bytes() for name in ("one.vtu", "a.vtu")))
        for command in ("info", "check"):
            self.assertEqual(self.cleft(command, "a.pvtu"), (0, ""))
            code, said = self.cleft(command, "a.mfem.000000")
            self.assertEqual(code, 3)
            self.assertIn("it is a mesh of MFEM, which cannot be read: have cleft-mpi write .vtkhdf or .pvtu", said)

    def write_layers(self):
        """A small volume of three labels, and the options that cut it into five blocks."""
        (self.folder / "a.raw").write_bytes(bytes(1 + (i % 8 > 3) + (i // 640 % 3) for i in range(8 * 8 * 30)))
        return "mesh a.raw --dims 8 8 30 --background octree --block 6"

    def test_memory_is_bounded(self):
        words = self.write_layers().replace("--block 6", "")
        refused = {
            "4X": "--memory: '4X' is no size: give a number and K, M, G or T, such as 4G",
            "-1G": "--memory: '-1G' is no size: give a number and K, M, G or T, such as 4G",
        }
        for size, sentence in refused.items():
            code, _, errors = self.run_ranks(2, f"$C {words} --memory={size} -o a.vtkhdf")
            self.assertEqual((code, errors), (2, [f"cleft-mpi mesh: {sentence}"]))
        code, _, errors = self.run_ranks(2, f"$C {words} --memory 10M -o a.vtkhdf")
        self.assertEqual((code, len(errors)), (2, 1), errors)
        self.assertIn("cleft-mpi mesh: --memory 10M is too little for slabs of 8 planes of this volume", errors[0])
        code, _, errors = self.run_ranks(2, f"$C {words} --memory 2G -o bounded.vtkhdf")
        chosen = "--memory 2G has the mesh made in slabs of 8 planes: it is that of --block 8"
        self.assertEqual((code, errors), (0, [f"cleft-mpi: warning: {chosen}"]))
        self.assertEqual(self.run_ranks(3, f"$C {words} --block 8 -o free.vtkhdf")[::2], (0, []))
        # Slabs that were asked for, or that nobody would make, are not chosen again.
        for more in ("--block 0", "--tets 900"):
            code, _, errors = self.run_ranks(1, f"$C {words} --memory 2G {more} -o whole.vtkhdf")
            self.assertEqual((code, [line for line in errors if "slabs" in line]), (0, []))
        (self.folder / "whole.vtkhdf").unlink()
        self.assertEqual(*((self.folder / f"{name}.vtkhdf").read_bytes() for name in ("bounded", "free")))
        # Nothing stays beside the output.
        self.assertEqual(self.names(), {"a.raw", "bounded.vtkhdf", "free.vtkhdf"})

    def test_ranks_share_without_being_asked(self):
        """A volume that is thick enough: the slabs follow from it, and a sentence says which they are."""
        (self.folder / "a.raw").write_bytes(bytes(1 + (i % 8 > 3) + (i // 1280 % 3) for i in range(8 * 8 * 70)))
        words = "mesh a.raw --dims 8 8 70 --background octree"
        shared = (
            "cleft-mpi: warning: ranks share slabs of 32 planes: the mesh is that of --block 32; --block 0 has the "
            "first rank make it as a whole"
        )
        for ranks in (1, 3):
            code, _, errors = self.run_ranks(ranks, f"$C {words} -o {ranks}.vtkhdf")
            self.assertEqual((code, errors), (0, [shared]))
        self.assertEqual(self.run_ranks(2, f"$C {words} --block 32 -o asked.vtkhdf")[::2], (0, []))
        meshes = {(self.folder / f"{name}.vtkhdf").read_bytes() for name in ("1", "3", "asked")}
        self.assertEqual(len(meshes), 1)
        for more, why in (
            ("--block 0", "block is 0 or more than half of the planes"),
            ("--tets 900", "tets asks for a number"),
        ):
            code, _, errors = self.run_ranks(2, f"$C {words} {more} -o whole.vtkhdf")
            self.assertEqual(code, 0)
            self.assertIn(f"cleft-mpi: warning: the first rank makes the whole mesh alone, since {why}", errors)
            self.assertNotIn((self.folder / "whole.vtkhdf").read_bytes(), meshes)

    def report_of(self, name):
        return json.loads((self.folder / name).read_text())

    def test_reports(self):
        words = self.write_layers()
        alone = subprocess.run(
            [CLEFT, *words.split(), "-o", "one.vtu", "--json", "one.json"], cwd=self.folder, capture_output=True
        )
        self.assertEqual(alone.returncode, 0)
        expected = self.report_of("one.json")
        for ranks in (1, 3):
            self.assertEqual(self.run_ranks(ranks, f"$C {words} -o a.vtkhdf --json a.json")[::2], (0, []))
            report = self.report_of("a.json")
            self.assertEqual(
                (report["program"], report["command"], report["outputs"]), ("cleft-mpi", "mesh", ["a.vtkhdf"])
            )
            self.assertEqual(report["options"]["block"], 6)
            for field in ("dims", "spacing", "affine", "voxels"):
                self.assertEqual(report["volume"][field], expected["volume"][field])
            for field in ("points", "tets", "interface_triangles", "hull_triangles", "low", "high"):
                self.assertEqual(report["mesh"][field], expected["mesh"][field], field)
            for row, wanted in zip(report["mesh"]["labels"], expected["mesh"]["labels"], strict=True):
                self.assertEqual((row["label"], row["tets"]), (wanted["label"], wanted["tets"]))
                self.assertAlmostEqual(row["volume"], wanted["volume"], 9)
            self.assertEqual(report["volume"]["labels"], expected["volume"]["labels"])
            self.assertEqual(list(report["quality"]), list(expected["quality"]))
            for field, value in report["quality"].items():
                self.assertEqual(rounded(value), rounded(expected["quality"][field]), field)
            for row, wanted in zip(report["labels"], expected["labels"], strict=True):
                self.assertEqual({"mesh_components", "large_components"} & set(row), set())
                for field, value in row.items():
                    self.assertEqual(rounded(value), rounded(wanted[field]), field)
            self.assertEqual(len(report["ranks"]), ranks)
            self.assertEqual(sum(rank["mesh"]["tets"] for rank in report["ranks"]), expected["mesh"]["tets"])
            for rank in report["ranks"]:
                self.assertGreater(rank["peak_bytes"], 1e6)
                self.assertEqual(rank["sent"]["bytes"], sum(work["bytes"] for work in rank["sent"]["work"]))
                self.assertEqual(rank["sent"]["bytes"] > 0, ranks > 1)
                self.assertEqual(rank["sent"]["messages"] > 0, ranks > 1)
        # To standard output, instead of the summary.
        out = self.run_ranks(2, f"$C {words} -o a.vtkhdf --json -")[1]
        self.assertEqual(json.loads(out)["mesh"]["tets"], expected["mesh"]["tets"])

    def test_reports_of_failures(self):
        code, _, errors = self.run_ranks(2, "$C mesh no.h5 -o a.pvtu --json a.json")
        self.assertEqual((code, len(errors)), (3, 1))
        self.assertEqual(self.names(), {"a.json"})
        self.assertEqual(self.report_of("a.json")["program"], "cleft-mpi")
        self.assertEqual(self.report_of("a.json")["error"]["exit_code"], 3)
        (self.folder / "a.json").unlink()
        words = self.write_layers()
        code, _, errors = self.run_ranks(2, f"$C {words} -o a.vtkhdf --json no/a.json")
        self.assertEqual((code, len(errors)), (4, 1), errors)
        # The report of a refusal does not replace what was refused.
        volume = (self.folder / "a.raw").read_bytes()
        self.assertEqual(self.run_ranks(2, f"$C {words} -o a.vtkhdf --json a.raw")[0], 2)
        self.assertEqual((self.folder / "a.raw").read_bytes(), volume)
        self.assertEqual(self.names(), {"a.raw"})

    def test_raw_voxels_and_headers(self):
        labels = bytes(1 + (i % 8 > 3) for i in range(8 * 6 * 5))
        (self.folder / "a.raw").write_bytes(labels)
        # The corner of raw voxels is at the origin.
        head = "NDims = 3\nDimSize = 8 6 5\nElementType = MET_UCHAR\nElementSpacing = 1 1 1\nOffset = 0.5 1 0.25\n"
        (self.folder / "a.mha").write_bytes(head.encode() + b"ElementDataFile = LOCAL\n" + labels)
        spaced = "--spacing 1 2 0.5 --background lattice -o"
        self.assertEqual(self.run_ranks(2, f"$C mesh a.raw --dims 8 6 5 {spaced} raw.vtkhdf")[0], 0)
        self.assertEqual(self.run_ranks(1, f"$C mesh a.mha {spaced} mha.vtkhdf")[0], 0)
        self.assertEqual(*((self.folder / f"{name}.vtkhdf").read_bytes() for name in ("raw", "mha")))

    def assert_fails(self, code, sentence, script):
        found, out, errors = self.run_ranks(3, script)
        self.assertEqual((found, out), (code, ""), errors)
        alone = "cleft-mpi: warning: the first rank makes the whole mesh"
        errors = [line for line in errors if not line.startswith(alone)]
        self.assertEqual(len(errors), 1, errors)
        self.assertTrue(errors[0].startswith("cleft-mpi"), errors)
        self.assertIn(sentence, errors[0])
        self.assertEqual(self.names(), set())

    def test_failures_are_one_sentence(self):
        self.assert_fails(3, "mesh: cannot read 'no.h5': No such file", "$C mesh no.h5 -o a.pvtu")
        one = f"if [ $R = 1 ]; then V=no.h5; else V={VOLUME}; fi; $C mesh $V -o a.pvtu"
        self.assert_fails(3, "mesh: rank 1: cannot read 'no.h5'", one)
        other = f"if [ $R = 2 ]; then S=2; else S=3; fi; $C mesh {VOLUME} --size $S -o a.vtkhdf"
        self.assert_fails(5, "the ranks do not give the same volume, options and ghosts", other)
        self.assert_fails(2, "'a.vtu' ends with none of .vtkhdf .hdf .pvtu .mfem", f"$C mesh {VOLUME} -o a.vtu")
        missing = "'no/a.pvtu' cannot be written: no file can be made in the folder 'no': No such file"
        self.assert_fails(4, missing, f"$C mesh {VOLUME} -o no/a.pvtu")

    def test_a_rank_that_cannot_write(self):
        # 100 blocks of 512 bytes: the shell's limit, beyond which the system refuses.
        limited = f"if [ $R = 1 ]; then ulimit -f 100; fi; exec $C mesh {VOLUME} --size 0.5 -o "
        self.assert_fails(4, "rank 1: cannot write 'a_0001.vtu': File too large", limited + "a.pvtu")
        self.assert_fails(4, "rank 1: cannot write './a.vtkhdf': File too large", limited + "./a.vtkhdf")
        # The first rank makes the file with room for all rows.
        words = f"$C mesh {VOLUME} --size 0.5 -o ./a.vtkhdf"
        first = f"if [ $R = 0 ]; then ulimit -f 100; fi; exec {words}"
        self.assert_fails(4, "rank 0: cannot write './a.vtkhdf': File too large", first)
        self.assert_fails(4, "cannot write './a.vtkhdf': File too large", f"ulimit -f 100; exec {words}")

    def test_a_scratch_file_that_cannot_be_written(self):
        """An output for the code, of one rank or of all: the voxels can be read."""
        words = f"exec $C {self.write_layers()} -o a.vtkhdf --scratch"
        missing = "cannot make a scratch file in 'no': No such file"
        full = "cannot write a scratch file in '.': File too large"
        for ranks, script, sentence in (
            (1, f"{words} no", missing),
            (3, f"{words} no", missing),
            (3, f"if [ $R = 1 ]; then S=no; else S=.; fi; {words} $S", missing),
            (3, f"ulimit -f 1; {words} .", full),
            (3, f"if [ $R = 1 ]; then ulimit -f 1; fi; {words} .", full),
        ):
            code, out, errors = self.run_ranks(ranks, script)
            self.assertEqual((code, out, len(errors)), (4, "", 1), errors)
            self.assertIn(sentence, errors[0])
            self.assertEqual(self.names(), {"a.raw"})

    def test_pieces_are_outputs(self):
        """What would be lost to a piece is refused before the work: a folder, the input, the report."""
        words = f"$C {self.write_layers()}"
        for piece, output in (("m_0001.vtu", "m.pvtu"), ("m.mfem.000000", "m.mfem")):
            (self.folder / piece).mkdir()
            (self.folder / piece / "kept").touch()
            code, _, errors = self.run_ranks(2, f"{words} -o {output}")
            self.assertEqual((code, len(errors)), (4, 1), errors)
            self.assertIn(f"'{piece}' is a folder", errors[0])
            self.assertTrue((self.folder / piece / "kept").exists())
            (self.folder / piece / "kept").unlink()
            (self.folder / piece).rmdir()
            code, _, errors = self.run_ranks(2, f"{words} -o {output} --json {piece}")
            both = f"the outputs '{output}' and '{piece}' have one file: '{piece}'"
            self.assertEqual((code, errors), (2, [f"cleft-mpi mesh: {both}"]))
            (self.folder / "a.raw").rename(self.folder / piece)
            code, _, errors = self.run_ranks(2, f"{words.replace('a.raw', piece)} -o {output}")
            self.assertEqual(code, 2)
            input = f"the file '{piece}' of the output '{output}' is the input '{piece}', or a file of it"
            self.assertIn(input, errors[0])
            (self.folder / piece).rename(self.folder / "a.raw")
        self.assertEqual(self.names(), {"a.raw"})

    def test_links_of_pieces(self):
        """A link may not have two files of one output be one, and one to itself is no place for a file."""
        words = f"$C {self.write_layers()}"
        for output, link, target, code, sentence in (
            ("m.pvtu", "m_0000.vtu", "m_0001.vtu", 2, "two files of the output 'm.pvtu' are one file"),
            ("m.pvtu", "m_0001.vtu", "m.pvtu", 2, "two files of the output 'm.pvtu' are one file"),
            ("m.mfem", "m.mfem.000000", "m.mfem.000001", 2, "two files of the output 'm.mfem' are one file"),
            ("m.pvtu", "m_0001.vtu", "m_0001.vtu", 4, "'m_0001.vtu' cannot be written: Too many levels"),
            ("m.pvtu", "m.pvtu", "m.pvtu", 4, "'m.pvtu' cannot be written: Too many levels"),
        ):
            (self.folder / link).symlink_to(target)
            found, _, errors = self.run_ranks(2, f"{words} -o {output}")
            self.assertEqual((found, len(errors)), (code, 1), errors)
            self.assertIn(sentence, errors[0])
            self.assertIn(f"'{link}' ", errors[0])
            self.assertEqual(self.names(), {"a.raw", link})
            (self.folder / link).unlink()
        code, _, errors = self.run_ranks(2, f"{words} -o {'a' * 248}.pvtu")
        self.assertEqual((code, len(errors)), (4, 1), errors)
        self.assertIn(".vtu' cannot be written: File name too long", errors[0])

    def test_links_to_another_file_system(self):
        with tempfile.TemporaryDirectory(dir="/dev/shm") as other:
            if os.stat(other).st_dev == os.stat(self.folder).st_dev:
                self.skipTest("/dev/shm is no file system of its own")
            plain = self.write_layers()
            self.assertEqual(self.run_ranks(2, f"$C {plain} -o m.pvtu")[::2], (0, []))
            bytes_of = {name: (self.folder / name).read_bytes() for name in ("m.pvtu", "m_0000.vtu", "m_0001.vtu")}
            (self.folder / "m_0001.vtu").unlink()
            (self.folder / "m_0001.vtu").symlink_to(pathlib.Path(other) / "p.vtu")
            names = self.names()
            self.assertEqual(self.run_ranks(2, f"$C {plain} -o m.pvtu")[::2], (0, []))
            self.assertEqual((self.names(), os.listdir(other)), (names, ["p.vtu"]))
            self.assertTrue((self.folder / "m_0001.vtu").is_symlink())
            for name, expected in bytes_of.items():
                self.assertEqual((self.folder / name).read_bytes(), expected)

    def test_outputs_and_reports_are_all_or_none(self):
        words = f"$C {self.write_layers()}"
        (self.folder / "m.vtkhdf").write_text("old")
        for report in ("--json /dev/full", "--json - > /dev/full", "> /dev/full"):
            script = f"{words} -o m.vtkhdf -o m.pvtu {report}"
            done = subprocess.run(
                ["sh", "-c", f'C="{COMMAND}"; cd "{self.folder}"; {script}'], capture_output=True, text=True
            )
            self.assertEqual(done.returncode, 4, done.stderr)
            self.assertIn("No space left on device", done.stderr)
            self.assertEqual((self.folder / "m.vtkhdf").read_text(), "old")
            self.assertEqual(self.names(), {"a.raw", "m.vtkhdf"})

    def test_pieces_of_more_ranks_stay(self):
        words = f"$C {self.write_layers()} -o m.pvtu"
        self.assertEqual(self.run_ranks(3, words)[::2], (0, []))
        said = "'m_0002.vtu' is of another run with more ranks: it stays, and is no part of 'm.pvtu'"
        self.assertEqual(self.run_ranks(2, words)[::2], (0, [f"cleft-mpi: warning: {said}"]))
        self.assertTrue((self.folder / "m_0002.vtu").exists())

    def test_links_are_followed(self):
        words = f"$C {self.write_layers()}"
        (self.folder / "there").mkdir()
        (self.folder / "m.pvtu").symlink_to("there/n.pvtu")
        (self.folder / "m.vtkhdf").symlink_to("there/other")
        self.assertEqual(self.run_ranks(2, f"{words} -o m.pvtu -o m.vtkhdf")[::2], (0, []))
        self.assertEqual(
            {path.name for path in (self.folder / "there").iterdir()},
            {"n.pvtu", "n_0000.vtu", "n_0001.vtu", "other"},
        )
        self.assertEqual(self.names(), {"a.raw", "there", "m.pvtu", "m.vtkhdf"})
        self.assertEqual(self.cleft("check", "m.vtkhdf"), (0, ""))
        self.assertEqual(self.cleft("check", "there/n.pvtu"), (0, ""))

    def start_long(self, more=""):
        words = f"mesh {VOLUME} --size 0.1 -o a.vtkhdf --progress lines {more}"
        process = self.start(3, f"echo $$ > pid.$R; exec $C {words}")
        # It works when it says how far it is.
        while "%" not in (line := process.stderr.readline()):
            self.assertIsNone(process.poll())
        self.assertTrue(line.startswith("cleft-mpi: "), line)
        return process

    def test_a_rank_that_is_killed_ends_all(self):
        process = self.start_long()
        os.kill(int((self.folder / "pid.2").read_text()), signal.SIGKILL)
        process.communicate()
        self.assertNotEqual(process.returncode, 0)
        self.assertEqual(self.names(), set())

    def test_a_signal_to_one_rank_has_its_code(self):
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            # Each rank has work of its own.
            process = self.start_long("--block 4 --background lattice")
            os.kill(int((self.folder / "pid.1").read_text()), number)
            errors = process.communicate()[1]
            self.assertEqual(process.returncode, 128 + number, errors)
            self.assertIn("cleft-mpi mesh: stopped by a signal; nothing was written", errors)
            self.assertEqual(self.names(), set())

    def test_a_signal_while_the_ranks_begin(self):
        for number, wait in ((signal.SIGTERM, 0), (signal.SIGHUP, 0.1), (signal.SIGTERM, 0.15), (signal.SIGHUP, 0.2)):
            process = self.start(3, f"echo $$ > pid.$R; exec $C mesh {VOLUME} --size 0.1 -o a.vtkhdf")
            pid = self.folder / "pid.1"
            while not (pid.exists() and pid.read_text()):
                time.sleep(0.001)
            time.sleep(wait)
            os.kill(int(pid.read_text()), number)
            errors = process.communicate()[1]
            self.assertEqual(process.returncode, 128 + number, errors)
            self.assertEqual(self.names(), set())
            pid.unlink()

    def test_a_stopped_run_leaves_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.start_long()
            process.send_signal(number)
            process.communicate()
            self.assertNotEqual(process.returncode, 0)
            self.assertEqual(self.names(), set())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
