"""The scenes of the benchmark: each is hard in a way of its own, and the last one in all of them.

Each is generated for the size of the image, so that another size is another rendering of the same view. Random
numbers have fixed seeds. Errors are means over the whole image, so what is hard must fill it.
"""

import math
import random
from dataclasses import dataclass

BLACK = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class BenchScene:
    name: str
    hard: str  # what it demands of a sampler, in a few words
    text: str
    meshes: dict  # file name -> OBJ text
    slopes_only: bool = False  # left out of the equal-error and target tables
    variant: bool = False  # of another scene, only for the comparison with POV-Ray


class Builder:
    """Writes the scene format; colours are (r, g, b) or one number for grey."""

    def __init__(self, size, fov, position=(0, 0, 0)):
        width, height = size
        focal = height / (2 * math.tan(math.radians(fov) / 2))
        self.blocks = []
        self.meshes = {}
        self.block("camera", pos=position, fov=fov, f=focal, a=width / height)

    def block(self, kind, **keys):
        lines = [kind]
        for key, value in keys.items():
            numbers = value if isinstance(value, (tuple, list)) else [value]
            lines.append(f"{key}: " + " ".join(str(number) for number in numbers))
        self.blocks.append("\n".join(lines))

    @staticmethod
    def material(amb=BLACK, dif=BLACK, spe=BLACK, shi=1, ref=None):
        keys = {"amb": rgb(amb), "dif": rgb(dif), "spe": rgb(spe), "shi": shi}
        if ref is not None:
            keys["ref"] = rgb(ref)
        return keys

    def plane(self, normal, position, **material):
        self.block("plane", nor=normal, pos=position, **self.material(**material))

    def sphere(self, position, radius, **material):
        self.block("sphere", pos=position, rad=radius, **self.material(**material))

    def triangle(self, corners, **material):
        a, b, c = corners
        self.block("triangle", v1=a, v2=b, v3=c, **self.material(**material))

    def mesh(self, file, obj, **material):
        self.meshes[file] = obj
        self.block("mesh", file=file, **self.material(**material))

    def light(self, position, color, ambient=0.0, radius=0.0):
        keys = {"pos": position, "amb": rgb(ambient), "dif": rgb(color), "spe": rgb(color)}
        if radius > 0:
            keys["rad"] = radius
        self.block("light", **keys)

    def scene(self, name, hard, slopes_only=False):
        text = "\n".join([str(len(self.blocks)), *self.blocks]) + "\n"
        return BenchScene(name, hard, text, self.meshes, slopes_only)


def rgb(color):
    return color if isinstance(color, tuple) else (color, color, color)


def random_color(rng, low=0.05, high=1.0):
    return tuple(round(rng.uniform(low, high), 3) for _ in range(3))


def copies_of(obj, places):
    """The OBJ's surface once for each (x, y, z, scale), as one OBJ."""
    vertices, others, faces = [], [], []
    for line in obj.splitlines():
        kind = line.split(None, 1)[0] if line.strip() else ""
        if kind == "v":
            vertices.append([float(word) for word in line.split()[1:4]])
        elif kind == "vn":
            others.append(line)
        elif kind == "f":
            corners = line.split()[1:]
            faces.append([[int(index) if index else 0 for index in corner.split("/")] for corner in corners])
    middle = [(min(axis) + max(axis)) / 2 for axis in zip(*vertices)]
    lines = list(others)
    for copy, (x, y, z, scale) in enumerate(places):
        for vertex in vertices:
            moved = [at + scale * (v - m) for at, v, m in zip((x, y, z), vertex, middle)]
            lines.append("v " + " ".join(f"{v:.6f}" for v in moved))
        first = copy * len(vertices)
        for face in faces:  # normals are not copied, so their indices stay
            lines.append("f " + " ".join(corner_text(corner, first) for corner in face))
    return "\n".join(lines) + "\n"


def corner_text(corner, first):
    words = [str(corner[0] + first)] + [str(index) if index else "" for index in corner[1:]]
    return "/".join(words)


def edges(size, _models):
    """Overlapping triangles of constant colour: only edges, in all directions."""
    builder = Builder(size, 60)
    rng = random.Random(1)
    for index in range(150):
        z = -10 - 0.01 * index
        x, y = rng.uniform(-8, 8), rng.uniform(-6, 6)
        turn = rng.uniform(0, 2 * math.pi)
        corners = [
            (x + 1.8 * math.cos(turn + bend), y + 1.8 * math.sin(turn + bend), z)
            for bend in (0, rng.uniform(0.4, 2.2), rng.uniform(3.0, 5.0))
        ]
        builder.triangle(corners, amb=random_color(rng))
    return builder.scene("edges", "silhouettes everywhere")


