"""What is to be rendered."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Sequence
from typing import Any, Union

import numpy
import numpy.typing

from lavaray import _core
from lavaray._errors import Error

Vector = Sequence[float]  # three numbers, an array of them too
Array = numpy.typing.ArrayLike
StrPath = Union[str, "os.PathLike[str]"]


@dataclasses.dataclass
class Camera:
    """Looks along -z; +y is up.

    fov: the vertical field of view in degrees, in (0, 180). focal_length: distance of the image plane in pixels; the
    picture is 2 focal_length tan(fov / 2) pixels high. aspect: its width / height.
    """

    position: Vector = (0.0, 0.0, 0.0)
    fov: float = 60.0
    focal_length: float = 500.0
    aspect: float = 1.0


@dataclasses.dataclass
class Material:
    """Phong reflection coefficients: colours are red, green, blue, each 0 or more.

    reflectance: of a perfect mirror; None is the scene's `reflect` times the specular colour.
    """

    ambient: Vector = (0.0, 0.0, 0.0)
    diffuse: Vector = (0.0, 0.0, 0.0)
    specular: Vector = (0.0, 0.0, 0.0)
    shininess: float = 0.0
    reflectance: Vector | None = None


@dataclasses.dataclass
class Plane:
    """The plane through a point with a normal of any length > 0."""

    normal: Vector = (0.0, 1.0, 0.0)
    point: Vector = (0.0, 0.0, 0.0)
    material: Material = dataclasses.field(default_factory=Material)


@dataclasses.dataclass
class Sphere:
    """A sphere with a radius > 0, seen from outside."""

    center: Vector = (0.0, 0.0, 0.0)
    radius: float = 1.0
    material: Material = dataclasses.field(default_factory=Material)


@dataclasses.dataclass
class Triangle:
    """Three vertices that are not on a line."""

    vertices: Sequence[Vector] = ()
    material: Material = dataclasses.field(default_factory=Material)


@dataclasses.dataclass
class Mesh:
    """A surface of triangles. Those without an area are dropped.

    vertices: (n, 3) numbers. faces: (m, 3) integers from 0, the vertices of each triangle. normals: (k, 3) numbers, of
    any length > 0; None is flat triangles. corners: (m, 3) integers from 0, the normals of each triangle's corners; None
    is those of its vertices.
    """

    vertices: Array
    faces: Array
    normals: Array | None = None
    corners: Array | None = None
    material: Material = dataclasses.field(default_factory=Material)


@dataclasses.dataclass
class Light:
    """A point light, or with a radius > 0 a sphere. None is the scene's `light_radius`."""

    position: Vector = (0.0, 0.0, 0.0)
    ambient: Vector = (0.0, 0.0, 0.0)
    diffuse: Vector = (1.0, 1.0, 1.0)
    specular: Vector = (1.0, 1.0, 1.0)
    radius: float | None = None


