"""Bottles, a bowl and fruit in the soft light of a window."""

import numpy as np

from gallery import meshes
from gallery.scene import Material, Scene


def vessel(scene, outline, place, material):
    turned = meshes.lathe(meshes.curve(outline, 24), 192).smooth()
    scene.mesh(turned.moved(place), material)


def clay(color, shine=12, specular=0.10):
    return Material(color, np.asarray(color) * 0.20 + np.array([0.0, 0.005, 0.02]), 0.78, specular, shine)


BOTTLE = [(0.02, 0), (0.40, 0.0), (0.46, 0.08), (0.46, 1.0), (0.43, 1.35), (0.20, 1.68), (0.125, 1.9), (0.125, 2.45),
          (0.16, 2.50), (0.16, 2.56), (0.12, 2.58), (0.09, 2.5)]
JUG = [(0.02, 0), (0.35, 0.0), (0.42, 0.04), (0.62, 0.45), (0.66, 0.75), (0.55, 1.08), (0.36, 1.28), (0.30, 1.42),
       (0.38, 1.60), (0.36, 1.60), (0.28, 1.42)]
FLASK = [(0.02, 0), (0.26, 0.0), (0.33, 0.05), (0.36, 0.3), (0.27, 0.75), (0.16, 1.05), (0.13, 1.45), (0.17, 1.75),
         (0.24, 1.86), (0.22, 1.86), (0.14, 1.74)]
BOWL = [(0.02, 0.06), (0.30, 0.02), (0.34, 0.0), (0.36, 0.05), (0.62, 0.20), (0.80, 0.46), (0.84, 0.62), (0.81, 0.63),
        (0.76, 0.48), (0.58, 0.26), (0.30, 0.12), (0.02, 0.10)]
PEAR = [(0.0, 0.03), (0.10, 0.0), (0.25, 0.06), (0.335, 0.22), (0.315, 0.38), (0.21, 0.56), (0.14, 0.70),
        (0.10, 0.78), (0.04, 0.815), (0.0, 0.815)]


def build():
    scene = Scene(eye=(0.0, 1.75, 8.6), target=(0.06, 1.14, 0.0), fov=24.5)
    scene.plane((0, 0, 0), (0, 1, 0), Material((0.80, 0.72, 0.62), (0.17, 0.155, 0.15), 0.74, 0.04, 6))
    scene.plane((0, 0, -2.6), (0, 0, 1), Material((0.56, 0.60, 0.58), (0.13, 0.14, 0.15), 0.80))
    vessel(scene, BOTTLE, (-0.95, 0, -0.55), clay((0.90, 0.86, 0.78), 30, 0.18))
    vessel(scene, JUG, (0.35, 0, -0.75), clay((0.36, 0.48, 0.56), 40, 0.22))
    vessel(scene, FLASK, (-1.95, 0, -0.25), clay((0.76, 0.46, 0.32)))
    vessel(scene, BOWL, (1.75, 0, -0.10), clay((0.88, 0.82, 0.70), 40, 0.25))
    for place, size in (((1.52, 0.46, -0.12), 0.30), ((1.98, 0.44, -0.30), 0.28), ((1.92, 0.46, 0.18), 0.27),
                        ((1.72, 0.80, 0.0), 0.26)):
        scene.sphere(place, size, clay((0.92, 0.52, 0.16), 18, 0.16))
    lying = meshes.about((0, 0.15, 1), 82)
    pear = meshes.lathe(meshes.curve(PEAR, 24), 160).smooth()
    scene.mesh(pear.moved((-0.18, 0, 0.62)), clay((0.70, 0.68, 0.26), 20, 0.14))
    scene.mesh(pear.turned(lying).moved((0.95, 0.31, 0.85)), clay((0.76, 0.66, 0.24), 20, 0.14))
    scene.mesh(meshes.tube([(-0.18, 0.78, 0.62), (-0.17, 0.86, 0.62), (-0.13, 0.95, 0.62)], 0.018, 12),
               clay((0.30, 0.20, 0.12)))
    scene.sphere((-0.85, 0.20, 0.85), 0.20, clay((0.62, 0.16, 0.16), 50, 0.3))
    scene.sphere((-1.28, 0.17, 0.62), 0.17, clay((0.50, 0.12, 0.18), 50, 0.3))
    scene.light((-6.0, 5.2, 4.6), (1.18, 1.08, 0.92), radius=1.6)
    scene.light((5.5, 3.0, 6.0), (0.09, 0.10, 0.13), radius=2.0)
    return scene
