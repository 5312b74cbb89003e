"""A spiral staircase, seen from its top."""

import numpy as np

from gallery import meshes
from gallery.scene import Material, Scene, glow

STEPS_A_TURN, TURNS, RISE = 28, 8, 0.115
FIRST = STEPS_A_TURN * RISE  # how far below the topmost step the picture begins
INNER, OUTER = 0.95, 2.3


def wedge(number):
    """A step, bent with the stairs."""
    first, last = (2 * np.pi * (number + k) / STEPS_A_TURN for k in (0.0, 1.02))
    top = -number * RISE
    angle = np.linspace(first, last, 4)[:, None]
    section = np.array([(INNER, top), (INNER, top - 0.16), (OUTER, top - 0.16), (OUTER, top)])
    points = np.stack([section[:, 0] * np.cos(angle), np.broadcast_to(section[:, 1], (4, 4)),
                       section[:, 0] * np.sin(angle)], axis=-1)
    around = meshes.sheet(points, closed=(False, True))
    caps = np.array([(3, 2, 1, 0), (12, 13, 14, 15)])
    return meshes.Mesh(around.points, np.concatenate([around.faces, caps]))


def helix(radius, lift, count=2600):
    turn = np.linspace(0, 2 * np.pi * TURNS, count)
    height = lift - turn * STEPS_A_TURN * RISE / (2 * np.pi)
    return np.stack([radius * np.cos(turn), height, radius * np.sin(turn)], axis=1)


def bar(number):
    """What holds the rail over a step."""
    angle = 2 * np.pi * (number + 0.5) / STEPS_A_TURN
    foot = np.array([INNER * np.cos(angle), -number * RISE, INNER * np.sin(angle)])
    return meshes.tube([foot, foot + (0, 0.62, 0)], 0.011, 8)


def build():
    scene = Scene(eye=(0.30, 1.2 - FIRST, 0.20), target=(0.0, -14.0 - FIRST, 0.0), fov=64, up=(0, 0, -1))
    count = STEPS_A_TURN * TURNS
    depth = count * RISE
    scene.mesh(meshes.join(*(wedge(k) for k in range(count))),
               Material((0.88, 0.74, 0.58), (0.11, 0.085, 0.09), 0.9, 0.05))
    scene.mesh(meshes.tube(helix(INNER - 0.02, 0.62), 0.035, 20), Material((0.50, 0.22, 0.10), 0.14, 0.8, 0.5, 40))
    scene.mesh(meshes.join(*(bar(k) for k in range(count))), Material((0.12, 0.11, 0.12), 0.2, 0.8, 0.3, 30))
    scene.mesh(meshes.lathe([(OUTER, -depth - 2), (OUTER, 3.2)], 256).smooth(),
               Material((0.62, 0.66, 0.72), (0.07, 0.08, 0.11), 0.8))
    scene.plane((0, -depth - 1.2, 0), (0, 1, 0), Material((0.75, 0.55, 0.32), 0.2, 0.8, 0, 20, 0.1))
    scene.sphere((0, -depth - 0.8, 0), 0.3, glow((1.0, 0.86, 0.6)))
    scene.light((0, -depth - 0.8, 0), (0.85, 0.60, 0.32), radius=0.31)
    scene.light((-0.45, 1.9 - FIRST, -0.45), (0.86, 0.88, 0.96), radius=0.3)
    scene.light((0, -depth / 2, 0), (0.30, 0.22, 0.15), radius=0.15)
    return scene
