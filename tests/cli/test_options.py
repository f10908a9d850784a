"""Bad values are refused before the work, and the message names the option."""
import unittest

from support import USAGE, CommandTest, cleft


class Options(CommandTest):
    def assert_refused(self, option, *values):
        done = cleft("mesh", self.volume, "-o", self.path("out.vtu"), option, *values)
        self.assert_fails(USAGE, done, option)
        self.assertFalse(self.path("out.vtu").exists())

    def test_numbers_out_of_range(self):
        self.assert_refused("--gradation", "7")
        self.assert_refused("--size", "-1")
        self.assert_refused("--feature-scale", "0")
        self.assert_refused("--tets", "-5")
        self.assert_refused("--threads", "-1")
        self.assert_refused("--threads", "5000")
        self.assert_refused("--smooth", "99")

    def test_no_numbers(self):
        self.assert_refused("--size", "small")
        self.assert_refused("--size", "nan")
        self.assert_refused("--size-max", "inf")
        self.assert_refused("--tets", "1.5")
        self.assert_refused("--size", "")

    def test_choices(self):
        self.assert_refused("--improve", "nicely")
        self.assert_refused("--snap", "")
        self.assert_refused("--background", "no-such-thing")
        self.assert_refused("--world", "asr")

    def test_labels(self):
        self.assert_refused("--label-size", "3")
        self.assert_refused("--label-size", "3=-1")
        self.assert_refused("--label-size", "3=0")
        self.assert_refused("--label-size", "three=1")
        self.assert_refused("--strip", "skin")
        self.assert_refused("--only", "99999999999")

    def test_raw_layout(self):
        self.assert_refused("--dims", "16,16")
        self.assert_refused("--dims", "16", "0", "16")
        self.assert_refused("--type", "int7")
        self.assert_refused("--spacing", "1", "-1", "1")

    def test_output_is_required(self):
        self.assert_fails(USAGE, cleft("mesh", self.volume), "--output")


if __name__ == "__main__":
    unittest.main()
