"""VTK reads .vtu, .vtp, .vtk, .ply and .stl."""
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from sample import NAME, run_checks_with_all_labels, same, word


def read(reader, path):
    failures = []
    reader.AddObserver("ErrorEvent", lambda *_: failures.append(path))
    reader.SetFileName(path)
    reader.Update()
    same(failures, [], "errors of VTK")
    return reader.GetOutput()


def check_grid(sample, grid):
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    same(set(vtk_to_numpy(grid.GetCellTypesArray()).tolist()), {vtk.VTK_TETRA}, "types of cells")
    sample.check_tets(
        vtk_to_numpy(grid.GetPoints().GetData()), cells, vtk_to_numpy(grid.GetCellData().GetArray("material"))
    )


def check_names(sample, data):
    fields = data.GetFieldData()
    names = {
        fields.GetArrayName(i): vtk_to_numpy(fields.GetArray(i)).tolist() for i in range(fields.GetNumberOfArrays())
    }
    same(names, {"material_%s %s" % (word(sample.named), NAME): [sample.named]}, "names")


def check_vtu(sample):
    grid = read(vtk.vtkXMLUnstructuredGridReader(), sample.path("vtu.vtu"))
    check_grid(sample, grid)
    check_names(sample, grid)


def check_legacy_vtk(sample):
    check_grid(sample, read(vtk.vtkUnstructuredGridReader(), sample.path("vtk.vtk")))


def triangles_of(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData())
    return points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]


def check_vtp(sample):
    surface = read(vtk.vtkXMLPolyDataReader(), sample.path("vtp.vtp"))
    same(triangles_of(surface).tolist(), sample.points[sample.interface[:, :3]].tolist(), "triangles")
    check_names(sample, surface)
    for number in (1, 2):
        labels = vtk_to_numpy(surface.GetCellData().GetArray("material_%d" % number))
        same(labels.tolist(), sample.interface[:, 2 + number].tolist(), "labels")


def check_ply(sample):
    surface = read(vtk.vtkPLYReader(), sample.path("ply.ply"))
    wanted = sample.points[sample.interface[:, :3]].astype("f4")  # VTK keeps no more
    same(triangles_of(surface).tolist(), wanted.tolist(), "triangles")


def check_all_of_ply(sample):
    """VTK passes over labels and digits of PLY: see what its header says is there."""
    data = open(sample.path("ply.ply"), "rb").read()
    header, body = data.split(b"end_header\n", 1)
    counts = [int(line.split()[2]) for line in header.decode().splitlines() if line.startswith("element")]
    same(header.decode().count("property double"), 3, "doubles")
    points = np.frombuffer(body, "<f8", 3 * counts[0]).reshape(-1, 3)
    faces = np.frombuffer(body, [("n", "u1"), ("corners", "<i4", 3), ("labels", "<i4", 2)], counts[1], points.nbytes)
    same(len(body), points.nbytes + faces.nbytes, "bytes")
    same(points[faces["corners"]].tolist(), sample.points[sample.interface[:, :3]].tolist(), "triangles")
    same(faces["labels"].tolist(), sample.interface[:, 3:].tolist(), "labels")


def check_stl(sample):
    reader = vtk.vtkSTLReader()
    reader.MergingOff()
    surface = read(reader, sample.path("stl.stl"))
    wanted = sample.points[sample.interface[:, :3]].astype("f4")
    same(triangles_of(surface).tolist(), wanted.tolist(), "triangles")


run_checks_with_all_labels(check_vtu, check_legacy_vtk, check_vtp, check_ply, check_all_of_ply, check_stl)
