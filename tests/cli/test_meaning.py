"""What the voxels mean: labels, masks or functions. What is not certain is refused or reported."""

import json
import math
import unittest

from support import CANNOT_READ, CommandTest, cleft, write_nrrd

N = 20
VOXELS = [(x - 9.5, y - 9.5, z - 9.5) for z in range(N) for y in range(N) for x in range(N)]
RADII = [(x * x + y * y + z * z) ** 0.5 for x, y, z in VOXELS]
LEFT = [int(r < 6 and v[0] < 0) for r, v in zip(RADII, VOXELS)]
RIGHT = [int(r < 6 and v[0] > 0) for r, v in zip(RADII, VOXELS)]
OUTSIDE = [int(r >= 6) for r in RADII]
LABELS = [a + 2 * b for a, b in zip(LEFT, RIGHT)]
HALF = sum(LEFT)


class MeaningTest(CommandTest):
    def write(self, name, values, kind="float"):
        write_nrrd(self.path(name), (N, N, len(values) // N // N), values, kind)
        return self.path(name)

    def info(self, *arguments):
        """The voxels of each label, and what is reported; the same on standard error and in the JSON."""
        done = self.run_ok("info", *arguments, "--json", self.path("report.json"))
        report = json.loads(self.path("report.json").read_text())
        self.assertEqual(done.stderr, "".join("cleft: warning: %s\n" % reported for reported in report["warnings"]))
        return {row["label"]: row["voxels"] for row in report["volume"]["labels"]}, report["warnings"]

    def assert_reported(self, warnings, *words):
        self.assertEqual(len(warnings), 1, warnings)
        for word in words:
            self.assertIn(str(word), warnings[0])

    def assert_refused(self, *arguments, words=()):
        self.assert_fails(CANNOT_READ, cleft("info", *arguments), *words)


class Masks(MeaningTest):
    def setUp(self):
        super().setUp()
        self.left = self.write("left.nrrd", LEFT, "uint8")
        self.right = self.write("right.nrrd", [255 * v for v in RIGHT], "uint8")
        self.outside = self.write("outside.nrrd", OUTSIDE)
        self.empty = self.write("empty.nrrd", [0] * N**3, "uint8")

    def test_masks_that_fill_the_volume_are_labels_in_their_order(self):
        labels, warnings = self.info(self.outside, self.left, self.right)
        self.assertEqual(labels, {0: N**3 - 2 * HALF, 1: HALF, 2: HALF})
        self.assertEqual(warnings, [])

    def test_voxels_of_nobody_get_a_label_of_their_own(self):
        labels, warnings = self.info(self.left, self.right)
        self.assertEqual(labels, {0: HALF, 1: HALF, 2: N**3 - 2 * HALF})
        self.assert_reported(warnings, "%s voxels" % format(N**3 - 2 * HALF, ","), "in no mask", "label 2")

    def test_the_mesh_of_masks_is_that_of_the_label_map(self):
        label_map = self.write("map.nrrd", [2 if v == 0 else v - 1 for v in LABELS], "uint8")
        for smooth in (2, 4):
            masks = self.mesh(self.left, self.right, "--smooth", smooth)
            labels = self.mesh(label_map, "--smooth", smooth)
            self.assertEqual(masks["mesh"], labels["mesh"])
        for row in masks["labels"]:
            self.assertLess(abs(row["difference_percent"]), 5)

    def test_an_empty_mask_is_told_and_has_no_label(self):
        labels, warnings = self.info(self.left, self.empty, self.right, self.outside)
        self.assertEqual(labels, {0: HALF, 2: HALF, 3: N**3 - 2 * HALF})
        self.assert_reported(warnings, "empty.nrrd", "no voxel", "no label 1")
        self.assert_refused(self.empty, self.empty, words=["no mask holds a voxel"])

    def test_of_masks_that_overlap_the_first_wins(self):
        core = self.write("core.nrrd", [int(r < 3) for r in RADII], "int16")
        inner = sum(r < 3 for r in RADII)
        labels, warnings = self.info(core, self.left, self.right, self.outside)
        self.assertEqual(labels, {0: inner, 1: HALF - inner // 2, 2: HALF - inner // 2, 3: N**3 - 2 * HALF})
        self.assertEqual(len(warnings), 2)
        for warning, name in zip(sorted(warnings), ("left", "right")):
            for word in ("%d voxels" % (inner // 2), "core.nrrd", name, "the first takes"):
                self.assertIn(word, warning)
        labels, warnings = self.info(self.left, self.right, core, self.outside)
        self.assertNotIn(2, labels)
        self.assertTrue(any("no label 2" in reported and "core.nrrd" in reported for reported in warnings), warnings)

    def test_masks_beside_a_function_are_functions_of_the_same_values(self):
        function = self.write("function.nrrd", [5.3 - r for r in RADII])
        for kind in ("uint8", "int16", "int32", "float", "double"):
            masks = [self.write("mask%d.nrrd" % i, [i * v for v in LEFT], kind) for i in (1, 3)]
            for files in ((*masks, function), (function, *masks)):
                with self.subTest(kind=kind, files=files):
                    told = self.mesh(*files, "--as", "indicators")
                    self.assertEqual(self.mesh(*files)["mesh"], told["mesh"])

    def test_a_mask_of_everything_behind_the_others_is_the_outside(self):
        full = self.write("full.nrrd", [1] * N**3, "uint8")
        labels, warnings = self.info(self.left, self.right, full)
        self.assertEqual(labels, {0: HALF, 1: HALF, 2: N**3 - 2 * HALF})
        self.assertEqual(len(warnings), 2)

    def test_frames_of_one_file_are_masks_too(self):
        header = ("NRRD0004\ntype: uint8\ndimension: 4\nsizes: %d %d %d 2\nencoding: raw\n\n" % (N, N, N)).encode()
        self.path("four.nrrd").write_bytes(header + bytes(LEFT) + bytes(RIGHT))
        labels, warnings = self.info(self.path("four.nrrd"))
        self.assertEqual(labels, {0: HALF, 1: HALF, 2: N**3 - 2 * HALF})
        self.assert_reported(warnings, "in no mask")

    def test_raw_masks(self):
        for name, values in (("a.raw", LEFT), ("b.raw", RIGHT)):
            self.path(name).write_bytes(bytes(values))
        raw = ("--dims", N, N, N)
        labels, _ = self.info(self.path("a.raw"), self.path("b.raw"), *raw)
        self.assertEqual(labels, {0: HALF, 1: HALF, 2: N**3 - 2 * HALF})

    def test_one_file_of_0_and_255_is_a_label_map(self):
        self.assertEqual(self.info(self.right), ({0: N**3 - HALF, 255: HALF}, []))


class Labels(MeaningTest):
    COUNTS = {0: N**3 - 2 * HALF, 1: HALF, 2: HALF}

    def test_labels_that_are_not_quite_whole_are_rounded_and_told(self):
        file = self.write("near.nrrd", [0.988 if v == 1 else v for v in LABELS])
        labels, warnings = self.info(file)
        self.assertEqual(labels, self.COUNTS)
        self.assert_reported(warnings, "near.nrrd", "%d voxels" % HALF, "0.012")
        file = self.write("large.nrrd", [7014.9999 if v == 1 else v for v in LABELS])
        self.assertEqual(self.info(file)[0], {0: N**3 - 2 * HALF, 2: HALF, 7015: HALF})

    def test_whole_floats_with_negatives_are_labels(self):
        file = self.write("negative.nrrd", [v - 1 for v in LABELS])
        self.assertEqual(self.info(file), ({v - 1: n for v, n in self.COUNTS.items()}, []))

    def test_few_fractions_are_no_function_unless_asked_for(self):
        for factor, shift in ((0.1, 0), (0.3, -0.3)):
            file = self.write("fractions.nrrd", [factor * v + shift for v in LABELS])
            self.assert_refused(file, words=["fractions.nrrd", "--as indicators", "--as labels"])
        self.assertEqual(self.info(file, "--as", "indicators")[0], {0: N**3 - HALF, 1: HALF})
        labels, warnings = self.info(self.write("half.nrrd", [0.8 * v for v in LABELS]), "--as", "labels")
        self.assertEqual(labels, self.COUNTS)
        self.assert_reported(warnings, "%s voxels" % format(2 * HALF, ","), "0.4", "rounded")

    def test_interpolated_labels_are_refused(self):
        mixed = [(a + b) / 2 for a, b in zip(LABELS, LABELS[1:] + [0])]
        self.assert_refused(self.write("mixed.nrrd", mixed), words=["--as labels"])
        self.assert_refused(self.write("signed.nrrd", [v - 1 for v in mixed]), words=["--as labels"])
        # Splines swing about every label, so that no voxel is whole and some are below 0.
        for factor, shift in ((1, 0), (100, 0), (3, -2), (3, 4)):
            swinging = [factor * v + shift + 0.09 * math.sin(1.7 * i) - 5 * (i == 0) for i, v in enumerate(LABELS)]
            self.assert_refused(self.write("spline.nrrd", swinging), words=["interpolated", "--as labels"])
        labels, _ = self.info(self.path("spline.nrrd"), "--as", "labels")
        self.assertEqual({v: n for v, n in labels.items() if n > 1}, {4: N**3 - 2 * HALF - 1, 7: HALF, 10: HALF})

    def test_small_pieces_with_a_negative_label_are_labels(self):
        pieces = [
            (-1, 1, 3, 5, 7)[(37 * (i // 2 % 10) + 11 * (i // 40 % 10) + 17 * (i // 800)) % 23 % 5]
            for i in range(N**3)
        ]
        for values in (pieces, [min(v, 3) for v in pieces]):
            counts = {v: values.count(v) for v in set(values)}
            self.assertEqual(self.info(self.write("pieces.nrrd", values, "int16")), (counts, []))

    def test_constants(self):
        self.assertEqual(self.info(self.write("five.nrrd", [5] * N**3))[0], {5: N**3})
        self.assertEqual(self.info(self.write("zero.nrrd", [0] * N**3, "uint8"))[0], {0: N**3})
        self.assert_refused(self.write("half.nrrd", [0.5] * N**3), words=["fractions"])

    def test_a_voxel_that_is_no_number_is_named(self):
        for value, word in ((float("nan"), "NaN"), (float("inf"), "infinite")):
            values = [float(v) for v in LABELS]
            values[1 + N * (2 + N * 3)] = value
            for kind in ("auto", "labels", "indicators"):
                self.assert_refused(
                    self.write("bad.nrrd", values),
                    "--as",
                    kind,
                    words=["bad.nrrd", "2nd along x, the 3rd along y and the 4th along z", word],
                )

    def test_what_looks_like_an_image_is_told_or_refused(self):
        grey = [(7919 * i * i) % 251 for i in range(N**3)]
        self.assert_reported(
            self.info(self.write("grey.nrrd", grey, "uint8"))[1], "grey.nrrd", "126 different", "image"
        )
        self.assert_refused(self.write("ct.nrrd", [10 * v - 1000 for v in grey], "int16"), words=["--as labels"])
        distances = self.write("distances.nrrd", [round(2 * (6 - r)) for r in RADII], "int16")
        self.assert_refused(distances, words=["distance", "--as indicators"])
        self.assert_refused(self.write("few.nrrd", [round(0.9 * (6 - r)) for r in RADII], "int16"), words=["distance"])
        self.assertEqual(set(self.info(distances, "--as", "indicators")[0]), {0, 1})

    def test_labels_beyond_32_bits_are_to_be_renumbered(self):
        header = "NRRD0004\ntype: %s\ndimension: 3\nsizes: 2 2 2\nendian: little\nencoding: raw\n\n"
        for kind, value in (("int64", 2**33), ("int64", -(2**40)), ("uint32", 2**31), ("uint64", 2**63)):
            size = 4 if kind == "uint32" else 8
            voxel = value.to_bytes(size, "little", signed=value < 0)
            self.path("big.nrrd").write_bytes((header % kind).encode() + bytes(7 * size) + voxel)
            self.assert_refused(self.path("big.nrrd"), words=["32 bits", "renumber", "numpy.unique"])
        self.path("fits.nrrd").write_bytes(
            (header % "int64").encode() + bytes(56) + (2**31 - 1).to_bytes(8, "little")
        )
        self.assertEqual(self.info(self.path("fits.nrrd"))[0], {0: 7, 2**31 - 1: 1})


class Functions(MeaningTest):
    def test_a_signed_distance_is_a_function(self):
        inside = sum(r < 6 for r in RADII)
        for scale in (1, 1e-3, 1e3):
            for most in (100, 4):
                cut = [scale * max(-most, min(most, 6 - r)) for r in RADII]
                self.assertEqual(self.info(self.write("distance.nrrd", cut)), ({0: N**3 - inside, 1: inside}, []))

    def test_a_probability_alone_is_refused(self):
        file = self.write("probability.nrrd", [1 / (1 + r) for r in RADII])
        self.assert_refused(file, words=["probability.nrrd", "above 0", "--as indicators"])
        labels, warnings = self.info(file, "--as", "indicators")
        self.assertEqual(labels, {0: 0, 1: N**3})
        self.assert_reported(warnings, "above 0 everywhere")

    def test_voxels_that_are_equal_in_all_functions_are_told(self):
        soft = [max(0.0, 1 - r / 8) * (v[0] < 0) for r, v in zip(RADII, VOXELS)]
        other = [max(0.0, 1 - r / 8) * (v[0] > 0) for r, v in zip(RADII, VOXELS)]
        ties = sum(a == b for a, b in zip(soft, other))
        files = self.write("a.nrrd", soft), self.write("b.nrrd", other)
        _, warnings = self.info(*files)
        self.assert_reported(warnings, "%d of %d voxels" % (ties, N**3), "background")
        background = self.write("c.nrrd", [0.01] * N**3)
        labels, warnings = self.info(*files, background)
        self.assertEqual(set(labels), {0, 1, 2})
        self.assertEqual(warnings, [])

    def test_label_maps_among_several_files_are_refused(self):
        files = self.write("a.nrrd", LABELS, "uint8"), self.write("b.nrrd", LEFT, "uint8")
        self.assert_refused(*files, words=["a.nrrd", "0 to 2", "--as indicators"])
        self.assertEqual(sum(self.info(*files, "--as", "indicators")[0].values()), N**3)

    def test_frames_of_a_label_map_are_refused(self):
        header = "NRRD0004\ntype: uint8\ndimension: 4\nsizes: %d %d %d %d\nencoding: raw\n\n"
        self.path("four.nrrd").write_bytes((header % (N, N, N, 2)).encode() + 2 * bytes(LABELS))
        self.assert_refused(self.path("four.nrrd"), words=["the 1st frame of", "four.nrrd", "labels", "one frame"])
        self.assert_refused(self.path("four.nrrd"), "--as", "labels", words=["one frame"])
        self.path("one.nrrd").write_bytes((header % (N, N, N, 1)).encode() + bytes(LABELS))
        self.assertEqual(self.info(self.path("one.nrrd")), (Labels.COUNTS, []))

    def test_raw_voxels_have_a_kind_too(self):
        self.path("a.raw").write_bytes(bytes(LABELS))
        raw = (self.path("a.raw"), "--dims", N, N, N)
        self.assertEqual(self.info(*raw)[0], Labels.COUNTS)
        self.assertEqual(self.info(*raw, "--as", "indicators")[0], {0: N**3 - 2 * HALF, 1: 2 * HALF})


class Spacing(MeaningTest):
    def test_an_origin_that_stays_is_told(self):
        write_nrrd(self.path("mm.nrrd"), (N, N, N), LABELS, origin=(40, -30, 20))
        self.assert_reported(
            self.info(self.path("mm.nrrd"), "--spacing", "0.001,0.001,0.001")[1], "origin (40, -30, 20)", "--scale"
        )
        self.assertEqual(self.info(self.path("mm.nrrd"), "--spacing", "1,1,1")[1], [])
        self.assertEqual(self.info(self.path("mm.nrrd"), "--scale", "0.001", "--spacing", "0.002,0.001,0.001")[1], [])
        self.assert_reported(
            self.info(self.path("mm.nrrd"), "--scale", "0.001", "--spacing", "1,1,1")[1], "0.001", "1000"
        )
        write_nrrd(self.path("zero.nrrd"), (N, N, N), LABELS)
        self.assertEqual(self.info(self.path("zero.nrrd"), "--spacing", "2,2,2")[1], [])


if __name__ == "__main__":
    unittest.main()
