"""A brass model of the planets about a lamp."""

import numpy as np

from gallery import meshes
from gallery.scene import Material, Scene, glow

BRASS = Material((0.95, 0.64, 0.26), 0.10, 0.85, (1.0, 0.8, 0.45), 40, (0.30, 0.21, 0.10))
PLANETS = ((0.95, 0.14, 215, (0.72, 0.64, 0.56)), (1.35, 0.22, 330, (0.96, 0.70, 0.36)),
           (1.80, 0.27, 62, (0.20, 0.46, 0.90)), (2.22, 0.20, 138, (0.90, 0.32, 0.15)),
           (2.80, 0.50, 248, (0.90, 0.66, 0.44)), (3.30, 0.36, 14, (0.92, 0.82, 0.56)))
STARS = ((1.0, 0.95, 0.9), (0.8, 0.88, 1.0), (1.0, 0.82, 0.62))


def around(radius, degrees, height=0.0):
    angle = np.radians(degrees)
    return np.array([radius * np.cos(angle), height, radius * np.sin(angle)])


def build():
    scene = Scene(eye=(0.0, 4.1, 9.0), target=(0.0, -0.15, 0.0), fov=33)
    table = meshes.curve([(0.01, -1.5), (4.15, -1.5), (4.2, -1.52), (4.25, -1.58), (4.25, -1.7)], 16)
    scene.mesh(meshes.lathe(table, 512).smooth(),
               Material((0.34, 0.16, 0.10), (0.02, 0.02, 0.035), 0.9, 0.25, 30, 0.16))
    dice = np.random.default_rng(3)
    for x, y, size in zip(dice.uniform(-34, 34, 700), dice.uniform(-46, 8, 700), dice.exponential(0.022, 700)):
        scene.sphere((x, y, -40), 0.03 + size, glow(dice.uniform(0.5, 1.0) * np.array(dice.choice(STARS))))
    scene.sphere((0, 0.25, 0), 0.42, glow((1.0, 0.90, 0.62)))
    scene.light((0, 0.25, 0), (0.95, 0.84, 0.62), radius=0.43)
    stand = [(1.1, -1.5), (1.1, -1.42), (0.9, -1.36), (0.35, -1.22), (0.14, -1.0), (0.12, -0.5), (0.20, -0.42),
             (0.10, -0.3), (0.09, -0.12), (0.2, -0.1)]
    scene.mesh(meshes.lathe(meshes.curve(stand, 16), 160).smooth(), BRASS)
    for radius, size, degrees, color in PLANETS:
        scene.mesh(meshes.ring(radius, 0.032), BRASS)
        place = around(radius, degrees, 0.25)
        scene.sphere(place, size, Material(color, 0.05, 0.9, 0.15, 20))
        scene.mesh(meshes.tube([around(radius, degrees), place], 0.026, 16), BRASS)
        scene.mesh(meshes.tube([around(0.08, degrees, -0.25), around(radius, degrees, -0.02)], 0.02, 16), BRASS)
    scene.sphere(around(1.80, 62, 0.25) + (0.44, 0.08, 0.0), 0.075, Material((0.8, 0.8, 0.8), 0.05, 0.9))
    saturn = around(3.30, 14, 0.25)
    tilt = meshes.about((1, 0, 0.4), 24)
    for radius in (0.50, 0.56, 0.62):
        scene.mesh(meshes.ring(radius, 0.016).turned(tilt).moved(saturn), Material((0.9, 0.8, 0.6), 0.07, 0.8, 0.3, 30))
    # The ring of the heavens.
    scene.mesh(meshes.ring(3.72, 0.085, 512), BRASS)
    scene.light((-5, 8, 6), (0.38, 0.42, 0.58), radius=1.2)
    return scene
