"""Meshes written by this library and by Gmsh, VTK and meshio are read back: check_reading.py WRITE_SAMPLE DUMP_MESH."""
import subprocess
import sys

import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from sample import corners, run_checks, run_checks_with_all_labels, same

BOXES = """SetFactory("Built-in");
Mesh.MeshSizeMax = 0.5;
For k In {0:1}
  Point(4*k+1) = {0, 0, k}; Point(4*k+2) = {1, 0, k}; Point(4*k+3) = {1, 1, k}; Point(4*k+4) = {0, 1, k};
EndFor
Point(9) = {0.5, 0.5, 0.5};
For k In {0:1}
  For i In {1:4}
    Line(10*k+i) = {4*k+i, 4*k+(i%4)+1};
  EndFor
  Curve Loop(k+1) = {10*k+1:10*k+4}; Plane Surface(k+1) = {k+1};
EndFor
For i In {1:4}
  Line(20+i) = {i, 4+i};
EndFor
For i In {1:4}
  Curve Loop(10+i) = {i, 20+(i%4)+1, -(10+i), -(20+i)}; Plane Surface(10+i) = {10+i};
EndFor
Surface Loop(1) = {1, 2, 11:14}; Volume(5) = {1};
"""


def dump(path):
    """Points, tetrahedra and labels as the library reads them."""
    folder = path + ".arrays"
    subprocess.run(["mkdir", "-p", folder], check=True)
    run = subprocess.run([sys.argv[2], path, folder], stderr=subprocess.PIPE, text=True)
    same((run.returncode, run.stderr), (0, ""), "the reading of " + path)
    return (
        np.fromfile(folder + "/points.f64").reshape(-1, 3),
        np.fromfile(folder + "/tets.i32", "<i4").reshape(-1, 4),
        np.fromfile(folder + "/labels.i32", "<i4"),
    )


def check_own(sample):
    for name in ("vtu.vtu", "vtk.vtk", "medit.mesh", "msh22.msh", "tetgen.node", "tetgen.ele"):
        sample.check_tets(*dump(sample.path(name)))
    points, tets, labels = dump(sample.path("msh41.msh"))  # by entity
    number = {point: i for i, point in enumerate(map(tuple, sample.points.tolist()))}
    order = np.array([number[point] for point in map(tuple, points.tolist())])
    sample.check_tets(points[np.argsort(order)], order[tets], labels, ordered=False)


def check_gmsh(sample):
    def write(name, physical, version, binary):
        script, out = sample.path(name + ".geo"), sample.path("%s-%s-%d.msh" % (name, version, binary))
        with open(script, "w") as file:
            file.write(BOXES + physical + "Mesh.MshFileVersion = %s; Mesh.Binary = %d;\n" % (version, binary))
        subprocess.run(["gmsh", script, "-3", "-o", out], check=True, stdout=subprocess.DEVNULL)
        return out

    for name, physical, label in (
        ("entity", "", 5),
        ("group", "Physical Volume(17) = {5};\n", 17),
        ("name", 'Physical Volume("material_minus4", 17) = {5};\n', -4),
        ("any", 'Physical Volume("steel", 17) = {5}; Physical Surface("top", 3) = {2};\n', 17),
    ):
        dumps = [dump(write(name, physical, version, binary)) for version in ("2.2", "4.1") for binary in (0, 1)]
        for points, tets, labels in dumps:
            same(set(labels.tolist()), {label}, "labels of " + name)
            a, b, c, d = (points[tets[:, i]] for i in range(4))
            volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
            assert volumes.min() > 0 and abs(volumes.sum() - 1) < 1e-12
            same(len(tets), len(dumps[0][1]), "numbers of tetrahedra")


