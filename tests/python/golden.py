"""The golden case of tests/golden/README.md."""
import numpy as np

import cleft


def fnv1a(data):
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return value


i, j, k = np.ogrid[:16, :14, :12]
labels = np.zeros((16, 14, 12), np.uint8)
labels[(i - 5) ** 2 + (j - 6) ** 2 + (k - 5) ** 2 <= 17] = 3
labels[(i - 10) ** 2 + (j - 7) ** 2 + (k - 6) ** 2 <= 14] = 200
affine = [[1, 0, 0, -4.5], [0, 1.25, 0, 2.25], [0, 0, 1.5, 100]]
options = cleft.Options(background="particles")
volume = cleft.Volume(labels, affine=affine, options=options)
mesh = cleft.mesh(volume, options=options, mesher=cleft.Mesher(threads=1))
print("%016x" % fnv1a(mesh.points.tobytes() + mesh.tets.tobytes() + mesh.labels.tobytes()))
