#!/usr/bin/python3
"""Draws docs/images/flow.svg, the data flow of README.md: each step done to a volume of two dimensions.

    tools/draw_flow.py

Needs python3-matplotlib. The mathematics of the library are in docs/method.md; here they are as short as a drawing
allows.
"""
import pathlib

import matplotlib.tri
import numpy as np

OUTPUT = pathlib.Path(__file__).resolve().parent.parent / "docs/images/flow.svg"
PIXELS = 16  # along a side of the volume
COLOURS = ("#d4d6da", "#56b4e9", "#e69f00")  # those that `cleft render` gives labels 0, 1 and 2
BALLS = ((0.44, 0.52, 0.31), (0.66, 0.38, 0.13))  # x, y and radius of the materials 1 and 2
SIDE, GAP, LEFT, TOP = 150, 40, 20, 50  # of the panels
STEPS = (
    ("labels", "one of each voxel"),
    ("sizes", "small at interfaces"),
    ("background mesh", "ignores the boundaries"),
    ("cleaving", "one cut along interfaces"),
    ("improving, fitting", "angles, volumes of labels"),
)


def depths(points):
    """How deep points lie in the materials 0, 1 and 2; the greatest holds. Material 2 wins where balls overlap."""
    first, second = [radius - np.hypot(points[..., 0] - x, points[..., 1] - y) for x, y, radius in BALLS]
    first = np.minimum(first, -second)
    return np.stack([-np.maximum(first, second), first, second], -1)


def sizes(points):
    """Wanted edges: they grow with the distance from the nearest interface."""
    ordered = np.sort(depths(points), axis=-1)
    return np.clip(0.05 + 0.45 * (ordered[..., 2] - ordered[..., 1]) / 2, 0, 0.15)


def background():
    """Points with room in proportion to the sizes, the corners among them, moved to the middle of their neighbours."""
    sides = np.linspace(0, 1, 9)
    points = [(x, y) for x in sides for y in sides if x in (0, 1) or y in (0, 1)]
    for candidate in np.random.RandomState(7).rand(4000, 2) * 0.92 + 0.04:
        if np.hypot(*(np.array(points) - candidate).T).min() > 0.78 * sizes(candidate):
            points.append(candidate)
    points = np.array(points)
    for _ in range(8):
        points = smoothed(points, triangles_of(points), is_fixed=on_sides(points))
    return points, triangles_of(points)


def triangles_of(points):
    return matplotlib.tri.Triangulation(*points.T).triangles


def on_sides(points):
    return ((points == 0) | (points == 1)).any(1)


def smoothed(points, triangles, is_fixed):
    sums, counts = np.zeros_like(points), np.zeros(len(points))
    for a, b in ((0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)):
        np.add.at(sums, triangles[:, a], points[triangles[:, b]])
        np.add.at(counts, triangles[:, a], 1)
    return np.where(is_fixed[:, None], points, sums / counts[:, None])


def tie(start, end):
    """Where the material changes between two points of different materials."""
    label = depths(start).argmax()
    for _ in range(40):
        middle = (start + end) / 2
        start, end = (middle, end) if depths(middle).argmax() == label else (start, middle)
    return (start + end) / 2


