#!/usr/bin/python3
"""Draws a mesh cut open, coloured by material: the pictures of README.md and docs/guide.md.

    xvfb-run -a docs/render_mesh.py MESH.vtu PICTURE.png [--leave-out 0] [--cut y] [--at 0.5]

Whole tetrahedra are taken away in front of the cut, so that the elements show inside as they are.
Needs python3-vtk9 and, without a screen, xvfb.
"""
import argparse
import colorsys

import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

AXES = {"x": 0, "y": 1, "z": 2}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("mesh")
    parser.add_argument("picture")
    parser.add_argument("--leave-out", type=int, nargs="*", default=[], help="labels that are not drawn")
    parser.add_argument("--cut", choices=sorted(AXES), default="y", help="axis across which the mesh is cut")
    parser.add_argument("--at", type=float, default=0.5, help="where, as a share of the box")
    parser.add_argument("--whole", type=int, nargs="*", default=[], help="labels that are not cut")
    parser.add_argument("--view", type=float, nargs=3, default=(-0.5, -1.0, 0.6), help="direction to the eye")
    parser.add_argument("--up", type=float, nargs=3, default=(0.0, 0.0, 1.0))
    parser.add_argument("--zoom", type=float, default=1.25)
    parser.add_argument("--pixels", type=int, nargs=2, default=(800, 640))
    parser.add_argument("--line-width", type=float, default=1.0)
    return parser.parse_args()


def read(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def kept_cells(grid, options):
    """A selection of the cells behind the cut, as an array of 0 and 1."""
    centers = vtk.vtkCellCenters()
    centers.SetInputData(grid)
    centers.Update()
    along = vtk_to_numpy(centers.GetOutput().GetPoints().GetData())[:, AXES[options.cut]]
    low, high = grid.GetBounds()[2 * AXES[options.cut] :][:2]
    # The eye looks at the side that the cut opens.
    sign = 1 if options.view[AXES[options.cut]] < 0 else -1
    keep = sign * along > sign * (low + options.at * (high - low))
    material = vtk_to_numpy(grid.GetCellData().GetArray("material"))
    for label in options.whole:
        keep |= material == label
    for label in options.leave_out:
        keep &= material != label
    return keep


def surface_of(grid, keep):
    array = numpy_to_vtk(keep.astype("uint8"), deep=True)
    array.SetName("keep")
    grid.GetCellData().AddArray(array)
    threshold = vtk.vtkThreshold()
    threshold.SetInputData(grid)
    threshold.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "keep")
    threshold.SetLowerThreshold(0.5)
    threshold.SetUpperThreshold(1.5)
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputConnection(threshold.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def color(rank):
    """Grey for the first label, most often the outside; then hues in golden steps, which differ well for neighbours."""
    if rank == 0:
        return 0.82, 0.84, 0.86
    return colorsys.hsv_to_rgb((0.58 + 0.618034 * rank) % 1.0, 0.45 + 0.2 * (rank % 2), 0.95 - 0.12 * (rank % 3))


def paint(surface, ranks):
    colors = vtk.vtkUnsignedCharArray()
    colors.SetName("colors")
    colors.SetNumberOfComponents(3)
    for label in vtk_to_numpy(surface.GetCellData().GetArray("material")):
        colors.InsertNextTuple3(*[255 * part for part in color(ranks[int(label)])])
    surface.GetCellData().SetScalars(colors)


def draw(surface, options):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.12, 0.12, 0.15)
    look.SetLineWidth(options.line_width)
    look.SetAmbient(0.25)
    look.SetDiffuse(0.8)

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    center = actor.GetCenter()
    camera.SetFocalPoint(center)
    camera.SetPosition([center[i] + options.view[i] for i in range(3)])
    camera.SetViewUp(options.up)
    renderer.ResetCamera()
    camera.Zoom(options.zoom)
    renderer.ResetCameraClippingRange()

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*options.pixels)
    window.AddRenderer(renderer)
    window.Render()
    return window


def save(window, path):
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def main():
    options = arguments()
    grid = read(options.mesh)
    labels = sorted(set(vtk_to_numpy(grid.GetCellData().GetArray("material")).tolist()))
    surface = surface_of(grid, kept_cells(grid, options))
    paint(surface, {label: rank for rank, label in enumerate(labels)})
    save(draw(surface, options), options.picture)


if __name__ == "__main__":
    main()
