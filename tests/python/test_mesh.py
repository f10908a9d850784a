"""The stages and what can be asked of their results."""
import threading
import unittest

import numpy as np

import cleft
from support import QUICK, ball_labels, ball_mesh, ball_volume, same_mesh


class Meshes(unittest.TestCase):
    def test_mesh_is_sound(self):
        mesh = ball_mesh()
        self.assertTrue(mesh.validate(fills_box=True))
        self.assertEqual(mesh.validate().first_fault, "")
        self.assertEqual(mesh.different_labels.tolist(), [0, 1, 7])
        self.assertEqual((mesh.points.dtype, mesh.tets.dtype, mesh.labels.dtype), (np.float64, np.int32, np.int32))
        a, b, c, d = (mesh.points[mesh.tets[:, n]] for n in range(4))
        volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
        self.assertTrue((volumes > 0).all())
        self.assertAlmostEqual(volumes.sum(), 12 * 13 * 14)

    def test_stages_by_hand_are_the_whole(self):
        volume, options = ball_volume(), cleft.Options(**QUICK)
        sizing = cleft.Sizing(volume, options=options)
        background = cleft.make_background(sizing, options=options)
        self.assertEqual(background.different_labels.tolist(), [0])
        cleaved = cleft.cleave(volume, background, options=options)
        improved = cleft.improve(volume, cleaved, options=options)
        self.assertTrue(improved.validate(fills_box=True))
        whole = cleft.mesh(volume, background_mesh=background, options=options)
        self.assertEqual(len(whole.tets), len(improved.tets))
        stripped = cleft.strip_labels(improved, strip=[0])
        self.assertEqual(stripped.different_labels.tolist(), [1, 7])
        self.assertEqual(cleft.strip_labels(improved, only=[1]).different_labels.tolist(), [1])

    def test_the_one_call_is_the_five_calls(self):
        affine = np.array([[0.7, 0.1, 0, -3.1], [0.2, -0.9, 0.3, 100.3], [0.1, 0, 1.3, 7.7], [0, 0, 0, 1]])
        volume = ball_volume(16, affine=affine)
        sizes = np.linspace(1.5, 2.5, int(np.prod(volume.shape))).reshape(volume.shape)
        own = cleft.Sizing.from_values(volume, sizes)
        for background in ("particles", "lattice", "octree"):
            for given, keywords in (
                (None, {}),
                (None, {"tets": 4000, "strip": [0]}),
                (own, {"strict": True, "strip": [0]}),
            ):
                with self.subTest(background=background, **keywords):
                    options = cleft.Options(background=background, **keywords)
                    sizing = given or cleft.Sizing(volume, options=options)
                    background_mesh = cleft.make_background(sizing, options=options)
                    cleaved = cleft.cleave(volume, background_mesh, options=options)
                    improved = cleft.improve(volume, cleaved, options=options)
                    stripped = cleft.strip_labels(improved, options=options)
                    self.assertTrue(same_mesh(stripped, cleft.mesh(volume, sizing=given, options=options)))

    def test_the_estimate_is_near(self):
        volume = ball_volume(24)
        for keywords in ({"background": "octree"}, {"size": 2.0, "strip": [0]}):
            estimate = cleft.estimate(volume, **keywords)
            tets = len(cleft.mesh(volume, **keywords).tets)
            self.assertLess(abs(estimate.tets - tets), 0.15 * tets)
            self.assertGreater(estimate.peak_bytes, 100 * estimate.whole_tets)
        own = cleft.make_background(cleft.Sizing.constant(volume, 2.0))
        self.assertEqual(cleft.estimate(volume, background_mesh=own).background_tets, len(own.tets))

    def test_sizing(self):
        volume = ball_volume()
        self.assertAlmostEqual(cleft.Sizing.constant(volume, 2.5).at((6, 6, 6)), 2.5)
        wanted = np.full(volume.shape, 3.0)
        wanted[:6] = 1.5
        sizing = cleft.Sizing.from_values(volume, wanted)
        self.assertEqual(sizing.values.shape, volume.shape)
        self.assertTrue(np.array_equal(sizing.values, wanted.astype(np.float32)))
        self.assertTrue(np.array_equal(sizing.affine, volume.affine))
        self.assertGreater(sizing.expected_tets, 100)
        both = cleft.Sizing.from_values(volume, wanted, combine=True, size=2.0)
        self.assertLessEqual(both.values.max(), 2.0)
        self.assertGreater(len(cleft.mesh(volume, sizing=sizing, **QUICK).tets), 100)
        for wrong in (wanted[1:], wanted * np.nan, -wanted):
            with self.assertRaises(ValueError):
                cleft.Sizing.from_values(volume, wrong)
        with self.assertRaises(ValueError):
            sizing.at((np.nan, 0, 0))

    def test_metric(self):
        volume = ball_volume()
        tensors = np.zeros(volume.shape + (6,))
        tensors[..., 0] = np.linspace(0.04, 0.25, volume.shape[0])[:, None, None]  # lengths along x: 5 to 2
        tensors[..., 3] = np.linspace(0.1, 0.2, volume.shape[1])[None, :, None]
        tensors[..., 5] = np.linspace(0.2, 0.4, volume.shape[2])[None, None, :]
        tensors[..., (1, 2, 4)] = 0.01, -0.02, 0.03
        matrices = tensors[..., [[0, 1, 2], [1, 3, 4], [2, 4, 5]]]
        for given in (tensors, np.asfortranarray(tensors), tensors.astype(np.float32), matrices):
            sizing = cleft.Sizing.from_metric(volume, given)
            self.assertTrue(sizing.has_metric)
            self.assertEqual((sizing.metric.shape, sizing.metric.dtype), (tensors.shape, np.float32))
            self.assertLess(np.abs(sizing.metric - tensors).max(), 1e-5)
        self.assertGreater(len(cleft.mesh(volume, sizing=sizing, improve="off").tets), 100)
        bounded = cleft.Sizing.from_metric(volume, tensors, size_max=1.0).metric
        self.assertLess(np.abs(bounded - (1, 0, 0, 1, 0, 1)).max(), 1e-5)
        both = cleft.Sizing.from_metric(volume, tensors, combine=True, size=1.0).metric
        self.assertGreater(np.linalg.eigvalsh(both[..., [[0, 1, 2], [1, 3, 4], [2, 4, 5]]]).min(), 1 - 1e-5)
        self.assertFalse(cleft.Sizing.constant(volume, 2.0).has_metric)
        with self.assertRaises(cleft.InvalidArgument):
            cleft.Sizing.constant(volume, 2.0).metric

    def test_constant_metric(self):
        volume = ball_volume()
        for given in ([1 / 9, 0, 0, 1 / 9, 0, 1], np.diag((1 / 9, 1 / 9, 1)).astype(np.float32)):
            sizing = cleft.Sizing.constant_metric(volume, given)
            self.assertTrue(sizing.has_metric)
            self.assertLess(np.abs(sizing.metric - (1 / 9, 0, 0, 1 / 9, 0, 1)).max(), 1e-6)
        mesh = cleft.mesh(volume, sizing=sizing, background="lattice", improve="off")
        edges = np.abs(mesh.points[mesh.tets[:, 1:]] - mesh.points[mesh.tets[:, :1]]).mean(axis=(0, 1))
        self.assertGreater(min(edges[0], edges[1]), 2 * edges[2])  # elements are flat along z
        quality = mesh.metric_quality(sizing)
        self.assertEqual(quality.tet_count, len(mesh.tets))
        self.assertEqual(sum(quality.dihedral_histogram), 6 * len(mesh.tets))
        ends = mesh.tets[:, ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))].reshape(-1, 2)
        ends = np.unique(np.sort(ends, axis=1), axis=0)
        lengths = np.linalg.norm((mesh.points[ends[:, 1]] - mesh.points[ends[:, 0]]) / (3, 3, 1), axis=1)
        self.assertEqual(quality.edge_count, len(ends))
        self.assertAlmostEqual(quality.edge_least, lengths.min(), 5)
        self.assertAlmostEqual(quality.edge_greatest, lengths.max(), 5)
        for wrong, kind in ((None, TypeError), (cleft.Sizing.constant(volume, 2.0), cleft.InvalidArgument)):
            with self.assertRaises(kind):
                mesh.metric_quality(wrong)

    def test_tensors_that_are_no_metric(self):
        volume = ball_volume()
        flat = np.tile(np.diag((0.25, 0.25, 1.0)), volume.shape + (1, 1))
        for make, words in (
            (lambda m: m[1:], "shape"),
            (lambda m: m[..., 0], "shape"),
            (lambda m: -m, "1st along x"),
            (lambda m: m * np.nan, "1st along x"),
        ):
            with self.assertRaisesRegex(cleft.InvalidArgument, words):
                cleft.Sizing.from_metric(volume, make(flat))
        flat[2, 3, 4, 0, 1] = 0.1
        with self.assertRaisesRegex(cleft.InvalidArgument, r"metric\[2, 3, 4\] is not symmetric: its \[0, 1\] is 0.1"):
            cleft.Sizing.from_metric(volume, flat)
        with self.assertRaisesRegex(cleft.InvalidArgument, "metric is not symmetric"):
            cleft.Sizing.constant_metric(volume, flat[2, 3, 4])
        flat[2, 3, 4, 1, 0] = 0.1 * (1 + 1e-6)  # rounding is no fault
        self.assertTrue(cleft.Sizing.from_metric(volume, flat).has_metric)
        with self.assertRaisesRegex(cleft.InvalidArgument, "shape"):
            cleft.Sizing.constant_metric(volume, flat)
        for wrong in ("abcdef", flat[0, 0, 0] + 1j):
            with self.assertRaises(TypeError):
                cleft.Sizing.constant_metric(volume, wrong)

    def test_report(self):
        volume = ball_volume()
        rows = cleft.mesh(volume, **QUICK).report(volume)
        self.assertEqual([row.label for row in rows], [0, 1, 7])
        self.assertEqual({row.label: row.voxels for row in rows}, volume.voxel_counts)
        self.assertAlmostEqual(sum(row.mesh_volume for row in rows), 12 * 13 * 14)
        self.assertFalse(any(row.lost for row in rows))

    def test_contacts(self):
        i, j, k = np.ogrid[:24, :24, :24]
        radius = np.sqrt((i - 11.5) ** 2 + (j - 11.5) ** 2 + (k - 11.5) ** 2)
        labels = np.where(radius < 6, 7, 0)
        labels[(radius > 7.6) & (radius < 10.5) & (k < 14)] = -1  # a socket, which the ball does not touch
        volume = cleft.Volume(labels)
        coarse, fine = (cleft.mesh(volume, background="lattice", size=size) for size in (3.5, 0.8))
        (contact,) = coarse.report(volume).contacts
        both = coarse.surface().interface_labels
        self.assertEqual((contact.first, contact.second), (-1, 7))
        self.assertEqual(contact.triangles, (both == (-1, 7)).all(1).sum())
        self.assertEqual(fine.report(volume).contacts, [])

    def test_distances(self):
        volume = ball_volume()
        mesh = cleft.mesh(volume, **QUICK)
        self.assertEqual(mesh.report(volume).distances, [])
        report = mesh.report(volume, distances=True)
        self.assertEqual([row.label for row in report], [0, 1, 7])
        surface = mesh.surface()
        for row in report.distances:
            self.assertLess(row.mesh_mean, row.mesh_greatest)
            if not row.is_line:
                pair = (row.first, row.second)
                self.assertEqual(row.elements, (surface.interface_labels == pair).all(1).sum())

    def test_labels_of_any_value(self):
        labels, wanted = ball_labels(kind=np.int64), ball_mesh()
        for values in ((-1, 0, 1), (-(2**31), -1, 2**31 - 1), (-3, -2, -1), (5, -1, 2**31 - 1)):
            renamed = np.choose(np.searchsorted((0, 1, 7), labels), values)
            mesh = cleft.mesh(cleft.Volume(renamed), **QUICK)
            self.assertTrue(np.array_equal(mesh.points, wanted.points) and np.array_equal(mesh.tets, wanted.tets))
            self.assertTrue(np.array_equal(mesh.labels, np.choose(np.searchsorted((0, 1, 7), wanted.labels), values)))
            self.assertEqual(mesh.different_labels.tolist(), sorted(values))
            surface, other = mesh.surface(), wanted.surface()
            self.assertEqual(len(surface.interface_triangles), len(other.interface_triangles))
            self.assertTrue(mesh.validate(fills_box=True))
            self.assertEqual(cleft.strip_labels(mesh, strip=[values[0]]).different_labels.tolist(), sorted(values[1:]))
            self.assertGreater(
                len(
                    cleft.mesh(cleft.Volume(renamed), background="lattice", size=3.0, label_sizes={values[1]: 1.0}).tets
                ),
                len(mesh.tets),
            )

    def test_names_of_labels(self):
        volume = ball_volume()
        self.assertEqual(volume.label_names, {})
        volume.label_names = {1: "left kidney", 7: "Größe"}
        self.assertEqual(volume.label_names, {1: "left kidney", 7: "Größe"})
        mesh = cleft.mesh(volume, **QUICK)
        self.assertEqual(mesh.label_names, volume.label_names)
        self.assertEqual(cleft.strip_labels(mesh, strip=[7]).label_names, {1: "left kidney"})
        mesh.label_names = {0: "outside"}  # replaces all, of the mesh alone
        self.assertEqual(mesh.label_names, {0: "outside"})
        self.assertEqual(volume.label_names, {1: "left kidney", 7: "Größe"})
        with self.assertRaises(TypeError):
            mesh.label_names[1] = "a copy would swallow this"
        for wrong, kind in (
            ({3: "no such label"}, ValueError),
            ({1: "two\nlines"}, ValueError),
            ({1: "a\0b"}, ValueError),
            ({1: 5}, TypeError),
            ({1: None}, TypeError),
            ({1: "\ud800"}, ValueError),
        ):
            with self.assertRaises(kind):
                volume.label_names = {7: "must not change", **wrong}
            self.assertEqual(volume.label_names, {1: "left kidney", 7: "Größe"})
        volume.label_names = {}
        self.assertEqual(volume.label_names, {})

    def test_quality(self):
        mesh = ball_mesh()
        quality = mesh.quality()
        self.assertEqual(quality.tet_count, len(mesh.tets))
        self.assertEqual(sum(quality.dihedral_histogram), 6 * len(mesh.tets))
        self.assertTrue(0 < quality.min_dihedral < 60 < quality.max_dihedral < 180)

    def test_surface(self):
        mesh = ball_mesh()
        with mesh.surface() as surface:
            pairs = np.unique(surface.interface_labels, axis=0).tolist()
            self.assertEqual(len(surface.interface_triangles), len(surface.interface_labels))
            self.assertIn([0, 1], pairs)
            self.assertEqual(len(surface.hull_triangles), len(surface.hull_labels))
            self.assertEqual(set(surface.hull_sides.tolist()), set(range(6)))
            at_x_min = surface.hull_triangles[surface.hull_sides == cleft.SIDES.index("x_min")]
            self.assertTrue(np.allclose(mesh.points[at_x_min, 0], mesh.points[:, 0].min()))

    def test_arrays_there_and_back(self):
        mesh = ball_mesh()
        again = cleft.Mesh(mesh.points, mesh.copy_tets(index_base=1), mesh.labels, index_base=1)
        self.assertTrue(same_mesh(mesh, again))
        self.assertTrue(np.array_equal(mesh.copy_tets(), mesh.tets))
        bare = cleft.Mesh(mesh.points.astype(np.float32).tolist(), mesh.tets.astype(np.int64))
        self.assertEqual(bare.different_labels.tolist(), [0])

    def test_faults_are_found(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
        self.assertTrue(cleft.Mesh(points, [[0, 1, 2, 3]]).validate())
        found = cleft.Mesh(points, [[1, 0, 2, 3]]).validate()
        self.assertFalse(found)
        self.assertEqual(found.negative_tets, 1)
        self.assertNotEqual(found.first_fault, "")

    def test_triangles_are_counted_twice(self):
        for mesh in (ball_mesh(), cleft.strip_labels(ball_mesh(), strip=[0])):
            found, surface = mesh.validate(), mesh.surface()
            self.assertEqual(found.interface_triangles, len(surface.interface_triangles))
            self.assertEqual(found.hull_triangles, len(surface.hull_triangles))

    def test_quadratic(self):
        mesh = ball_mesh()
        points, tets = mesh.quadratic()
        self.assertEqual(tets.shape, (len(mesh.tets), 10))
        self.assertTrue(np.array_equal(tets[:, :4], mesh.tets))
        self.assertTrue(np.allclose(points[tets[:, 4]], (points[tets[:, 0]] + points[tets[:, 1]]) / 2))
        self.assertEqual(mesh.quadratic(1)[1].min(), 1)

    def test_threads_give_the_same_mesh(self):
        volume = ball_volume()
        one, two = (cleft.mesh(volume, mesher=cleft.Mesher(threads=n), **QUICK) for n in (1, 2))
        self.assertTrue(same_mesh(one, two))

    def test_one_volume_in_many_threads(self):
        volume, meshes = ball_volume(), []
        threads = [threading.Thread(target=lambda: meshes.append(cleft.mesh(volume, **QUICK))) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(meshes), 4)
        self.assertTrue(all(same_mesh(mesh, meshes[0]) for mesh in meshes))

    def test_metrics(self):
        mesher = cleft.Mesher()
        cleft.mesh(ball_volume(), mesher=mesher, **QUICK)
        self.assertTrue(mesher.metrics())
        self.assertTrue(all(isinstance(value, float) for value in mesher.metrics().values()))
        mesher.clear_metrics()
        self.assertEqual(mesher.metrics(), {})

    def test_to_meshio(self):
        try:
            import meshio  # noqa: F401
        except ImportError:
            self.skipTest("meshio is not installed")
        mesh = ball_mesh()
        there = mesh.to_meshio()
        self.assertTrue(np.array_equal(there.points, mesh.points))
        self.assertTrue(np.array_equal(there.cells_dict["tetra"], mesh.tets))
        self.assertTrue(np.array_equal(there.cell_data_dict["material"]["tetra"], mesh.labels))

    def test_repr(self):
        self.assertIn("3 labels", repr(ball_mesh()))
        self.assertIn("12 x 13 x 14", repr(ball_volume()))
        self.assertEqual(ball_labels().shape, (12, 13, 14))


if __name__ == "__main__":
    unittest.main()