def penumbra(size, _models):
    """Balls and bars that float before a wall, and two wide lamps: soft shadows over most of the image."""
    builder = Builder(size, 50, (0, 3.5, 9))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.05, dif=(0.8, 0.75, 0.7))
    builder.plane((0, 0, 1), (0, 0, -8), amb=0.05, dif=(0.6, 0.66, 0.72))
    for index in range(6):
        x = -7.5 + 2.9 * index
        builder.triangle([(x, 0.8, -3), (x + 0.5, 0.6, -3), (x + 1.4, 7.5, -4)], amb=0.1, dif=0.5)
        builder.sphere((x + 1.4, 1.2 + 1.5 * (index % 4), -4.5), 0.7, amb=0.1, dif=(0.6, 0.4, 0.3), spe=0.3, shi=20)
    builder.light((3, 6, 9), (0.7, 0.68, 0.62), radius=2.0)
    builder.light((-9, 8, 4), (0.3, 0.32, 0.4), radius=1.0)
    return builder.scene("penumbra", "wide soft shadows")


def mirrors(size, _models):
    """A corridor between two mirrors, with mirror balls: reflections of reflections, ever smaller."""
    builder = Builder(size, 70, (0.6, 1.5, 5))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.12, dif=(0.5, 0.45, 0.4), ref=0.2)
    builder.plane((1, 0, 0), (-3, 0, 0), amb=0.01, ref=(0.85, 0.88, 0.86))
    builder.plane((1, 0, 0), (3, 0, 0), amb=0.01, ref=(0.86, 0.85, 0.88))
    builder.plane((0, 0, 1), (0, 0, -7), amb=(0.15, 0.2, 0.3), dif=(0.3, 0.4, 0.5))
    rng = random.Random(2)
    for index in range(12):
        position = (rng.uniform(-2.4, 2.4), rng.uniform(0.4, 3.2), rng.uniform(-6, 1.5))
        shine = {"spe": 0.5, "shi": 40, "ref": 0.5 if index % 3 == 0 else 0.0}
        builder.sphere(position, rng.uniform(0.25, 0.6), amb=random_color(rng, 0.02, 0.2),
                       dif=random_color(rng, 0.1, 0.7), **shine)
    builder.light((0.5, 6, 2), 0.8, ambient=0.1)
    return builder.scene("mirrors", "reflections of reflections")


def mesh(size, models):
    """Rings and knots that recede until a facet, and then a whole ring, is smaller than a pixel."""
    builder = Builder(size, 40, (0, 6, 14))
    builder.plane((0, 1, 0), (0, -1.2, 0), amb=0.25, dif=0.5)
    builder.plane((0, 0, 1), (0, 0, -60), amb=(0.3, 0.35, 0.4))
    rings = [(-9 - 1.5 * j + (3 + 0.5 * j) * i, 0.6, 3 - 9.0 * j, 0.55) for j in range(3) for i in range(7)]
    rings += [(-17 + 3.4 * i + 0.7 * j, 8.5 + 3.1 * j, -18 - 9.0 * j, 0.5) for j in range(3) for i in range(11)]
    knots = [(5.5, 4.0, -14, 1.0)]
    builder.mesh("rings.obj", copies_of(models["torus"], rings), amb=0.1, dif=(0.8, 0.5, 0.2), spe=0.6, shi=60)
    builder.mesh("knots.obj", copies_of(models["knot"], knots), amb=0.1, dif=(0.2, 0.5, 0.8), spe=0.6, shi=60)
    builder.light((-12, 18, 16), 0.9, ambient=0.1)
    return builder.scene("mesh", "mesh detail at a distance")


def lights(size, _models):
    """Sixteen lamps, every second one with a radius: many faint shadow edges in each pixel."""
    builder = Builder(size, 50, (0, 3, 9))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.05, dif=0.8)
    builder.plane((0, 0, 1), (0, 0, -8), amb=0.05, dif=0.7)
    rng = random.Random(3)
    for index in range(12):
        position = (-5.4 + 0.98 * index, rng.uniform(0.5, 5), rng.uniform(-6, 2))
        builder.sphere(position, 0.5, amb=random_color(rng, 0.02, 0.1), dif=random_color(rng, 0.3, 0.9), spe=0.4,
                       shi=50)
    for index in range(16):
        angle = 2 * math.pi * index / 16
        color = tuple(0.12 * channel for channel in random_color(rng, 0.3, 1.0))
        builder.light((9 * math.cos(angle), rng.uniform(2, 6), 2 + 7 * math.sin(angle)), color, ambient=0.02,
                      radius=0.3 if index % 2 else 0.0)
    return builder.scene("lights", "16 lights, half of them soft")


