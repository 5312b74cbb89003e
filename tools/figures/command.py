"""The program: runs benchmarks, and writes what they found into the documents."""

import argparse
import json
import shlex
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from statistics import geometric_mean, median

from figures import parts

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"

DESCRIPTION = """\
Runs benchmarks, and writes their tables, with command, machine and date, into the documents. Into docs/speed.md: rays
(bench-speed against Embree, and its plot; README.md has some of it, too), sizes (a plot), processes (against POV-Ray),
obj (bench-obj against tinyobjloader). Into docs/command-line.md: batch (bench-batch, many scenes in one process). Into
docs/sampling.md: errors (bench-error, fixed sampling and POV-Ray against a target error, and its plot), estimate
(bench-estimate). An idle machine gives figures that can be compared.
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


def batch(folder, command):
    results = json.loads((folder / "bench-batch.json").read_text())
    rows = [[name, *(f"{share:.2f}" for share in shares)] for name, shares in results.items()]
    header = ["", "CPU time", "wall clock", "with a shader cache that is empty at first: CPU time", "wall clock"]
    return "\n\n".join([parts.markdown_table(header, rows), parts.origin(command)])


def errors(folder, command):
    results = json.loads((folder / "bench-error.json").read_text())
    records = results["summary"]["equal_errors"]
    names = list(dict.fromkeys(record["scene"] for record in records))
    rows = []
    for target in dict.fromkeys(record["target"] for record in records):
        found = {record["scene"]: record["of"] for record in records if record["target"] == target}
        for method, title in (("sobol", "fixed Owen-Sobol"), ("random", "fixed random"), ("povray", "POV-Ray's best")):
            known = [found[name][method] for name in names if found[name].get(method)]
            if not known:
                continue
            cells = [(f"{found[name][method]:.2f}" if found[name][method] else "not reached") if method in found[name] else ""
                     for name in names]
            rows.append([f"{target:g}" if method == "sobol" else "", title, *cells, f"{geometric_mean(known):.2f}"])
    shutil.copy(folder / "error-time.svg", ROOT / "tools/bench_error/error-time.svg")
    table = parts.markdown_table(["E", "time of", *names, "geometric mean"], rows)
    return "\n\n".join([table, parts.origin(command, results["povray"] or "no POV-Ray")])


def estimate(folder, command):
    results = json.loads((folder / "bench-estimate.json").read_text())
    kept, most = results["runs"] - results["over"], results["rows"][-1][-1]
    text = f"Of these {results['runs']} runs {kept} have a true RMSE of at most E, and none has more than {most} E."
    return "\n\n".join([parts.markdown_table(results["header"], results["rows"]), text, parts.origin(command)])


@dataclass(frozen=True)
class Figures:
    """What is written, where, and from which run of which benchmark."""

    write: object  # (folder of results, the command as words) -> lines of Markdown
    page: str
    command: list


FIGURES = {
    "rays": Figures(rays, "speed", ["tools/bench-speed", "--only", "rays", "--rounds", "3", "--rays-per-lane", "4,2,1"]),
    "sizes": Figures(sizes, "speed", ["tools/bench-speed", "--only", "sizes", "--rounds", "3"]),
    "processes": Figures(processes, "speed", ["tools/bench-speed", "--only", "processes", "--rounds", "5"]),
    "obj": Figures(obj, "speed", ["tools/bench-obj", "--rounds", "3"]),
    "batch": Figures(batch, "command-line", ["tools/bench-batch", "--rounds", "3"]),
    "errors": Figures(errors, "sampling", ["tools/bench-error", "--size", "640x480", "--spp", "4,16,64", "--targets",
                                           "0.005,0.002,0.001", "--repeats", "1", "--seeds", "3", "--reference-spp", "1024"]),
    "estimate": Figures(estimate, "sampling", ["tools/bench-estimate", "--seeds", "5"]),
}


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="write-figures", description=DESCRIPTION, allow_abbrev=False)
    parser.add_argument("--kept", action="store_true", help="write what the last runs have found, in place of new ones")
    parser.add_argument("what", nargs="*", metavar="WHAT", help=f"which, of {', '.join(FIGURES)} (default: all)")
    options = parser.parse_args(arguments)
    unknown = [what for what in options.what if what not in FIGURES]
    if unknown:
        parser.error(f"there is no {unknown[0]}, allowed are {', '.join(FIGURES)}")
    try:
        for what in options.what or FIGURES:
            figures = FIGURES[what]
            folder = BUILD / Path(figures.command[0]).name
            if not options.kept:
                subprocess.run(figures.command, cwd=ROOT, stdout=sys.stderr, check=True)
            page = ROOT / "docs" / f"{figures.page}.md"
            parts.replace(page, what, figures.write(folder, shlex.join(figures.command)))
            print(f"{page}: {what}")
    except (parts.PageError, subprocess.CalledProcessError, OSError, KeyError) as error:
        print(f"write-figures: {error}", file=sys.stderr)
        return 1
    return 0
