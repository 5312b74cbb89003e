"""The program: builds what it measures, runs bench-speed and the comparison of whole programs."""

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

from bench_speed import plot, processes, tunings

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
SIDES = (256, 512, 1024, 2048)  # of pictures, in pixels

DESCRIPTION = """\
Measures lavaray's speed: rays, pictures and builds against Embree in one process (the program bench-speed, which
this builds), specialized against general pipelines, and whole programs, from scene file to image file, against
POV-Ray 3.7. Embree and POV-Ray are optional: what is missing is named. Prints tables and saves them with all times
(JSON) and plots of time against the size of scene and picture (SVG).
"""

EPILOG = """\
All other options go to the program bench-speed; {}
"""


def positive(text):
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number above 0")
    return int(text)


def parse_options(arguments):
    parser = argparse.ArgumentParser(prog="bench-speed", description=DESCRIPTION, add_help=False, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("-h", "--help", action="store_true", help="print this and the options of the program bench-speed")
    add("--only", choices=("rays", "sizes", "pipelines", "processes", "tunings"),
        help="one part: the program bench-speed; the same with pictures of several sizes; specialized against general "
             "pipelines; whole programs; or the ways to trace on each driver that tools/unpack-drivers has unpacked")
    add("--out", type=Path, default=BUILD / "bench-speed", metavar="FOLDER",
        help="for results (default: build/bench-speed of this checkout)")
    add("--quick", action="store_true", help="a first look: few scenes, 3 rounds")
    add("--rounds", type=positive, metavar="N", help="how often each contestant runs, in turns (default: 7)")
    add("--device", metavar="NAME", help="Vulkan device (default: the best one)")
    options, further = parser.parse_known_args(arguments)
    if options.rounds is None:
        options.rounds = 3 if options.quick else 7
    # One number of rays a lane is quicker, all of them make the plots.
    all_lanes = [] if options.quick or "--rays-per-lane" in further else ["--rays-per-lane", "4,2,1"]
    options.further = [*further, *all_lanes]
    if options.help:
        parser.epilog = EPILOG.format(program_help())
        parser.print_help()
    return options


def program(name):
    return BUILD / ("tools/bench_speed" if name.startswith("bench-") else "host") / name


def program_help():
    if not program("bench-speed").exists():
        return "its --help can be shown once this has built it."
    command = [program("bench-speed"), "--help"]
    return "its --help:\n\n" + subprocess.run(command, capture_output=True, text=True, check=True).stdout


def build(targets):
    """What the build prints goes to stderr: stdout is for results."""
    configure = ["cmake", "--preset", "release", "-DLAVARAY_BENCHMARKS=ON"]
    if not (BUILD / "CMakeCache.txt").exists():
        configure.append("-DBUILD_TESTING=OFF")  # as tools/render does
    make = ["cmake", "--build", "--preset", "release", "--target", *targets]
    for command in ([ROOT / "tools/setup", "build"], configure, make):
        subprocess.run(command, cwd=ROOT, stdout=sys.stderr, check=True)


def run_bench_speed(options, name, *arguments):
    """Prints what the program prints, saves it as NAME.txt, and returns what it saves as NAME.json."""
    file = options.out / f"{name}.json"
    command = [program("bench-speed"), "--json", file, "--rounds", str(options.rounds), *arguments]
    command += ["--device", options.device] if options.device else []
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as child:
        with open(options.out / f"{name}.txt", "w") as copy:
            for line in child.stdout:
                print(line, end="", flush=True)
                copy.write(line)
    if child.returncode != 0:
        raise processes.ProgramError(f"bench-speed failed with exit code {child.returncode}")
    return json.loads(file.read_text())


def measure_rays(options):
    results = run_bench_speed(options, "rays", *(["--quick"] if options.quick else []), *options.further)
    (options.out / "rays.svg").write_text(plot.scenes_svg(results))
    print(f"\nsaved in {options.out}: rays.txt, rays.json, rays.svg")


def measure_sizes(options):
    runs = [run_bench_speed(options, f"size-{side}", "--meshes", "bunny", "--parts", "rays,pictures", "--size",
                            f"{side},{side}", *options.further)
            for side in SIDES[:2 if options.quick else None]]
    if any(run["skipped"] for run in runs):
        return
    (options.out / "sizes.svg").write_text(plot.sizes_svg(runs))
    print(f"\nsaved in {options.out}: size-*.txt, size-*.json, sizes.svg")


def measure_pipelines(options):
    """Specialized against general pipelines, without a cache of shaders."""
    command = [program("bench-pipelines"), str(options.rounds), options.device or "",
               *sorted((ROOT / "scenes").glob("*.txt")), *sorted((ROOT.parent / "shared/course").glob("scene?.txt"))]
    run = subprocess.run(command, capture_output=True, text=True, check=False,
                         env=os.environ | {"MESA_SHADER_CACHE_DISABLE": "true"})
    if run.returncode != 0:
        raise processes.ProgramError(f"bench-pipelines failed: {run.stderr}")
    print("\n" + run.stdout)
    (options.out / "pipelines.txt").write_text(run.stdout)


def measure_processes(options):
    results = processes.measure(program("lavaray"), program("lavaray-diff"), ROOT.parent / "shared", options.out,
                                options.rounds, ["--device", options.device] if options.device else [])
    text = processes.report(results)
    print("\n" + text)
    (options.out / "processes.txt").write_text(text)
    (options.out / "processes.json").write_text(json.dumps(results, indent=1) + "\n")
    print(f"saved in {options.out}: processes.txt, processes.json")


def measure_tunings(options):
    results = tunings.measure(program("lavaray"), ROOT, options.rounds)
    text = tunings.report(results)
    print("\n" + text)
    (options.out / "tunings.txt").write_text(text)
    (options.out / "tunings.json").write_text(json.dumps(results, indent=1) + "\n")
    print(f"saved in {options.out}: tunings.txt, tunings.json")


def main(arguments=None):
    try:
        options = parse_options(arguments)
        if options.help:
            return 0
        options.out.mkdir(parents=True, exist_ok=True)
        build(["bench-speed", "bench-pipelines", "lavaray", "lavaray-diff"])
        if options.only in (None, "rays"):
            measure_rays(options)
        if options.only in (None, "sizes"):
            measure_sizes(options)
        if options.only in (None, "pipelines"):
            measure_pipelines(options)
        if options.only in (None, "processes"):
            measure_processes(options)
        if options.only in (None, "tunings"):
            measure_tunings(options)
    except (processes.ProgramError, subprocess.CalledProcessError, OSError) as error:
        print(f"bench-speed: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("\nbench-speed: interrupted", file=sys.stderr)
        return 130
    return 0
