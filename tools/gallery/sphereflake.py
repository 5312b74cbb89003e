"""Balls on balls on balls, five generations of nine, in the last light of the day."""

import numpy as np

from gallery.scene import Material, Scene, unit


def children(axis):
    """Directions of nine balls about a ball: six around its equator, three above it."""
    side = unit(np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))]))
    other = np.cross(axis, side)
    for count, height, start in ((6, 0.0, 0.0), (3, np.sqrt(2 / 3), np.pi / 6)):
        for k in range(count):
            angle = start + 2 * np.pi * k / count
            yield height * axis + np.sqrt(1 - height**2) * (np.cos(angle) * side + np.sin(angle) * other)


GOLD = [Material((1.0, 0.72, 0.32), 0.10, 0.35, (0.9, 0.75, 0.5), 60, (0.62, 0.46, 0.24)),
        Material((1.0, 0.68, 0.30), 0.12, 0.50, (0.8, 0.6, 0.4), 60, (0.50, 0.34, 0.18)),
        Material((1.0, 0.62, 0.26), 0.14, 0.65, (0.7, 0.5, 0.3), 50, (0.30, 0.20, 0.10)),
        Material((1.0, 0.60, 0.26), 0.20, 0.90, (0.6, 0.4, 0.3), 40, (0.15, 0.08, 0.05)),
        Material((1.0, 0.54, 0.24), 0.24, 1.0, (0.5, 0.3, 0.2), 30)]


def grow(scene, center, radius, axis, generation):
    scene.sphere(center, radius, GOLD[generation])
    if generation + 1 < len(GOLD):
        for direction in children(axis):
            grow(scene, center + direction * radius * 4 / 3, radius / 3, direction, generation + 1)


def build():
    scene = Scene(eye=(0.5, 0.75, 8.2), target=(0.2, 0.68, 0.0), fov=27)
    grow(scene, np.array([0.0, 0.66, 0.0]), 1.0, unit([0.12, 1.0, 0.30]), 0)
    scene.plane((0, -0.9, 0), (0, 1, 0), Material((0.50, 0.36, 0.34), (0.085, 0.06, 0.11), 0.72, 0.1, 8, 0.20))
    # The evening sky: a wall far behind, and the glow of a light before it, where the sun has just gone.
    sky = Material((0.42, 0.24, 0.09), (0.11, 0.13, 0.28), 1.0)
    scene.plane((0, 0, -60), (0, 0, 1), sky)
    scene.light((-12, 1.0, -53), (1.2, 1.2, 0.9))
    # Behind the camera, for the mirrors.
    scene.plane((0, 0, 60), (0, 0, -1), sky)
    scene.light((-8, 5.0, 6.0), (1.05, 0.86, 0.55), radius=0.8)
    scene.light((6, 7, 2), (0.18, 0.16, 0.30), radius=2.0)
    return scene