class Scene:
    """A scene, without objects and with the default Camera. Several threads may render one that no thread changes.

    reflect, light_radius: for materials that state no reflectance, and lights that state no radius.
    """

    def __init__(self, camera: Camera | None = None, *, reflect: float = 0.0, light_radius: float = 0.0) -> None:
        self._core = _core.Scene()
        self._core.set_defaults(reflect, light_radius)
        self.camera = camera or Camera()

    @classmethod
    def read(cls, file: StrPath, *, reflect: float = 0.0, light_radius: float = 0.0) -> Scene:
        """Reads a scene file and its meshes. Raises Error with the file and the line of what is wrong."""
        return cls._of(_core.Scene.read(os.fspath(file), reflect, light_radius))

    @classmethod
    def parse(cls, text: str, file: StrPath = "scene", *, reflect: float = 0.0, light_radius: float = 0.0) -> Scene:
        """The same for a text. `file` is its name in messages; meshes are looked for in that one's folder."""
        return cls._of(_core.Scene.parse(text, os.fspath(file), reflect, light_radius))

    def add(self, *objects: Plane | Sphere | Triangle | Mesh | Light) -> Scene:
        """Adds objects and returns the scene. Of surfaces at the same distance the first added is seen."""
        for thing in objects:
            self._add(thing)
        return self

    @property
    def warnings(self) -> list[str]:
        """What is odd but tolerated, each `file:line: message`."""
        return self._core.warnings

    @property
    def files(self) -> list[str]:
        """The scene's file and its meshes'."""
        return [os.fspath(file) for file in self._core.files]

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels that the camera asks for."""
        return self._core.size

    def _set_camera(self, camera: Camera) -> None:
        position = _vector(camera.position, "a camera's position")
        self._core.set_camera(position, camera.fov, camera.focal_length, camera.aspect)

    camera = property(fset=_set_camera, doc="Sets the camera.")

    @classmethod
    def _of(cls, core: _core.Scene) -> Scene:
        scene = cls.__new__(cls)
        scene._core = core
        return scene

    def _add(self, thing: Plane | Sphere | Triangle | Mesh | Light) -> None:
        if isinstance(thing, Plane):
            self._core.add_plane(_vector(thing.normal, "a plane's normal"), _vector(thing.point, "a plane's point"),
                                 _material(thing.material))
        elif isinstance(thing, Sphere):
            self._core.add_sphere(_vector(thing.center, "a sphere's centre"), thing.radius, _material(thing.material))
        elif isinstance(thing, Triangle):
            vertices = _rows(thing.vertices, "a triangle's vertices")
            if len(vertices) != 3:
                raise Error(f"a triangle has {len(vertices)} vertices, 3 are needed", "input")
            self._core.add_triangle(vertices.tolist(), _material(thing.material))
        elif isinstance(thing, Mesh):
            self._add_mesh(thing)
        elif isinstance(thing, Light):
            self._core.add_light(_vector(thing.position, "a light's position"), _vector(thing.ambient, "a light's colour"),
                                 _vector(thing.diffuse, "a light's colour"), _vector(thing.specular, "a light's colour"),
                                 thing.radius)
        else:
            raise Error(f"a scene has no {type(thing).__name__}; allowed are Plane, Sphere, Triangle, Mesh and Light",
                        "input")

    def _add_mesh(self, mesh: Mesh) -> None:
        normals = numpy.empty((0, 3)) if mesh.normals is None else _rows(mesh.normals, "a mesh's normals")
        corners = numpy.empty((0, 3), numpy.uint32) if mesh.corners is None else _indices(mesh.corners, "corners")
        self._core.add_mesh(_rows(mesh.vertices, "a mesh's vertices"), _indices(mesh.faces, "faces"), normals, corners,
                            _material(mesh.material))


def _vector(values: Vector, what: str) -> list[float]:
    array = _numbers(values, what)
    if array.shape != (3,):
        raise Error(f"{what} has the shape {array.shape}, (3,) is needed", "input")
    x, y, z = array
    return [float(x), float(y), float(z)]


def _rows(values: Any, what: str) -> numpy.ndarray[Any, numpy.dtype[numpy.float64]]:
    array = _numbers(values, what)
    if array.ndim != 2 or array.shape[1] != 3:
        raise Error(f"{what} have the shape {array.shape}, (n, 3) is needed", "input")
    return array


def _numbers(values: Any, what: str) -> numpy.ndarray[Any, numpy.dtype[numpy.float64]]:
    try:
        return numpy.asarray(values, numpy.float64)
    except (TypeError, ValueError):
        raise Error(f"{what} must be numbers", "input") from None


def _indices(values: Any, what: str) -> numpy.ndarray[Any, numpy.dtype[numpy.uint32]]:
    array = numpy.asarray(values)
    if array.ndim != 2 or array.shape[1] != 3 or not numpy.issubdtype(array.dtype, numpy.integer):
        raise Error(f"a mesh's {what} are {array.dtype} of the shape {array.shape}, integers of (m, 3) are needed", "input")
    if array.size and not 0 <= array.min() <= array.max() < 2**32:
        raise Error(f"a mesh's {what} go from {array.min()} to {array.max()}, allowed are 0 to 2^32 - 1", "input")
    return array.astype(numpy.uint32)


def _material(material: Material) -> _core.Material:
    reflectance = None if material.reflectance is None else _vector(material.reflectance, "a reflectance")
    return _core.Material(_vector(material.ambient, "an ambient colour"), _vector(material.diffuse, "a diffuse colour"),
                          _vector(material.specular, "a specular colour"), material.shininess, reflectance)
