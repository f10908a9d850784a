"""Options: their names, defaults and ranges are those of the library."""
import pydoc
import unittest
import warnings

import numpy as np

import cleft
from support import ball_mesh, ball_volume


class OptionsTest(unittest.TestCase):
    def test_defaults_are_those_of_the_table(self):
        options = cleft.Options()
        for row in cleft.option_table():
            self.assertEqual(getattr(options, row.name), row.default)
            self.assertTrue(row.text)

    def test_help_lists_the_options(self):
        for what in (cleft.mesh, cleft.Options):
            text = pydoc.plain(pydoc.render_doc(what))
            for row in cleft.option_table():
                line = next(line for line in text.splitlines() if line.strip(" |").startswith(f"{row.name} : "))
                self.assertIn(f"= {row.default!r}", line)
                self.assertIn(row.text.split()[0], text)
            for name in ("label_sizes", "strip", "only"):
                self.assertIn(f"{name} : ", text)
            self.assertIn("gradation : float = 0.3, 0.01 to 1\n", text)
            self.assertIn("snap : 'quality', 'safe', 'none' = 'quality'\n", text)

    def test_every_option_is_a_keyword(self):
        names = {row.name for row in cleft.option_table()} | {"label_sizes", "strip", "only"}
        self.assertEqual(names, set(cleft.OptionKeywords.__annotations__))
        types = {"integer": "int", "real": "float", "choice": "str", "flag": "bool"}
        for row in cleft.option_table():
            annotation = cleft.OptionKeywords.__annotations__[row.name]
            self.assertEqual(getattr(annotation, "__forward_arg__", annotation), types[row.type])

    def test_values_are_kept(self):
        options = cleft.Options(size=2, background="octree", tets=1e6, strict=True, strip=[0, 5], label_sizes={3: 0.5})
        self.assertEqual(
            (options.size, options.background, options.tets, options.strict), (2.0, "octree", 10**6, True)
        )
        self.assertEqual((options.strip, options.label_sizes), ((0, 5), {3: 0.5}))
        options.size = 4
        options.set_text("background", "lattice")
        self.assertEqual(eval(repr(options), {"Options": cleft.Options}).background, "lattice")
        self.assertEqual(options.size, 4.0)
        self.assertIn("size", dir(options))

    def test_values_of_numpy(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            options = cleft.Options(
                strict=np.bool_(True),
                size=np.float32(2),
                steps=np.int8(3),
                strip=np.array([1]),
                label_sizes={np.int64(4): np.float64(0.5)},
            )
        self.assertEqual((options.strict, options.size, options.steps), (True, 2.0, 3))
        self.assertEqual((options.strip, options.label_sizes), ((1,), {4: 0.5}))

    def test_greatest_and_least(self):
        for row in cleft.option_table():
            if row.type in ("real", "integer"):
                kind = float if row.type == "real" else int
                options = cleft.Options(**{row.name: kind(row.greatest)})
                self.assertEqual(getattr(options, row.name), row.greatest)
                with self.assertRaises(cleft.OptionError) as raised:
                    setattr(options, row.name, kind(row.least) - 1)
                self.assertIn(row.name, str(raised.exception))
                self.assertEqual(getattr(options, row.name), row.greatest)

    def test_wrong_values(self):
        for values in (
            {"size": float("nan")},
            {"size": float("inf")},
            {"background": "rug"},
            {"smooth": 99},
            {"label_sizes": {1: -1}},
            {"label_sizes": {1: float("nan")}},
        ):
            with self.assertRaises(ValueError):
                cleft.Options(**values)
        for values in (
            {"colour": 1},
            {"size": None},
            {"size": "2"},
            {"size": [1.0, 2.0]},
            {"background": 3},
            {"steps": 1.5},
            {"steps": "many"},
            {"strip": 3},
            {"strip": ["a"]},
            {"strict": None},
            {"strict": "yes"},
            {"strict": 2},
            {"label_sizes": [1, 2]},
            {"label_sizes": {"a": 1}},
            {"label_sizes": {1: "a"}},
        ):
            with self.assertRaisesRegex(TypeError, next(iter(values))):
                cleft.Options(**values)
        for values in (
            {"strip": [2**31]},
            {"only": [-(2**31) - 1]},
            {"steps": 2**70},
            {"label_sizes": {2**40: 1.0}},
        ):
            with self.assertRaises(OverflowError):
                cleft.Options(**values)
        with self.assertRaises(TypeError):
            cleft.mesh(ball_volume(), options=cleft.Options(), size=1)
        with self.assertRaises(TypeError):
            cleft.mesh(ball_volume(), colour=1)
        with self.assertRaises(AttributeError):
            cleft.Options().colour
        with self.assertRaises(AttributeError):
            cleft.Options().colour = 1

    def test_strip_and_only(self):
        self.assertEqual(ball_mesh(strip=[0]).different_labels.tolist(), [1, 7])
        self.assertEqual(ball_mesh(only=(1,)).different_labels.tolist(), [1])

    def test_label_sizes_can_be_taken_back(self):
        options = cleft.Options(background="lattice", label_sizes={1: 0.8})
        volume = ball_volume()
        fine = len(cleft.mesh(volume, options=options).tets)
        options.label_sizes = {}
        self.assertLess(len(cleft.mesh(volume, options=options).tets), fine)

    def test_closed(self):
        options = cleft.Options()
        options.close()
        self.assertEqual(repr(options), "Options(closed)")
        with self.assertRaises(cleft.Closed):
            options.size = 1
        with self.assertRaises(cleft.Closed):
            cleft.mesh(ball_volume(), options=options)


if __name__ == "__main__":
    unittest.main()
