"""Meshes as arrays of points, faces (of three or four corners) and, where they are smooth, normals."""

from dataclasses import dataclass

import numpy as np

from gallery.scene import unit


@dataclass(frozen=True)
class Mesh:
    points: np.ndarray
    faces: np.ndarray
    normals: np.ndarray = None

    def moved(self, offset):
        return Mesh(self.points + np.asarray(offset, dtype=float), self.faces, self.normals)

    def turned(self, matrix):
        """By a rotation: a matrix whose columns are where the axes go."""
        matrix = np.asarray(matrix, dtype=float)
        return Mesh(self.points @ matrix.T, self.faces, None if self.normals is None else self.normals @ matrix.T)

    def part(self, chosen):
        """These faces, with the points that they use."""
        used, faces = np.unique(self.faces[chosen], return_inverse=True)
        return Mesh(self.points[used], faces.reshape(-1, self.faces.shape[1]),
                    None if self.normals is None else self.normals[used])

    def smooth(self):
        """With the mean of the faces' normals, by area, at each point."""
        corners = self.points[self.faces]
        across = np.cross(corners[:, 2] - corners[:, 0], corners[:, -1] - corners[:, 1 if corners.shape[1] == 4 else 0])
        sums = np.zeros_like(self.points)
        for corner in self.faces.T:
            np.add.at(sums, corner, across)
        return Mesh(self.points, self.faces, unit(sums))


def join(*meshes):
    starts = np.cumsum([0, *(len(mesh.points) for mesh in meshes)])
    normals = None if any(mesh.normals is None for mesh in meshes) else np.concatenate([m.normals for m in meshes])
    return Mesh(np.concatenate([mesh.points for mesh in meshes]),
                np.concatenate([mesh.faces + start for mesh, start in zip(meshes, starts)]), normals)


def sheet(points, closed=(False, False)):
    """Quadrilaterals over an array of points [i, j, xyz]; closed: whether the last row or column joins the first."""
    rows, columns = points.shape[:2]
    i, j = np.meshgrid(np.arange(rows - (not closed[0])), np.arange(columns - (not closed[1])), indexing="ij")
    i, j = i.ravel(), j.ravel()
    after_i, after_j = (i + 1) % rows, (j + 1) % columns
    faces = np.stack([i * columns + j, after_i * columns + j, after_i * columns + after_j, i * columns + after_j], axis=1)
    return Mesh(points.reshape(-1, 3), faces)


def curve(points, count):
    """A smooth curve through points: Catmull and Rom's, `count` points for each part of it."""
    points = np.asarray(points, dtype=float)
    padded = np.concatenate([[2 * points[0] - points[1]], points, [2 * points[-1] - points[-2]]])
    t = np.linspace(0, 1, count, endpoint=False)[:, None]
    parts = []
    for a, b, c, d in zip(padded, padded[1:], padded[2:], padded[3:]):
        parts.append(b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a))))
    return np.concatenate([*parts, points[-1:]])


def lathe(profile, count=128):
    """Turns (radius, height) about the y axis."""
    profile = np.asarray(profile, dtype=float)
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    points = np.empty((len(profile), count, 3))
    points[..., 0] = profile[:, :1] * np.cos(angle)
    points[..., 1] = profile[:, 1:]
    points[..., 2] = -profile[:, :1] * np.sin(angle)
    return sheet(points, closed=(False, True))


def tube(path, radius, count=24, closed=False):
    """A round tube along points; `radius` is a number or one a point."""
    path = np.asarray(path, dtype=float)
    along = unit(np.roll(path, -1, axis=0) - np.roll(path, 1, axis=0)) if closed else unit(np.gradient(path, axis=0))
    # Each frame is the one before, turned as little as the path turns.
    side = np.empty_like(path)
    side[0] = unit(np.cross(along[0], np.eye(3)[np.argmin(np.abs(along[0]))]))
    for k in range(1, len(path)):
        side[k] = unit(side[k - 1] - along[k] * (side[k - 1] @ along[k]))
    other = np.cross(along, side)
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    around = np.cos(angle)[None, :, None] * side[:, None] + np.sin(angle)[None, :, None] * other[:, None]
    radius = np.broadcast_to(radius, len(path))[:, None, None]
    return sheet(path[:, None] + radius * around, closed=(closed, True)).smooth()


def ring(radius, thickness, count=256, around=32):
    """About the y axis."""
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return tube(np.stack([radius * np.cos(angle), np.zeros(count), radius * np.sin(angle)], axis=1), thickness, around,
                closed=True)


BOX = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)
BOX_FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [3, 7, 6, 2], [0, 4, 7, 3], [1, 2, 6, 5]])


def box(low, high):
    low, high = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
    return Mesh(low + BOX * (high - low), BOX_FACES)


def about(axis, degrees):
    """The rotation about an axis."""
    x, y, z = unit(axis)
    angle = np.radians(degrees)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
