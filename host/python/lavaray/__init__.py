"""lavaray: a headless ray tracer.

    import lavaray
    picture = lavaray.render("scene.txt", spp=16)   # numpy, (height, width, 3), float32, colours in [0, 1]

A scene comes from a file, from text (Scene.parse) or from objects (Scene.add). Everything that fails raises Error, which
says the kind of failure and, where there is one, the file and the line.
"""

from lavaray._core import version as __version__
from lavaray._errors import Error
from lavaray._images import Difference, compare, flip_map, read_image, write_image
from lavaray._rendering import DeviceInfo, Picture, Renderer, Shader, devices, render
from lavaray._scene import Camera, Light, Material, Mesh, Plane, Scene, Sphere, Triangle

__all__ = [
    "Camera", "DeviceInfo", "Difference", "Error", "Light", "Material", "Mesh", "Picture", "Plane", "Renderer", "Scene",
    "Shader", "Sphere", "Triangle", "__version__", "compare", "devices", "flip_map", "read_image", "render", "write_image",
]  # yapf: disable
