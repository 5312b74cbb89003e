"""The program: makes scenes, renders them, and writes the gallery's page."""

import argparse
import importlib
import json
import os
import subprocess
import sys
from pathlib import Path

from figures import parts
from gallery import page

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/host/lavaray"
SCENES = ("staircase", "lake", "still-life", "sphereflake", "mirror-hall", "shell", "menger", "orrery")
# Beside these a scene may have OPTIONS of its own.
OPTIONS = ("--target-error", "0.003")

DESCRIPTION = """\
Makes scenes of the gallery and renders them: NAME.txt, its meshes and NAME.png in FOLDER. What follows -- goes to
lavaray in place of --target-error 0.003. With --page all of them, and docs/gallery.md with its pictures.
"""


class GalleryError(Exception):
    pass


def scene_module(name):
    return importlib.import_module("gallery." + name.replace("-", "_"))


def build_program():
    """What the build prints goes to stderr: stdout is for results."""
    configure = ["cmake", "--preset", "release"]
    if not (ROOT / "build/CMakeCache.txt").exists():
        configure.append("-DBUILD_TESTING=OFF")  # as tools/render does
    for command in ([ROOT / "tools/setup", "build", "gallery"], configure,
                    ["cmake", "--build", "--preset", "release", "--target", "lavaray"]):
        subprocess.run(command, cwd=ROOT, stdout=sys.stderr, check=True)


def lavaray(*arguments):
    """The processor time that it took, in seconds."""
    with subprocess.Popen([PROGRAM, *arguments]) as child:
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise GalleryError(f"lavaray failed with exit code {child.returncode}")
    return usage.ru_utime + usage.ru_stime


def render(name, folder, ending, further):
    """Makes and renders a scene; returns what the page says of it."""
    module = scene_module(name)
    scene = module.build().write(folder, name)
    options = further or [*OPTIONS, *getattr(module, "OPTIONS", ())]
    picture = folder / (name + ending)
    seconds = lavaray(scene, *options, "-o", picture, "--json", folder / f"{name}.json")
    return {"name": name, "text": module.__doc__.strip().replace("\n", " "), "options": options, "picture": picture,
            "processorSeconds": seconds, "report": json.loads((folder / f"{name}.json").read_text())}


def parse_options(arguments):
    parser = argparse.ArgumentParser(prog="make-gallery", description=DESCRIPTION, allow_abbrev=False)
    add = parser.add_argument
    add("scenes", nargs="*", metavar="NAME", help=f"which scenes, of {', '.join(SCENES)} (default: all)")
    add("--page", action="store_true", help="write docs/gallery.md and its pictures, too")
    add("--out", type=Path, default=ROOT / "build/gallery", metavar="FOLDER",
        help="for scenes and pictures (default: build/gallery of this checkout)")
    split = arguments.index("--") if "--" in arguments else len(arguments)
    options = parser.parse_args(arguments[:split])
    options.further = arguments[split + 1:]
    for name in options.scenes:
        if name not in SCENES:
            parser.error(f"there is no scene {name}, allowed are {', '.join(SCENES)}")
    if options.page and (options.scenes or options.further):
        parser.error("--page is of all scenes, with their own options")
    return options


def main(arguments=None):
    options = parse_options(sys.argv[1:] if arguments is None else arguments)
    try:
        build_program()
        results = []
        for name in options.scenes or SCENES:
            results.append(render(name, options.out, ".ppm" if options.page else ".png", options.further))
            print(results[-1]["picture"], flush=True)
        if options.page:
            page.write(ROOT / "docs", results)
    except (GalleryError, parts.PageError, subprocess.CalledProcessError, OSError) as error:
        print(f"make-gallery: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("\nmake-gallery: interrupted", file=sys.stderr)
        return 130
    return 0
