"""The program: runs benchmarks, and writes what they found into docs/speed.md."""

import argparse
import json
import shutil
import subprocess
import sys
from pathlib import Path
from statistics import median

from figures import parts

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
PAGE = ROOT / "docs/speed.md"

DESCRIPTION = """\
Runs benchmarks, and writes their tables, with command, machine and date, into docs/speed.md: rays (bench-speed against
Embree, and its plot; README.md has some of it, too), sizes (a plot), processes (against POV-Ray), obj (bench-obj against tinyobjloader). An idle machine
gives figures that can be compared.
"""


FORMS = {"v/vt/vn": "`v/vt/vn`", "negative": "the same, counted back from the end", "v": "`v`", "quads": "`v/vt/vn` of quads"}


def rays(folder, command):
    results = json.loads((folder / "rays.json").read_text())
    lanes = sorted(results["rays_per_lane"], reverse=True)

    def cpu(timings, name):
        return next((min(timing["cpu"]) for timing in timings if timing["name"] == name), None)

    def quotients(timings):
        embree = cpu(timings, "embree robust")
        own = [cpu(timings, f"lavaray, {count} ray{'s' if count > 1 else ''} a lane") for count in lanes]
        return " / ".join(f"{time / embree:.2f}" if time and embree else "-" for time in own)

    def built(scene):
        def nanoseconds(*names):
            times = [time for name in names if (time := cpu(scene["builds"], name))]
            return f"{1e9 * min(times) / scene['primitives']:.0f}" if times else "-"

        return f"{nanoseconds('lavaray all arrays')} / {nanoseconds('embree robust', 'embree default commit')}"

    rows = [[scene["name"], f"{scene['primitives']:,}", quotients(scene["picture"]["timings"]), built(scene),
             f"{scene['bytes'] / scene['primitives']:.0f}"] for scene in results["scenes"]]
    few = [scene for scene in results["scenes"] if scene["name"] in ("bunny", "beast", "1M", "2.5M")]
    text = parts.markdown_table([f"{scene['name']}, {scene['primitives']:,} triangles" for scene in few],
                                [[quotients(scene["picture"]["timings"]).split(" / ")[0] for scene in few]])
    origin = parts.origin(command, results["device"], results["peer"], f"{results['size'][0]} x {results['size'][1]} pixels")
    parts.replace(ROOT / "README.md", "speed", f"{text}\n\n{origin}")
    header = ["scene", "triangles, spheres", f"picture with shadows, of Embree, {' / '.join(map(str, lanes))} rays a lane",
              "build, ns each: lavaray / Embree", "bytes each"]
    shutil.copy(folder / "rays.svg", ROOT / "docs/speed-scenes.svg")
    return "\n\n".join([parts.markdown_table(header, rows), origin])


def sizes(folder, command):
    shutil.copy(folder / "sizes.svg", ROOT / "docs/speed-sizes.svg")
    return "\n\n".join(["![Time of the bunny against the size of the picture](speed-sizes.svg)", parts.origin(command)])


def processes(folder, command):
    results = json.loads((folder / "processes.json").read_text())
    contestants = list(dict.fromkeys(name for scene in results["scenes"] for name in scene["times"]))
    rows = [[scene["name"]] + [f"{min(scene['times'][name][clock]):.2f}" if name in scene["times"] else "-"
                               for name in contestants for clock in ("wall", "cpu")] for scene in results["scenes"]]
    header = ["scene file to image file, least of " + str(results["rounds"])]
    header += [f"{name}, {clock}" for name in contestants for clock in ("s", "CPU s")]
    return "\n\n".join([parts.markdown_table(header, rows), parts.origin(command)])


def obj(folder, command):
    results = json.loads((folder / "obj.json").read_text())

    def row(result):
        own, peer = (result["loads"][reader] for reader in ("lavaray", "tinyobjloader"))
        pairs = [[pick([load[what] for load in loads]) for loads in (own, peer)]
                 for what, pick in (("processor", min), ("processor", median), ("peakBytes", max))]
        seconds = [f"{a:.2f} / {b:.2f}" for a, b in pairs[:2]]
        peak = f"{pairs[2][0] / 1e6:.0f} / {pairs[2][1] / 1e6:.0f}"
        quotients = ", ".join(f"{pairs[i][0] / pairs[i][1]:.2f}" for i in (0, 2))
        return [FORMS.get(result["form"], result["form"]), f"{result['fileBytes'] / 1e6:.0f}", *seconds, peak, quotients]

    header = ["corners", "MB of text", "CPU seconds, least", "median", "peak, MB", "quotients"]
    return "\n\n".join([parts.markdown_table(header, map(row, results)), parts.origin(command)])


# What each is written from.
COMMANDS = {
    "rays": ["tools/bench-speed", "--only", "rays", "--rounds", "3", "--rays-per-lane", "4,2,1"],
    "sizes": ["tools/bench-speed", "--only", "sizes", "--rounds", "3"],
    "processes": ["tools/bench-speed", "--only", "processes", "--rounds", "5"],
    "obj": ["tools/bench-obj", "--rounds", "3"],
}
WRITERS = {"rays": rays, "sizes": sizes, "processes": processes, "obj": obj}


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="write-figures", description=DESCRIPTION, allow_abbrev=False)
    parser.add_argument("--kept", action="store_true", help="write what the last runs have found, in place of new ones")
    parser.add_argument("what", nargs="*", metavar="WHAT", help=f"which, of {', '.join(COMMANDS)} (default: all)")
    options = parser.parse_args(arguments)
    unknown = [what for what in options.what if what not in COMMANDS]
    if unknown:
        parser.error(f"there is no {unknown[0]}, allowed are {', '.join(COMMANDS)}")
    try:
        for what in options.what or COMMANDS:
            command = COMMANDS[what]
            if not options.kept:
                subprocess.run(command, cwd=ROOT, stdout=sys.stderr, check=True)
            folder = BUILD / Path(command[0]).name
            parts.replace(PAGE, what, WRITERS[what](folder, " ".join(command)))
            print(f"{PAGE}: {what}")
    except (parts.PageError, subprocess.CalledProcessError, OSError, KeyError) as error:
        print(f"write-figures: {error}", file=sys.stderr)
        return 1
    return 0
