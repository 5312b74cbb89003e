"""A sea shell in the sand, a spiral of half a million triangles, in the evening."""

import numpy as np

from gallery import meshes
from gallery.scene import Material, Scene, unit

TURNS, ALONG, AROUND = 6.5, 1600, 160
BANDS = 5  # of colour, around


def spiral():
    """Rings of points about a curve that grows by a constant factor a turn: [along, around, xyz]."""
    turn = np.linspace(0, 2 * np.pi * TURNS, ALONG)[:, None]
    around = np.linspace(0, 2 * np.pi, AROUND, endpoint=False)[None, :]
    grown = np.exp(0.093 * (turn - 2 * np.pi * TURNS))
    ribs = 1 + 0.035 * np.cos(14 * turn) * (0.5 + 0.5 * np.cos(around - 0.4))
    lip = 1 + 0.22 * np.clip((turn / (2 * np.pi * TURNS) - 0.985) / 0.015, 0, 1) ** 2
    out = grown * (1.0 + 0.78 * ribs * lip * np.cos(around))
    up = grown * (-2.55 + 0.92 * ribs * lip * np.sin(around))
    return np.stack([out * np.cos(turn), up, out * np.sin(turn)], axis=-1)


def bands(mesh):
    """The mesh in two: with every other band of faces."""
    column = np.arange(len(mesh.faces)) % AROUND
    wide = (column * 2 * BANDS // AROUND) % 2 == 0
    return mesh.part(wide), mesh.part(~wide)


def sand(count=420, side=26.0):
    """Ripples that the wind has made."""
    noise = np.random.default_rng(5)
    x, z = np.meshgrid(np.linspace(-side / 2, side / 2, count), np.linspace(-side / 2, side / 2, count), indexing="ij")
    bend = np.zeros_like(x)
    for scale in (0.25, 0.5, 1.0):
        for _ in range(3):
            angle, phase = noise.uniform(0, 2 * np.pi, 2)
            bend += 0.35 / scale * np.sin(scale * (x * np.cos(angle) + z * np.sin(angle)) + phase)
    wave = 0.5 + 0.5 * np.sin(6.5 * (0.35 * x + z + 0.55 * bend))
    height = 0.075 * wave**2 + 0.05 * bend
    return meshes.sheet(np.stack([x, height, z], axis=-1)[:, ::-1]).smooth()


def build():
    scene = Scene(eye=(0.0, 2.5, 10.0), target=(0.12, 1.0, 0.0), fov=21.5)
    shell = meshes.sheet(spiral(), closed=(False, True)).smooth()
    shell = shell.turned(meshes.about((0, 1, 0), 158) @ meshes.about((0, 0, 1), 72) @ meshes.about((0, 1, 0), 60))
    low, high = shell.points.min(axis=0), shell.points.max(axis=0)
    shell = shell.moved((-(low[0] + high[0]) / 2, -low[1] - 0.3, -(low[2] + high[2]) / 2))
    pale, brown = bands(shell)
    scene.mesh(pale, Material((0.98, 0.90, 0.78), (0.22, 0.19, 0.22), 0.85, 0.35, 40))
    scene.mesh(brown, Material((0.78, 0.40, 0.24), (0.17, 0.10, 0.12), 0.85, 0.35, 40))
    scene.mesh(sand(), Material((0.90, 0.70, 0.50), (0.20, 0.17, 0.22), 1.1, 0.03, 6))
    scene.plane((0, 0, -40), (0, 0, 1), Material((0.40, 0.34, 0.30), (0.16, 0.30, 0.42), 0.7))
    scene.light((-9, 1.5, -35), (1.4, 1.0, 0.5))
    scene.light((-9, 4.6, 5.0), (1.15, 0.92, 0.62), radius=0.5)
    scene.light((5, 8, 6), (0.14, 0.17, 0.26), radius=2.5)
    return scene
