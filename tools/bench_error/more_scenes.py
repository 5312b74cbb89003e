"""Ten more scenes, of other kinds: whether a target error is honoured is measured on these, too."""

import math
import random

from bench_error.scenes import Builder, copies_of, random_color


def large_lamp(size, _models):
    builder = Builder(size, 50, (0, 3, 8))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.1, dif=(0.7, 0.7, 0.6))
    rng = random.Random(11)
    for index in range(9):
        position = (-4 + 4 * (index % 3) + rng.uniform(-1, 1), rng.uniform(0.5, 2), -4.0 * (index // 3))
        builder.sphere(position, rng.uniform(0.4, 0.9), amb=random_color(rng, 0.05, 0.2), dif=random_color(rng, 0.2, 0.8))
    builder.light((4, 9, 2), 0.8, radius=5.0)
    return builder.scene("large-lamp", "a lamp as wide as the scene")


def tiny_lamps(size, _models):
    builder = Builder(size, 55, (0, 5, 9))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.1, dif=0.6)
    rng = random.Random(12)
    for _ in range(30):
        builder.sphere((rng.uniform(-6, 6), rng.uniform(0.3, 2.5), rng.uniform(-8, 4)), 0.3, amb=0.1,
                       dif=random_color(rng, 0.2, 0.9))
    builder.light((-7, 6, 0), 0.45, radius=0.03)
    builder.light((7, 7, 3), 0.35, radius=0.08)
    return builder.scene("tiny-lamps", "shadows whose soft edge is narrower than a pixel")


def soft_mesh(size, models):
    builder = Builder(size, 40, (0, 3, 8))
    builder.plane((0, 1, 0), (0, -0.6, 0), amb=0.1, dif=(0.7, 0.6, 0.5))
    rings = [(-3 + 2 * i, 0.4 + 0.3 * (i % 2), -1.5 * j, 0.8) for i in range(4) for j in range(2)]
    builder.mesh("rings.obj", copies_of(models["torus"], rings), amb=0.1, dif=(0.3, 0.5, 0.8), spe=0.4, shi=30)
    builder.light((-4, 7, 5), 0.7, radius=0.9)
    return builder.scene("soft-mesh", "a mesh's soft shadow on itself")


def mirror_room(size, _models):
    builder = Builder(size, 75, (0.3, 1.6, 2.6))
    for normal, position in (((1, 0, 0), (-3, 0, 0)), ((1, 0, 0), (3, 0, 0)), ((0, 0, 1), (0, 0, -3)), ((0, 0, 1), (0, 0, 3))):
        builder.plane(normal, position, amb=0.02, ref=(0.8, 0.82, 0.84))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.1, dif=0.6, ref=0.15)
    rng = random.Random(13)
    for index in range(7):
        builder.sphere((rng.uniform(-2, 2), rng.uniform(0.3, 2.0), rng.uniform(-2.4, 0.8)), rng.uniform(0.2, 0.45),
                       amb=random_color(rng, 0.05, 0.2), dif=random_color(rng, 0.1, 0.7), spe=0.5, shi=60,
                       ref=0.6 if index % 2 else 0.0)
    builder.light((0.4, 4.5, 0.5), 0.6, radius=0.35)
    return builder.scene("mirror-room", "soft shadows in mirrors in mirrors")


def grass(size, _models):
    builder = Builder(size, 45, (0, 1.6, 6))
    builder.plane((0, 1, 0), (0, 0, 0), amb=(0.15, 0.12, 0.08), dif=(0.4, 0.35, 0.3))
    rng = random.Random(14)
    for _ in range(700):
        x, z = rng.uniform(-5, 5), rng.uniform(-10, 3)
        bend = rng.uniform(-0.5, 0.5)
        color = (rng.uniform(0.1, 0.4), rng.uniform(0.4, 0.9), rng.uniform(0.05, 0.2))
        builder.triangle([(x, 0, z), (x + 0.02, 0, z), (x + bend, rng.uniform(0.5, 1.5), z + 0.1)],
                         amb=tuple(0.3 * c for c in color), dif=color)
    builder.light((5, 9, 4), 0.8)
    return builder.scene("grass", "blades thinner than a pixel, and their shadows")


def glossy(size, _models):
    builder = Builder(size, 45, (0, 3, 9))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.05, dif=0.2, spe=0.8, shi=400)
    rng = random.Random(15)
    for index in range(40):
        builder.sphere((rng.uniform(-6, 6), 0.4, rng.uniform(-9, 4)), 0.4, amb=random_color(rng, 0.02, 0.1),
                       dif=random_color(rng, 0.05, 0.3), spe=0.9, shi=200 + 20 * index)
    for index in range(5):
        builder.light((-8 + 4 * index, 6, -6 + 2 * index), 0.5)
    return builder.scene("glossy", "highlights smaller than a pixel")


def fence(size, _models):
    builder = Builder(size, 50, (0, 2.5, 8))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.08, dif=0.7)
    builder.plane((0, 0, 1), (0, 0, -6), amb=0.08, dif=0.6)
    for index in range(60):
        x = -6 + 0.2 * index
        builder.triangle([(x, 0, -1), (x + 0.05, 0, -1), (x + 0.025, 2.5, -1)], amb=0.1, dif=(0.6, 0.4, 0.3))
    builder.light((3, 5, 6), 0.7, radius=0.3)
    return builder.scene("fence", "bars' shadows that run into one another")


def spot(size, _models):
    builder = Builder(size, 40, (0, 0, 10))
    builder.plane((0, 0, 1), (0, 0, -2), amb=0.03, dif=0.05)
    rng = random.Random(16)
    for _ in range(40):
        angle, distance = rng.uniform(0, 2 * math.pi), rng.uniform(0, 0.9)
        builder.sphere((2 + distance * math.cos(angle), 1 + distance * math.sin(angle), 0), 0.1,
                       amb=random_color(rng, 0.2, 0.9), dif=0.5)
    builder.light((6, 6, 8), 0.6, radius=0.5)
    return builder.scene("spot", "one busy place, and nothing elsewhere")


def overexposed(size, _models):
    builder = Builder(size, 50, (0, 3, 8))
    builder.plane((0, 1, 0), (0, 0, 0), amb=0.2, dif=0.9)
    rng = random.Random(17)
    for _ in range(14):
        builder.sphere((rng.uniform(-4, 4), rng.uniform(0.4, 2), rng.uniform(-6, 2)), 0.45, amb=0.2,
                       dif=random_color(rng, 0.4, 1.0), spe=1.0, shi=15)
    builder.light((-5, 7, 4), 0.9, radius=1.2)
    builder.light((5, 6, 5), 0.8, radius=0.7)
    return builder.scene("overexposed", "soft light that is clamped to white")


def ball(size, _models):
    builder = Builder(size, 40, (0, 0, 8))
    builder.sphere((0, 0, 0), 2.2, amb=0.1, dif=(0.7, 0.4, 0.2), spe=0.5, shi=25)
    builder.light((-6, 7, 9), 0.8)
    return builder.scene("ball", "next to nothing")


MORE = {
    "large-lamp": large_lamp, "tiny-lamps": tiny_lamps, "soft-mesh": soft_mesh, "mirror-room": mirror_room,
    "grass": grass, "glossy": glossy, "fence": fence, "spot": spot, "overexposed": overexposed, "ball": ball,
}
