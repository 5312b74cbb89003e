"""A scene in world coordinates with a camera that may stand anywhere, written as a scene file, whose camera looks down
-z, and its OBJ files."""

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np


@dataclass(frozen=True)
class Material:
    """Colours are RGB in 0 to 1; `specular` and `mirror`, the reflectance, may be numbers, too."""

    color: tuple
    ambient: object = 0.15  # what is seen in shadow: a colour, or a number times the one above
    diffuse: float = 0.8
    specular: object = 0.0
    shine: float = 20.0
    mirror: object = 0.0

    def lines(self):
        ambient = rgb(self.ambient) * (rgb(self.color) if np.isscalar(self.ambient) else 1)
        colors = {"amb": ambient, "dif": rgb(self.color) * self.diffuse, "spe": rgb(self.specular)}
        lines = [f"{key}: {numbers(value)}" for key, value in colors.items()] + [f"shi: {self.shine:g}"]
        return lines + ([f"ref: {numbers(rgb(self.mirror))}"] if np.any(self.mirror) else [])


def glow(color):
    """What shines by itself, but lights nothing."""
    return Material(color, ambient=1.0, diffuse=0.0)


def rgb(value):
    return np.broadcast_to(np.asarray(value, dtype=float), 3)


def numbers(values):
    return " ".join(f"{value:.5g}" for value in values)


class Scene:
    def __init__(self, eye, target, fov, up=(0, 1, 0), size=(960, 640)):
        self._eye = np.asarray(eye, dtype=float)
        back = unit(self._eye - target)
        right = unit(np.cross(up, back))
        self._turn = np.array([right, np.cross(back, right), back])  # rows: the camera's axes
        width, height = size
        # Half a pixel more, which truncation takes away again.
        f = (height + 0.5) / (2 * math.tan(math.radians(fov) / 2))
        self._blocks = [["camera", "pos: 0 0 0", f"fov: {fov:g}", f"f: {f:.6f}", f"a: {(width + 0.5) / height:.6f}"]]
        self._meshes = []

    def _place(self, points):
        return (np.asarray(points, dtype=float) - self._eye) @ self._turn.T

    def sphere(self, center, radius, material):
        self._blocks.append(["sphere", f"pos: {numbers(self._place(center))}", f"rad: {radius:.5g}", *material.lines()])

    def plane(self, point, normal, material):
        self._blocks.append(["plane", f"nor: {numbers(self._turn @ np.asarray(normal, dtype=float))}",
                             f"pos: {numbers(self._place(point))}", *material.lines()])

    def light(self, position, color, radius=0.0, ambient=0.0):
        """`ambient`: how much of a material's ambient colour it adds where it is seen."""
        self._blocks.append(["light", f"pos: {numbers(self._place(position))}", f"amb: {numbers(rgb(ambient))}",
                             f"dif: {numbers(rgb(color))}", f"spe: {numbers(rgb(color))}", f"rad: {radius:g}"])

    def mesh(self, mesh, material):
        self._blocks.append(["mesh", len(self._meshes), *material.lines()])
        self._meshes.append(mesh)

    def write(self, folder, name):
        """NAME.txt and NAME-*.obj in the folder; returns the scene's path."""
        folder = Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        lines = [str(len(self._blocks))]
        for block in self._blocks:
            if block[0] == "mesh":
                file = f"{name}-{block[1]}.obj"
                mesh = self._meshes[block[1]]
                write_obj(folder / file, self._place(mesh.points), mesh.faces,
                          mesh.normals @ self._turn.T if mesh.normals is not None else None)
                block = ["mesh", f"file: {file}", *block[2:]]
            lines += block
        path = folder / f"{name}.txt"
        path.write_text("\n".join(lines) + "\n")
        return path


def write_obj(path, points, faces, normals):
    with open(path, "w") as file:
        np.savetxt(file, points, fmt="v %.6g %.6g %.6g")
        corners = np.asarray(faces) + 1
        form = " %d" * corners.shape[1]
        if normals is not None:
            np.savetxt(file, normals, fmt="vn %.4g %.4g %.4g")
            corners = np.repeat(corners, 2, axis=1)
            form = form.replace("%d", "%d//%d")
        np.savetxt(file, corners, fmt="f" + form)


def unit(vector):
    vector = np.asarray(vector, dtype=float)
    return vector / np.linalg.norm(vector, axis=-1, keepdims=True)