def check_partitioned(sample):
    """Two boxes in three partitions: the parts have the labels of their volumes, by group, by name and by number."""
    boxes = """SetFactory("OpenCASCADE");
Mesh.MeshSizeMax = 0.5;
Box(1) = {0, 0, 0, 1, 1, 1}; Box(2) = {1, 0, 0, 1, 1, 1};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
"""
    groups = 'Physical Volume("material_minus4", 17) = {1}; Physical Volume("steel", 3) = {2};\n'
    for name, physical, labels in (("parts", "", [1, 2]), ("parts of groups", groups, [-4, 3])):
        for version in ("2.2", "4.1"):
            for binary in (0, 1):
                script, out = sample.path(name + ".geo"), sample.path("%s-%s-%d.msh" % (name, version, binary))
                with open(script, "w") as file:
                    file.write(boxes + physical + "Mesh.MshFileVersion = %s; Mesh.Binary = %d;\n" % (version, binary))
                subprocess.run(["gmsh", script, "-3", "-part", "3", "-o", out], check=True, stdout=subprocess.DEVNULL)
                assert version == "2.2" or b"$PartitionedEntities" in open(out, "rb").read()
                points, tets, got = dump(out)
                side = (points[tets].mean(axis=1)[:, 0] > 1).astype(int)
                same(got.tolist(), np.array(labels)[side].tolist(), "labels of " + out)


def check_vtk(sample):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(sample.path("vtu.vtu"))
    reader.Update()
    path = sample.path("by-vtk.vtu")
    for mode in ("SetDataModeToAscii", "SetDataModeToBinary", "SetDataModeToAppended"):
        for base64 in (0, 1):
            for header in ("SetHeaderTypeToUInt32", "SetHeaderTypeToUInt64"):
                for compressor in ("SetCompressorTypeToNone", "SetCompressorTypeToZLib"):
                    writer = vtk.vtkXMLUnstructuredGridWriter()
                    for setting in (mode, header, compressor):
                        getattr(writer, setting)()
                    writer.SetEncodeAppendedData(base64)
                    writer.SetBlockSize(1024)
                    writer.SetFileName(path)
                    writer.SetInputData(reader.GetOutput())
                    writer.Write()
                    points, *rest = dump(path)
                    if "Ascii" in mode:  # VTK writes too few digits
                        assert np.abs(points - sample.points).max() < 1e-6 * 12345
                        points = sample.points
                    sample.check_tets(points, *rest)
    pairs = numpy_to_vtk(np.zeros((len(sample.labels), 2)), deep=True)
    pairs.SetName("pairs")
    pairs.SetComponentName(1, "of two")  # VTK writes an empty line for the first
    reader.GetOutput().GetCellData().AddArray(pairs)
    names = numpy_to_vtk(np.zeros((len(sample.points), 1)), deep=True)
    names.SetName("names")
    names.SetComponentName(0, "of one")
    reader.GetOutput().GetPointData().AddArray(names)
    for version in (42, 51):
        writer = vtk.vtkUnstructuredGridWriter()
        writer.SetFileVersion(version)
        writer.SetFileName(sample.path("by-vtk.vtk"))
        writer.SetInputData(reader.GetOutput())
        writer.Write()
        sample.check_tets(sample.points, *dump(sample.path("by-vtk.vtk"))[1:])


def check_meshio(sample):
    labels = np.maximum(sample.labels, 0)
    for name, key in (
        ("m.vtu", "material"),
        ("m.vtk", "material"),
        ("m.mesh", "medit:ref"),
        ("m.msh", "gmsh:physical"),
    ):
        data = {key: [labels]}
        if key == "gmsh:physical":
            data["gmsh:geometrical"] = [labels]
        mesh = meshio.Mesh(sample.points, [("tetra", sample.tets)], cell_data=data)
        for options in (
            [{"file_format": "gmsh22", "binary": b} for b in (False, True)]
            if "msh" in name
            else [{"binary": False}]
            if "vtk" in name
            else [{}]
        ):
            mesh.write(sample.path(name), **options)
            points, tets, got = dump(sample.path(name))
            assert np.abs(points - sample.points).max() < 1e-11
            same(tets.tolist(), sample.tets.tolist(), "tetrahedra of " + name)
            same(got.tolist(), labels.tolist(), "labels of " + name)


if __name__ == "__main__":
    run_checks_with_all_labels(check_own)
    run_checks(check_gmsh, check_partitioned, check_vtk, check_meshio)
