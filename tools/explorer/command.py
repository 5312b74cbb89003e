"""The program: renders the views of a scene, and writes them on a page."""

import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).resolve().parent
LAYERS = ("normal", "depth", "object", "samples", "error")
MOST_BYTES = 1_500_000
CONFIGURE = ("cmake", "--preset", "release", "-DBUILD_TESTING=OFF")

DESCRIPTION = """\
Renders a scene with all of its views and writes one page that shows them, without a server and without a network: the
picture to the left of a line, a view to its right, and the values of the pixel under the mouse. Without a scene it is
the still life of the gallery, and the page docs/explorer.html.
"""


class ExplorerError(Exception):
    pass


def run(program, *arguments):
    """What it prints to stderr."""
    found = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if found.returncode != 0:
        raise ExplorerError(f"{' '.join(map(str, found.args))} failed: {found.stderr.strip()}")
    return found.stderr


def built():
    """The program lavaray; the Python package can be imported then. What the build prints goes to stderr."""
    configure = [] if (ROOT / "build/CMakeCache.txt").exists() else [CONFIGURE]
    make = ["cmake", "--build", "--preset", "release", "--target", "lavaray", "lavaray_python"]
    for command in ([ROOT / "tools/setup", "build", "gallery", "package"], *configure, make):
        subprocess.run(command, cwd=ROOT, stdout=sys.stderr, check=True)
    return ROOT / "build/host/lavaray"


def object_names(scene):
    """The kinds of the objects that have a material, which are numbered from 1 on in the order of the file."""
    kinds = re.findall(r"^\s*(plane|sphere|triangle|mesh|model)\s*$", scene.read_text(), re.MULTILINE)
    return ["nothing", *("mesh" if kind == "model" else kind for kind in kinds)]


def views(program, scene, options, folder):
    """What the page knows of each view."""
    import numpy
    import lavaray  # of the build, which is there by now
    from explorer.planes import encoded

    size = ["--width", options.width]
    sampled = [*size, "--target-error", options.target_error]
    run(program, scene, *sampled, "-q", "-o", folder / "picture.exr", "--layers", ",".join(LAYERS))
    run(program, scene, *size, "--spp", 16, "--view", "shadow", "-q", "-o", folder / "shadow.pfm")
    told = run(program, scene, *size, "--view", "cost", "-o", folder / "cost.pfm")
    white = int(re.search(r"cost: white is (\d+)", told).group(1))
    layer = {name: lavaray.read_image(str(folder / f"picture.{name}.exr")) for name in LAYERS}
    depth = layer["depth"][..., :1]
    depth = numpy.where(numpy.isfinite(depth), depth, 0)
    cost = lavaray.read_image(str(folder / "cost.pfm"))[..., :1] * white
    return {
        # Cut off, not rounded, as 8-bit files are.
        "color": encoded((255 * lavaray.read_image(str(folder / "picture.exr"))).astype(int), 0, 255, 1),
        "normal": encoded(layer["normal"], -1, 1, 1),
        # A distance of 0 is for what is infinitely far away.
        "depth": encoded(depth, 0, depth.max(), 2),
        "object": encoded(layer["object"][..., :1], 0, 65535, 2),
        "shadow": encoded(lavaray.read_image(str(folder / "shadow.pfm"))[..., :1], 0, 1, 1),
        "cost": encoded(cost, 0, 65535, 2),
        "samples": encoded(layer["samples"][..., :1], 0, 65535, 2),
        # In steps of 1e-4, a fortieth of a level.
        "error": encoded(layer["error"][..., :1], 0, 6.5535, 2),
    }


def written(program, scene, options):
    """The page."""
    with tempfile.TemporaryDirectory() as folder:
        found = views(program, scene, options, Path(folder))
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    data = {"scene": scene.name, "objects": object_names(scene), "views": found,
            "how": f"{version}, --width {options.width} --target-error {options.target_error}"}
    page = (HERE / "page.html").read_text()
    # The look is the report's.
    sources = {"report.css": ROOT / "host/report/page.css", "page.css": HERE / "page.css", "page.js": HERE / "page.js"}
    for name, source in sources.items():
        page = page.replace("{{" + name + "}}", source.read_text())
    page = page.replace("{{title}}", scene.stem)
    return page.replace("{{data}}", json.dumps(data, separators=(",", ":")).replace("<", "\\u003c"))


def parse_options(arguments):
    parser = argparse.ArgumentParser(prog="make-explorer", description=DESCRIPTION, allow_abbrev=False)
    add = parser.add_argument
    add("scene", nargs="?", type=Path, metavar="SCENE", help="scene file")
    add("-o", "--output", type=Path, metavar="FILE", help="the page (default: SCENE's name with .html)")
    add("--width", type=int, default=720, metavar="W", help="of the picture, in pixels (default: %(default)s)")
    add("--target-error", type=float, default=0.004, metavar="E", help="of the picture (default: %(default)s)")
    add("--program", type=Path, metavar="FILE", help="the lavaray to run (default: it is built); its Python package is on "
                                                     "the path then")
    return parser.parse_args(arguments)


def main(arguments=None):
    options = parse_options(arguments)
    try:
        program = options.program or built()
        if options.program is None:
            sys.path.insert(0, str(ROOT / "build/python"))
        scene, output = options.scene, options.output
        if scene is None:
            from gallery import still_life
            scene = still_life.build().write(ROOT / "build/gallery", "still-life")
            output = output or ROOT / "docs/explorer.html"
        output = output or Path(scene.stem + ".html")
        page = written(program, scene, options)
        if len(page) > MOST_BYTES:
            raise ExplorerError(f"the page has {len(page):,} bytes, allowed are {MOST_BYTES:,}: choose a smaller --width")
        output.write_text(page)
        print(f"{output}, {len(page):,} bytes")
    except (ExplorerError, ImportError, subprocess.CalledProcessError, OSError) as error:
        print(f"make-explorer: {error}", file=sys.stderr)
        return 1
    return 0
