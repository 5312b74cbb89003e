"""Renders of scenes."""

from __future__ import annotations

import dataclasses
import os
import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Union

import numpy

from lavaray import _core
from lavaray._scene import Scene

Image = numpy.ndarray[Any, numpy.dtype[numpy.float32]]
AnyScene = Union[Scene, str, "os.PathLike[str]"]
Progress = Callable[[float], bool]  # of the share that is done, in [0, 1]; returns whether to go on


@dataclasses.dataclass(frozen=True)
class DeviceInfo:
    """A Vulkan device, by whose name or number a Renderer opens it."""

    name: str
    kind: str  # discrete GPU, integrated GPU, virtual GPU, CPU, other
    driver: str  # its name and version
    is_usable: bool  # it has Vulkan 1.2 and a compute queue


@dataclasses.dataclass(frozen=True)
class Picture:
    """A picture and how it came about."""

    image: Image  # (height, width, 3), float32, colours in [0, 1]; black where no sample was taken
    stop_reason: str  # all samples taken, and so on, in words
    samples_per_pixel: float  # mean over the pixels in which something can show
    estimated_error: float  # RMSE, where there was a target, else 0
    camera_rays: int
    mirror_rays: int  # this and the next are counted with count_rays=True
    shadow_rays: int


class Shader:
    """A compute shader of your own, in GLSL, for Renderer.run (docs/shaders.md). Raises Error with file and line.

    It is compiled in another process, which ends with the thread that made the Shader; a later reload starts another.
    """

    def __init__(self, file: str | os.PathLike[str]) -> None:
        self._core = _core.Shader(os.fspath(file))

    def reload(self) -> bool:
        """Compiles it anew if one of its files has changed, and returns whether it did.

        If it raises Error, the shader stays as it was, and there is nothing to be done until the next change.
        """
        return self._core.reload()

    def take_warnings(self) -> list[str]:
        """What the compiler has warned of since the last call, each `file:line: message`."""
        return self._core.take_warnings()

    @property
    def files(self) -> list[Path]:
        """Its file and its includes, as last read or tried to be read."""
        return list(self._core.files)


class Renderer:
    """Renders on one device, and keeps what later renders can use. Several threads may use it at once.

    device: a number or a part of the name; without one the best: a discrete GPU, an integrated one, the CPU.
    """

    def __init__(self, device: str | int = "") -> None:
        self._core = _core.Renderer(str(device))

    @property
    def device_name(self) -> str:
        """Waits for the device, and raises Error if there is none."""
        return self._core.device_name()

    def render(self, scene: AnyScene, *, width: int = 0, height: int = 0, spp: int = 1, target_error: float | None = None,
               max_spp: int = 65536, time_limit: float | None = None, view: str = "color", filter: str = "box",
               sampler: str = "sobol", seed: int = 0, max_depth: int = 8, crop: Sequence[int] | None = None,
               normalize: bool = False, count_rays: bool = False, progress: Progress | None = None) -> Picture:
        """Renders a Scene or a scene file.

        width, height: of the whole picture, 1 to 65535 pixels; 0 is the scene's, or what goes with the other side.
        spp: samples a pixel, 1 to 2^22; 1 is its centre.
        target_error: in place of spp, sample until the picture's RMSE is estimated to be at most this, 1e-6 to 1, with at
            most max_spp samples a pixel.
        time_limit: seconds, after which the picture is what there is.
        view: color, normal, depth, object, shadow, cost, samples, error.
        filter: box, tent, gaussian, blackman-harris.
        sampler: sobol, or random for comparison. seed: of its randomisation.
        max_depth: mirror bounces, at most 1000.
        crop: x0, y0, x1, y1 in pixels from the top left; only this part, with the whole picture's pixels.
        normalize: stretch so that the whole picture's largest value is 1.
        progress: called with the share that is done, in [0, 1]; the render ends where it returns False, with the picture
            so far.

        Other threads of Python run meanwhile. Ctrl-C raises KeyboardInterrupt.
        """
        options = _core.Options()
        options.width, options.height = width, height
        options.samples, options.max_samples, options.max_depth, options.seed = spp, max_spp, max_depth, seed
        options.target_error, options.time_limit = target_error, time_limit
        options.normalize, options.count_rays = normalize, count_rays
        options.set_view(view)
        options.set_filter(filter)
        options.set_sampler(sampler)
        options.set_crop(None if crop is None else list(crop))
        if not isinstance(scene, Scene):
            scene = Scene.read(scene)
        image, statistics = self._core.render(scene._core, options, progress)
        return Picture(image, **statistics)

    def run(self, shader: Shader, scene: AnyScene, *, width: int = 0, height: int = 0, crop: Sequence[int] | None = None,
            seed: int = 0, max_depth: int = 8, progress: Progress | None = None) -> Image:
        """Runs a Shader for each pixel and returns its values, (height, width, 3) float32.

        width, height, crop, progress: as for render. seed and max_depth are the shader's constants.seed and
        constants.maxDepth (0 where the scene has no mirrors). Where progress stops it, the rest is 0.
        """
        options = _core.Options()
        options.width, options.height, options.seed, options.max_depth = width, height, seed, max_depth
        options.set_crop(None if crop is None else list(crop))
        if not isinstance(scene, Scene):
            scene = Scene.read(scene)
        return self._core.run(shader._core, scene._core, options, progress)


_renderers: dict[str, Renderer] = {}
_renderers_lock = threading.Lock()


def render(scene: AnyScene, *, device: str | int = "", **options: Any) -> Image:
    """Renders a Scene or a scene file and returns (height, width, 3) float32 colours in [0, 1].

    The options are those of Renderer.render. Devices stay open, with their pipelines, for later calls.
    """
    key = str(device)
    with _renderers_lock:
        if key not in _renderers:
            _renderers[key] = Renderer(device)
        renderer = _renderers[key]
    return renderer.render(scene, **options).image


def devices() -> list[DeviceInfo]:
    """The devices in the order that numbers them. Raises Error, saying why, if there is none."""
    return [DeviceInfo(*device) for device in _core.devices()]
