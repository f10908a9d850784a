#!/usr/bin/python3
"""From a segmentation to a mesh to a picture, cell by cell:

    atlas_to_picture.py [VOLUME [FOLDER]]

VOLUME is any label map that cleft reads (NIfTI, NRRD, MetaImage ...); mesh and pictures go to FOLDER. Without a VOLUME,
one is made. Editors that know "# %%" run the cells one at a time, as a notebook. Needs matplotlib.
"""
# %% What to mesh
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")  # pictures go to files; leave this out to look at them in windows
import matplotlib.pyplot as pyplot
import numpy as np

import cleft

folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ".")
if len(sys.argv) > 1:
    volume = cleft.read_volume(sys.argv[1], world="RAS")
else:
    i, j, k = np.ogrid[:32, :32, :32]
    labels = ((i - 16) ** 2 + (j - 16) ** 2 + (k - 16) ** 2 < 140).astype(np.uint8)  # labels[i, j, k], i along x
    labels[(labels == 1) & (i > 16)] = 2
    volume = cleft.Volume(labels, spacing=(1, 1, 1))
print(volume)
for label, voxels in volume.voxel_counts.items():
    print(f"  label {label}: {voxels} voxels")

# %% How long the edges want to be, from the features of the volume: a slice through the middle
sizing = cleft.Sizing(volume)
print(sizing)
middle = sizing.shape[2] // 2
figure, axes = pyplot.subplots()
drawn = axes.imshow(sizing.values[:, :, middle].T, origin="lower")  # imshow wants rows first
figure.colorbar(drawn, label="edge length")
figure.savefig(folder / "sizing.png")


# %% The mesh, with a line of progress
def progress(fraction, stage):
    if sys.stderr.isatty():
        print(f"\r{100 * fraction:3.0f} % {stage:40}", end="", file=sys.stderr)


mesher = cleft.Mesher(threads=0, progress=progress)
mesh = cleft.mesh(volume, sizing=sizing, mesher=mesher)
print(mesh)

# %% Is it good, and is every label there?
check = mesh.validate(fills_box=True)
quality = mesh.quality()
print(f"valid: {check.valid}, dihedral angles {quality.min_dihedral:.1f} to {quality.max_dihedral:.1f} degrees")
for row in mesh.report(volume):
    print(f"  label {row.label}: {row.tets} tetrahedra, volume {row.mesh_volume:.1f}, in voxels {row.voxel_volume:.1f}")

# %% The arrays are numpy's: the share of each label, by hand
corners = mesh.points[mesh.tets]
volumes = (
    np.einsum(
        "ij,ij->i",
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]),
        corners[:, 3] - corners[:, 0],
    )
    / 6
)
for label in mesh.different_labels:
    print(f"  label {label}: {100 * volumes[mesh.labels == label].sum() / volumes.sum():.1f} % of the box")

# %% A file for ParaView, and a picture without the first label, which is most often the outside
mesh.write(folder / "mesh.vtu")
inside = [int(label) for label in mesh.different_labels[1:]]
axes = mesh.plot(inside, backend="matplotlib")
axes.figure.savefig(folder / "mesh.png", dpi=150)
print(f"{folder / 'mesh.vtu'}, {folder / 'mesh.png'} and {folder / 'sizing.png'} are written")