def tiny(size, _models):
    """Bright balls of a tenth to nine tenths of a pixel across: most samples miss them."""
    width, height = size
    builder = Builder(size, 60)
    pixel = 2 * 20 * math.tan(math.radians(30)) / height
    rng = random.Random(4)
    builder.plane((0, 0, 1), (0, 0, -30), amb=(0.05, 0.07, 0.12))
    builder.sphere((-4, 2, -22), 2.5, amb=(0.3, 0.2, 0.1))
    for row in range(18):
        for column in range(24):
            x = (column + rng.random()) / 24 - 0.5
            y = (row + rng.random()) / 18 - 0.5
            builder.sphere((x * width * pixel, y * height * pixel, -20), rng.uniform(0.05, 0.45) * pixel,
                           amb=random_color(rng, 0.6, 1.0))
    return builder.scene("tiny", "balls smaller than a pixel")


def horizon(size, _models):
    """A plane seen at a grazing angle, and rows of balls with their shadows out to the horizon."""
    builder = Builder(size, 45, (0, 0.7, 3))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.1, dif=(0.6, 0.6, 0.5), spe=0.5, shi=60)
    for row in range(18):
        z = -1.2 * 1.33**row
        for column in range(-7, 8):
            tint = (0.8, 0.3, 0.2) if (row + column) % 2 else (0.2, 0.4, 0.8)
            builder.sphere((column * (0.7 + 0.2 * row), 0.25, z), 0.25, amb=tuple(0.2 * t for t in tint), dif=tint,
                           spe=0.5, shi=30)
    builder.light((300, 400, -200), 0.9, ambient=0.1)
    return builder.scene("horizon", "a grazing plane to the horizon")


def everything(size, models):
    builder = Builder(size, 50, (0, 2.2, 8))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.08, dif=(0.5, 0.48, 0.42), spe=0.2, shi=30, ref=0.15)
    builder.sphere((-2.4, 1.3, -1), 1.3, amb=0.05, dif=0.15, spe=0.7, shi=200, ref=(0.7, 0.7, 0.75))
    builder.sphere((2.8, 0.9, 0.5), 0.9, amb=0.05, dif=(0.3, 0.2, 0.05), spe=0.7, shi=150, ref=(0.6, 0.45, 0.2))
    knot = copies_of(models["knot"], [(0.4, 1.6, -3, 0.65)])
    builder.mesh("knot.obj", knot, amb=0.08, dif=(0.7, 0.3, 0.2), spe=0.5, shi=45)
    rng = random.Random(5)
    for row in range(14):
        for column in range(-5, 6):
            radius = 0.18 if row else 0.03
            builder.sphere((column * (1.0 + 0.35 * row), radius, 3.0 - 1.1 * 1.35**row), radius,
                           amb=random_color(rng, 0.05, 0.2), dif=random_color(rng, 0.2, 0.8), spe=0.4, shi=40)
    builder.light((-5, 8, 6), (0.6, 0.58, 0.52), ambient=0.1, radius=1.2)
    builder.light((7, 6, 3), (0.3, 0.32, 0.36), ambient=0.05, radius=0.4)
    builder.light((0, 9, -12), 0.15)
    return builder.scene("all", "all of these together")


def smooth(size, _models):
    """One wall, and highlights a few pixels wide: shading that curves, without an edge."""
    builder = Builder(size, 40)
    builder.plane((0, 0, 1), (0, 0, -10), amb=0.05, dif=0.02, spe=0.9, shi=3000)
    for row in range(3):
        for column in range(4):
            builder.light((-7.5 + 5.0 * column, -5.0 + 5.0 * row, 1), 0.8)
    return builder.scene("smooth", "curved shading, no edge", slopes_only=True)


GENERATORS = {
    "edges": edges, "penumbra": penumbra, "mirrors": mirrors, "mesh": mesh, "lights": lights, "tiny": tiny,
    "horizon": horizon, "all": everything, "smooth": smooth,
}


def make_scenes(names, size, models):
    """The named scenes; `models` are OBJ texts by name ("torus", "knot")."""
    return [GENERATORS[name](size, models) for name in names]