def cleaved(points, triangles):
    """Points, triangles of one material each with the material, and which points lie on interfaces. A point near a tie
    moves onto it; other edges are cut."""
    points, labels = points.copy(), depths(points).argmax(1)
    edges = {tuple(sorted(pair)) for t in triangles for pair in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
    on_tie = np.zeros(len(points), bool)
    for a, b in sorted(edges):
        if labels[a] != labels[b] and not on_tie[a] and not on_tie[b]:
            place = tie(points[a], points[b])
            share = np.linalg.norm(place - points[a]) / np.linalg.norm(points[b] - points[a])
            near = a if share < 0.3 else b if share > 0.7 else None
            if near is not None and not on_sides(points)[near]:
                points[near], on_tie[near] = place, True
    new, cuts = list(points), {}

    def cut(a, b):
        key = (min(a, b), max(a, b))
        if key not in cuts:
            cuts[key] = len(new)
            new.append(tie(points[key[0]], points[key[1]]))
        return cuts[key]

    pieces = []
    for triangle in triangles:
        pieces += split(list(triangle), labels, on_tie, cut)
    new = np.array(new)
    return new, pieces, np.append(on_tie, np.ones(len(new) - len(points), bool))


def split(triangle, labels, on_tie, cut):
    """The pieces of a triangle, with their materials."""
    inner = [labels[v] for v in triangle if not on_tie[v]]
    if len(set(inner)) < 2:
        return [(triangle, inner[0] if inner else None)]
    if len(inner) == 2:  # from a point on the interface to the cut of the edge across
        while not on_tie[triangle[0]]:
            triangle = triangle[1:] + triangle[:1]
        a, b, c = triangle
        middle = cut(b, c)
        return [([a, b, middle], labels[b]), ([a, middle, c], labels[c])]
    while labels[triangle[1]] != labels[triangle[2]]:
        triangle = triangle[1:] + triangle[:1]
    a, b, c = triangle
    p, q = cut(a, b), cut(a, c)
    return [([a, p, q], labels[a]), ([p, b, c], labels[b]), ([p, c, q], labels[b])]


class Drawing:
    def __init__(self):
        self.parts, self.shapes = [], {}  # the triangles of each colour as one path

    def add(self, text):
        self.parts.append(text)

    def place(self, panel, point):
        return LEFT + panel * (SIDE + GAP) + SIDE * point[0], TOP + SIDE * (1 - point[1])

    def polygon(self, panel, corners, colour):
        at = "L".join("%.1f %.1f" % self.place(panel, corner) for corner in corners)
        self.shapes[colour] = self.shapes.get(colour, "") + f"M{at}z"

    def text(self, x, y, words, kind):
        self.add(f'<text x="{x:.0f}" y="{y:.0f}" class="{kind}">{words}</text>')

    def arrow(self, panel):
        x, y = LEFT + panel * (SIDE + GAP) + SIDE + 7, TOP + SIDE / 2
        self.add(f'<path class="arrow" d="M{x} {y} h20 m-7 -7 l7 7 l-7 7"/>')

    def svg(self, width, height):
        style = (
            ".pixel { stroke: #33363c; stroke-width: 0.6; stroke-linejoin: round } "
            ".arrow { fill: none; stroke: #33363c; stroke-width: 2 } .size { fill: #f7f8fa; stroke: #0072b2 } "
            "text { font-family: sans-serif; fill: #1c1e22; text-anchor: middle } "
            ".name { font-size: 15px; font-weight: bold } .words { font-size: 12px }"
        )
        frame = f'<rect width="{width}" height="{height}" rx="8" fill="#f7f8fa"/>'
        shapes = [f'<path class="pixel" d="{path}" fill="{colour}"/>' for colour, path in self.shapes.items()]
        body = "\n".join([f"<style>{style}</style>", frame, *shapes, *self.parts])
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}">\n{body}\n</svg>\n'
        )


def draw_pixels(drawing):
    for j in range(PIXELS):
        for i in range(PIXELS):
            label = depths(np.array(((i + 0.5) / PIXELS, (j + 0.5) / PIXELS))).argmax()
            left, low, right, high = i / PIXELS, j / PIXELS, (i + 1) / PIXELS, (j + 1) / PIXELS
            drawing.polygon(0, ((left, low), (right, low), (right, high), (left, high)), COLOURS[label])


def draw_sizes(drawing, points):
    x, y = drawing.place(1, (0, 1))
    drawing.add(f'<rect class="pixel" x="{x}" y="{y}" width="{SIDE}" height="{SIDE}" fill="#ffffff"/>')
    for point in points[~on_sides(points)]:
        x, y = drawing.place(1, point)
        drawing.add(f'<circle class="size" cx="{x:.1f}" cy="{y:.1f}" r="{0.4 * SIDE * sizes(point):.1f}"/>')


def main():
    drawing = Drawing()
    points, triangles = background()
    draw_pixels(drawing)
    draw_sizes(drawing, points)
    for triangle in triangles:
        drawing.polygon(2, points[triangle], "#ffffff")
    points, pieces, on_tie = cleaved(points, triangles)
    corners = np.array([piece for piece, _ in pieces])
    labels = [depths(points[piece].mean(0)).argmax() if label is None else label for piece, label in pieces]
    for panel in (3, 4):
        for piece, label in zip(corners, labels):
            drawing.polygon(panel, points[piece], COLOURS[label])
        for _ in range(4):
            points = smoothed(points, corners, on_tie | on_sides(points))
    for panel, (name, words) in enumerate(STEPS):
        middle = LEFT + panel * (SIDE + GAP) + SIDE / 2
        drawing.text(middle, TOP - 16, name, "name")
        drawing.text(middle, TOP + SIDE + 22, words, "words")
        if panel:
            drawing.arrow(panel - 1)
    width = 2 * LEFT + len(STEPS) * (SIDE + GAP) - GAP
    y = TOP + SIDE + 52
    drawing.text(LEFT + SIDE / 2, y, "from a file or an array", "words")
    drawing.text(width / 2, y, "each step is a call of its own: bring sizes or a background mesh of yours", "words")
    drawing.text(width - LEFT - SIDE / 2 - 10, y, "to solvers, pictures, views", "words")
    OUTPUT.write_text(drawing.svg(width, TOP + SIDE + 68))


main()
