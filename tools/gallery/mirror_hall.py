"""A hall whose walls are mirrors."""

import numpy as np

from gallery import meshes
from gallery.scene import Material, Scene, glow

HALF, HEIGHT = 3.0, 4.2


def tiles(odd):
    """The black or the white tiles of the floor."""
    corners = [(x, z) for x in range(-3, 3) for z in range(-8, 6) if (x + z) % 2 == odd]
    points = np.array([[(x, 0, z), (x, 0, z + 1), (x + 1, 0, z + 1), (x + 1, 0, z)] for x, z in corners], dtype=float)
    return meshes.Mesh(points.reshape(-1, 3), np.arange(4 * len(corners)).reshape(-1, 4))


def build():
    scene = Scene(eye=(1.3, 1.65, 4.6), target=(-0.75, 1.35, -4.0), fov=62)
    mirror = Material((0.02, 0.03, 0.03), 0.3, 0.5, 0.0, 20, (0.86, 0.90, 0.88))
    scene.plane((-HALF, 0, 0), (1, 0, 0), mirror)
    scene.plane((HALF, 0, 0), (-1, 0, 0), mirror)
    scene.plane((0, 0, -8), (0, 0, 1), mirror)
    scene.plane((0, 0, 6), (0, 0, -1), mirror)
    scene.mesh(tiles(0), Material((0.05, 0.06, 0.09), 0.3, 0.8, 0.2, 60, 0.25))
    scene.mesh(tiles(1), Material((0.70, 0.68, 0.64), 0.14, 0.7, 0.2, 60, 0.12))
    scene.plane((0, HEIGHT, 0), (0, -1, 0), Material((0.26, 0.20, 0.34), 0.35, 0.8))
    column = meshes.lathe(meshes.curve([(0.34, 0), (0.34, 0.2), (0.22, 0.32), (0.20, 2.0), (0.18, 3.7), (0.32, 3.95),
                                        (0.34, HEIGHT)], 12), 96).smooth()
    brass = Material((0.72, 0.46, 0.18), 0.16, 0.6, (0.8, 0.6, 0.3), 60, (0.34, 0.22, 0.08))
    for z in (-6, -2, 2):
        for x in (-2.2, 2.2):
            scene.mesh(column.moved((x, 0, z)), brass)
    colors = ((0.9, 0.12, 0.22), (0.10, 0.5, 0.9), (0.95, 0.7, 0.1), (0.1, 0.65, 0.45))
    for k, (x, z, r) in enumerate(((-0.6, -3.6, 0.75), (0.9, -1.6, 0.5), (-1.1, -0.6, 0.38), (0.55, -5.6, 0.6))):
        scene.sphere((x, r, z), r, Material(colors[k], 0.14, 0.75, 0.6, 80, 0.12))
    for z in (-4.0, 0.0, 4.0):
        scene.sphere((0, 3.5, z), 0.24, glow((1.0, 0.92, 0.75)))
        scene.light((0, 3.5, z), (0.50, 0.44, 0.36), radius=0.26)
    return scene
