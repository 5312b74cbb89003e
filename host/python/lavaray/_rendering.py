"""Renders of scenes."""

from __future__ import annotations

import dataclasses
import os
import threading
from collections.abc import Callable, Sequence
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
