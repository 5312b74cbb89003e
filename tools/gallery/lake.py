"""A lake in the mountains, a million and a half triangles, shortly after sunrise."""

import numpy as np

from gallery import meshes
from gallery.scene import Material, Scene

COUNT = 900
NEAR, FAR, SIDE = 13.0, -34.0, 21.0  # what the camera can see
COUNTRY = 60.0  # across


def noise(u, v, cells, generator):
    """Smooth noise at places from 0 to 1: random numbers on a grid of cells, with steps of fifth degree between."""
    grid = generator.uniform(-1, 1, (cells + 2, cells + 2))

    def step(place):
        cell = (place * cells).astype(int)
        t = place * cells - cell
        return cell, t**3 * (t * (6 * t - 15) + 10)

    (i, s), (j, t) = step(u), step(v)
    rows = grid[i] * (1 - s)[:, None] + grid[i + 1] * s[:, None]
    return rows[:, j] * (1 - t) + rows[:, j + 1] * t


def ridges(x, z):
    """Heights: ridges of ridges, less of the fine ones in the valleys."""
    generator = np.random.default_rng(11)
    height, weight, size = np.zeros((len(x), len(z))), 1.0, 1.0
    for cells in (5, 10, 20, 41, 83, 166, 330):
        ridge = (1 - np.abs(noise(x / COUNTRY + 0.5, (z + 44) / COUNTRY, cells, generator))) ** 2.2
        height += size * ridge * weight
        weight = np.clip(ridge * 1.25, 0, 1)
        size *= 0.46
    return height / 1.55


def build():
    scene = Scene(eye=(0.0, 1.35, 15.0), target=(0.0, 2.0, -10.0), fov=33)
    x, z = np.linspace(-SIDE, SIDE, COUNT), np.linspace(FAR, NEAR, COUNT)
    height = ridges(x, z)
    x, z = np.meshgrid(x, z, indexing="ij")
    shore = np.clip(np.hypot(x / 11.5, (z - 6) / 12) - 0.62, 0, 1)
    y = height * (0.6 + 6.5 * shore**1.3) - 0.95
    ground = meshes.sheet(np.stack([x, y, z], axis=-1)[:, ::-1]).smooth()
    middle = ground.points[ground.faces].mean(axis=1)
    steep = ground.normals[ground.faces].mean(axis=1)[:, 1]
    snow = (middle[:, 1] > 2.4 + 1.2 * np.sin(middle[:, 0]) * np.sin(middle[:, 2])) & (steep > 0.62)
    meadow = ~snow & (middle[:, 1] < 1.5) & (steep > 0.80)
    for chosen, color, ambient in ((snow, (0.92, 0.90, 0.94), (0.22, 0.26, 0.38)),
                                   (meadow, (0.36, 0.38, 0.20), (0.06, 0.08, 0.10)),
                                   (~snow & ~meadow, (0.46, 0.38, 0.34), (0.09, 0.10, 0.15))):
        scene.mesh(ground.part(chosen), Material(color, ambient, 0.9))
    scene.plane((0, 0, 0), (0, 1, 0), Material((0.02, 0.05, 0.08), 0.8, 0.2, 0, 20, (0.62, 0.66, 0.70)))
    # The sky is a wall far behind; a light before it makes it bright where the sun has come up.
    scene.plane((0, 0, -200), (0, 0, 1), Material((0.30, 0.22, 0.10), (0.02, 0.25, 0.58), 0.8))
    scene.light((-24, 5, -178), (2.6, 2.2, 2.0))
    scene.light((-70, 24, 30), (1.35, 0.90, 0.56), radius=1.5)
    return scene
