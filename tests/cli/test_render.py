"""cleft render draws a mesh as a picture."""
import json
import os
import struct
import unittest

from support import CANNOT_READ, CANNOT_WRITE, USAGE, CommandTest, cleft


class Render(CommandTest):
    def setUp(self):
        super().setUp()
        self.mesh(self.volume)
        self.input, self.output = self.path("out.vtu"), self.path("a.png")

    def render(self, *arguments):
        return self.run_ok("render", self.input, "-o", self.output, *arguments)

    def head(self):
        """Width, height and kind of the colours (2: red, green, blue; 6: with opacity)."""
        start = self.output.read_bytes()[:26]
        self.assertEqual(start[:8], b"\x89PNG\r\n\x1a\n")
        return struct.unpack(">IIxB", start[16:26])

    def test_a_picture(self):
        done = self.render()
        self.assertEqual(self.head(), (1200, 900, 2))
        self.assertIn("1200 x 900 pixels written to " + str(self.output), done.stdout)
        self.assertEqual(done.stderr, "")

    def test_options_change_the_picture(self):
        self.render("--size", "90x60")
        self.assertEqual(self.head(), (90, 60, 2))
        seen = {self.output.read_bytes()}
        for options in (
            "--cut x=0.5",
            "--cut x=0.5,y=0.5",
            "--cut x=0.5 --cut y=0.5 --cut z=0.5",
            "--cut x=0.5 --whole 3",
            "--strip 0",
            "--strip 0 3",
            "--by angle",
            "--by angle --range 20,40",
            "--by ratio",
            "--by size",
            "--view -1,0.5,2",
            "--view 1,1,1",
            "--view 1,1,1 --up 0,1,0",
            "--zoom 2",
            "--no-edges",
            "--line-width 3",
            "--legend",
            "--background dark",
            "--background none",
        ):
            self.render("--size", "90x60", *options.split())
            picture = self.output.read_bytes()
            self.assertNotIn(picture, seen, options)
            seen.add(picture)
        self.assertEqual(self.head(), (90, 60, 6))

    def test_threads_do_not_matter(self):
        pictures = set()
        for threads in 1, 2, 3:
            self.render("--size", "300x200", "--cut", "z=0.4", "--legend", "--threads", threads)
            pictures.add(self.output.read_bytes())
        self.assertEqual(len(pictures), 1)

    def test_report(self):
        done = self.render("--json", "-", "--size", "30x20")
        report = json.loads(done.stdout)
        self.assertEqual(
            (report["command"], report["inputs"], report["outputs"], report["width"], report["height"]),
            ("render", [str(self.input)], [str(self.output)], 30, 20),
        )
        self.assertEqual([stage["name"] for stage in report["stages"]], ["read", "render"])
        self.assertEqual(self.render("-q", "--size", "30x20").stdout, "")

    def test_unknown_labels_are_named(self):
        done = self.render("--strip", "77", "--size", "30x20")
        self.assertIn("warning: strip names label 77, which the mesh does not have", done.stderr)

    def test_mistakes_of_usage(self):
        for options, words in (
            ("--cut w=0.5", ["--cut", "w=0.5"]),
            ("--cut x", ["--cut", "AXIS=SHARE"]),
            ("--cut x=", ["--cut", "AXIS=SHARE"]),
            ("--cut x=1.5", ["--cut", "0 to 1"]),
            ("--cut x=nan", ["--cut", "0 to 1"]),
            ("--cut x=0.5,x=0.6", ["--cut", "two cuts"]),
            ("--size 12", ["--size", "WIDTHxHEIGHT"]),
            ("--size 0x12", ["--size", "1 to 8192"]),
            ("--size 9000x12", ["--size", "1 to 8192"]),
            ("--size 3x4x5", ["--size", "WIDTHxHEIGHT"]),
            ("--view 1,2", ["--view", "X,Y,Z"]),
            ("--up 1,2,z", ["--up", "X,Y,Z"]),
            ("--range 1", ["--range", "LOW,HIGH"]),
            ("--range 1,2", ["--range", "--by angle"]),
            ("--range 2,1 --by size", ["--range", "'2,1'", "less than"]),
            ("--range 0,0 --by size", ["--range", "'0,0'", "less than"]),
            ("--view nan,1,1", ["--view", "X,Y,Z"]),
            ("--view 0,0,0", ["--view", "no direction"]),
            ("--up 0,0,0", ["--up", "no direction"]),
            ("--view 0,0,1 --up 0,0,2", ["up of the picture"]),
            ("--zoom 51", ["cleft render: --zoom: '51'", "(above 0, at most 50)"]),
            ("--zoom 0", ["--zoom: '0'", "(above 0, at most 50)"]),
            ("--line-width -1", ["--line-width: '-1'", "(above 0, at most 100)"]),
            ("--by colour", ["--by"]),
            ("--background red", ["--background"]),
            ("--strip 0 3 7", ["the picture would be empty"]),
        ):
            done = cleft("render", self.input, "-o", self.output, *options.split())
            self.assert_fails(USAGE, done, *words)
            self.assertFalse(self.output.exists(), options)
        self.assert_fails(USAGE, cleft("render", self.input), "--output")

    def test_outputs_are_looked_at_first(self):
        for path, exit_code in (
            (self.path("a.jpg"), CANNOT_WRITE),
            (self.path("none/a.png"), CANNOT_WRITE),
            (self.folder, CANNOT_WRITE),
        ):
            done = cleft("render", self.path("none.vtu"), "-o", path)
            self.assert_fails(exit_code, done, path)
        self.assert_fails(CANNOT_READ, cleft("render", self.path("none.vtu"), "-o", self.output), "none.vtu")
        os.link(self.input, self.path("b.png"))
        self.assert_fails(USAGE, cleft("render", self.input, "-o", self.path("b.png")))
        done = cleft("render", self.input, "-o", self.output, "--json", self.output)
        self.assert_fails(USAGE, done)
        self.assertFalse(self.output.exists())


if __name__ == "__main__":
    unittest.main()
