"""A Menger sponge, four subdivisions deep, lit from within in two colours."""

import itertools

import numpy as np

from gallery import meshes
from gallery.scene import Material, Scene

LEVEL = 4


def solid(level):
    """Which of the cells of a cube of 3^level are full."""
    cell = np.ones((1, 1, 1), dtype=bool)
    rule = np.ones((3, 3, 3), dtype=bool)
    for x, y, z in itertools.product(range(3), repeat=3):
        rule[x, y, z] = [x, y, z].count(1) < 2
    for _ in range(level):
        cell = np.kron(cell, rule)
    return cell


def sponge(level):
    """Its faces alone, in a cube from -1 to 1."""
    cell = np.pad(solid(level), 1)
    quads = []
    for face in meshes.BOX_FACES:
        corners = meshes.BOX[face]
        outward = np.rint(2 * corners.mean(axis=0) - 1).astype(int)
        seen = cell & ~np.roll(cell, -outward, axis=(0, 1, 2))
        quads.append(np.argwhere(seen)[:, None] - 1 + corners)
    points = np.concatenate(quads).reshape(-1, 3) * (2 / 3**level) - 1
    points, faces = np.unique(np.rint((points + 1) * 3**level / 2).astype(int), axis=0, return_inverse=True)
    return meshes.Mesh(points * (2 / 3**level) - 1, faces.reshape(-1, 4))


def build():
    scene = Scene(eye=(2.7, 2.5, 4.3), target=(0.06, -0.2, 0.0), fov=33)
    scene.mesh(sponge(LEVEL), Material((0.92, 0.90, 0.94), (0.012, 0.012, 0.03), 0.9, 0.05, 10))
    scene.plane((0, -1.0, 0), (0, 1, 0), Material((0.55, 0.55, 0.62), (0.01, 0.01, 0.025), 0.7, 0.1, 10, 0.15))
    scene.light((0, 0, 0), (1.0, 0.20, 0.62), radius=0.12)
    scene.light((0, 1.9, 0.0), (0.06, 0.66, 0.85), radius=0.25)
    scene.light((-1.5, 0.6, 4.0), (0.16, 0.34, 0.90), radius=0.3)
    scene.light((5, 1.5, 0.5), (0.85, 0.36, 0.12), radius=0.4)
    return scene
