"""The program: options, and the story from scenes to files."""

import argparse
import json
import math
import os
import platform
import sys
from pathlib import Path

from bench_error import analysis, experiment, images, plot, povray, running, scenes
from bench_error.tables import Report

ROOT = Path(__file__).resolve().parents[2]
REFERENCE_SHARE = 0.3  # of the smallest target: the error that a reference may have; it adds 4 % to a true error

DESCRIPTION = """\
Measures how far lavaray's images are from the truth and what that costs: fixed sampling, random and Owen-Sobol,
against adaptive sampling to a target error. Prints tables and saves them with all measurements (JSON) and plots
(SVG, and PNG where matplotlib is installed). The references take the longest, most of an hour on two cores
(with --quick a few minutes); they are kept until the program is built anew, with --keep-references for longer.

Where POV-Ray is installed, it takes part on the scenes that it can show equally. For some these are variants of a
scene, named after it with -peer, and lavaray is measured on the variants, too.
"""

EPILOG = """\
examples:
  tools/bench-error --quick                       a first look
  tools/bench-error --repeats 1                   the slopes and errors of docs/sampling.md
  tools/bench-error --size 640x480 --spp 4,16,64 --targets 0.005,0.002,0.001 --repeats 1 --seeds 3
                                                  the times of docs/sampling.md
  tools/bench-error --scenes edges,penumbra --spp 4,16,64 --targets ''
  tools/bench-error --size 640x480 --clock wall   larger images, where start-up counts for less

Run it on an idle machine. Seeds make the errors reproducible; times are not.
"""


def numbers(kind, check):
    def parse(text):
        try:
            values = [kind(word) for word in text.split(",") if word.strip()]
        except ValueError:
            raise argparse.ArgumentTypeError(f"'{text}' is not a list of numbers with commas between them") from None
        if not all(check(value) for value in values):
            raise argparse.ArgumentTypeError(f"'{text}' holds a number out of range")
        return values

    return parse


def size(text):
    width, _, height = text.partition("x")
    if not (width.isdigit() and height.isdigit() and int(width) and int(height)):
        raise argparse.ArgumentTypeError(f"'{text}' is not a size such as 160x120")
    return int(width), int(height)


def scene_names(text):
    names = text.split(",")
    unknown = [name for name in names if name not in scenes.GENERATORS]
    if unknown:
        raise argparse.ArgumentTypeError(f"no scene '{unknown[0]}'; there are {', '.join(scenes.GENERATORS)}")
    return names


def positive(text):
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number above 0")
    return int(text)


def parse_options(arguments):
    parser = argparse.ArgumentParser(prog="bench-error", description=DESCRIPTION, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("--program", type=Path, default=ROOT / "build/host/lavaray", metavar="FILE",
        help="the lavaray to measure (default: build/host/lavaray of this checkout)")
    add("--out", type=Path, default=ROOT / "build/bench-error", metavar="FOLDER",
        help="for scenes, references and results (default: build/bench-error of this checkout)")
    add("--quick", action="store_true", help="up to 64 samples a pixel, targets down to 0.005")
    add("--scenes", type=scene_names, default=list(scenes.GENERATORS), metavar="A,B,..",
        help=f"which (default: all of {', '.join(scenes.GENERATORS)})")
    add("--size", type=size, default=(160, 120), metavar="WxH", help="of the images (default: 160x120)")
    add("--spp", type=numbers(int, lambda n: n > 0), metavar="N,N,..",
        help="samples a pixel of fixed sampling (default: 1,4,16,64,256,1024)")
    add("--targets", type=numbers(float, lambda e: e > 0), metavar="E,E,..",
        help="of adaptive sampling (default: 0.02,0.01,0.005,0.002; '' for none)")
    add("--max-spp", type=positive, metavar="N", help="limit of adaptive sampling (default: the program's own)")
    add("--repeats", type=positive, default=3, metavar="N",
        help="of each fixed run, each with another seed, in turns (default: 3)")
    add("--seeds", type=positive, default=5, metavar="N", help="of each adaptive run (default: 5)")
    add("--reference-spp", type=positive, metavar="N",
        help="samples a pixel of the references, at least (default: 16 times the most of --spp, at least 1024); "
             "they have more where their own error is not small against the least of --targets")
    add("--keep-references", action="store_true",
        help="take kept references of any build of the program: right as long as the pictures it makes are")
    add("--clock", choices=("cpu", "wall"), default="cpu",
        help="time that tables and plots show: of the processors, which a busy machine disturbs less, or of the "
             "clock (default: cpu); the JSON holds both")
    add("--device", metavar="NAME", help="passed on to the program")
    add("--povray", default="povray", metavar="FILE", help="POV-Ray to compare with (default: povray; '' for none)")
    options = parser.parse_args(arguments)
    if options.spp is None:
        options.spp = [1, 4, 16, 64] if options.quick else [1, 4, 16, 64, 256, 1024]
    if options.targets is None:
        options.targets = [0.02, 0.01, 0.005] if options.quick else [0.02, 0.01, 0.005, 0.002]
    if not options.spp and not options.targets:
        parser.error("neither --spp nor --targets: nothing to measure")
    if options.reference_spp is None:
        options.reference_spp = max(16 * max(options.spp, default=1), 1024)
    return options


def progress(text):
    if sys.stderr.isatty():
        print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)


def model_texts():
    return {name: (ROOT / f"scenes/{name}.obj").read_text() for name in ("torus", "knot")}


def missing_packages():
    """What is left out, by name."""
    notes = []
    if not images.flip_is_available():
        notes.append("flip_evaluator is not installed: no FLIP")
    if not plot.matplotlib_is_available():
        notes.append("matplotlib is not installed: no PNG, the plots are SVG only")
    return notes


def panels(report, names, clock):
    """For the plots: error against time, and against samples per pixel."""
    by_time, by_spp = [], []
    for name in names:
        curves = {m: report.curves[name, m] for m in (*experiment.FIXED, experiment.ADAPTIVE)}
        start = report.startup(name)
        times = {m: [(p.time(clock), p.rmse) for p in c if p.rmse > 0] for m, c in curves.items()}
        for method in experiment.PEERS:  # the settings that no other setting beats
            times[method] = analysis.monotone(analysis.by_time(report.curves[name, method], clock), clock)
        spps = {m: [(p.setting, p.rmse) for p in curves[m] if p.rmse > 0] for m in experiment.FIXED}
        by_time.append((name, times, start.time(clock) if start else None))
        by_spp.append((name, spps, None))
    return by_time, by_spp


def save(options, program, rival, report, measurements, references, text):
    out = options.out
    width, height = options.size
    result = {
        "program": program.version.strip(),
        "povray": rival.version if rival else None,
        "machine": {"system": platform.platform(), "processors": os.cpu_count()},
        "size": [width, height],
        "clock": options.clock,
        "references": {name: {"spp": r.samples, "rmse": r.rmse} for name, r in references.items()},
        "summary": report.summary(),
        "measurements": experiment.as_json(measurements),
    }
    (out / "bench-error.json").write_text(json.dumps(result, indent=1) + "\n")
    (out / "bench-error.txt").write_text(text)
    by_time, by_spp = panels(report, [scene.name for scene in report.scenes], options.clock)
    title = f"{program.version.strip().splitlines()[0]}: error of {width} x {height} pixels against "
    for name, what, label, chosen in (
        ("error-time", f"{options.clock} time", f"{options.clock} seconds", by_time),
        ("error-spp", "samples a pixel", "samples a pixel", by_spp),
    ):
        (out / f"{name}.svg").write_text(plot.svg(title + what, label, chosen))
        if plot.matplotlib_is_available():
            plot.write_png(out / f"{name}.png", title + what, label, chosen)


def run(options):
    extra = ["--device", options.device] if options.device else []
    program = running.Program(options.program, extra)
    rival = povray.find(options.povray, options.size) if options.povray else None
    notes = missing_packages()
    if options.povray and not rival:
        notes.append(f"{options.povray} is not installed: no comparison with POV-Ray")
    for note in notes:
        print(note, file=sys.stderr)
    chosen = scenes.make_scenes(options.scenes, options.size, model_texts())
    peers = povray.Peers({}, {}, {})
    texts, left_out = povray.peer_scenes(chosen, options.size) if rival else ([], {})
    chosen += [scene for scene, _ in texts if scene.variant]
    files = {scene.name: running.write_scene(scene, options.out / "scenes") for scene in chosen}
    if rival:
        peers = povray.prepare(rival, program, texts, files, left_out, progress)
    references = {}
    for scene in chosen:
        progress(f"reference of {scene.name}, {options.reference_spp} samples a pixel")
        references[scene.name] = running.reference(program, scene, files[scene.name], options.reference_spp,
                                                   REFERENCE_SHARE * min(options.targets, default=math.inf),
                                                   options.out / "references", options.keep_references)
    teams = [experiment.Team(program, files, experiment.contestants(options.spp, options.targets)),
             experiment.Team(rival, peers.files, povray.contestants(options.quick))]
    measurements = experiment.measure(teams, references, options.repeats, options.seeds, options.max_spp,
                                      images.flip_is_available(), progress)
    progress("")
    report = Report(chosen, measurements, references, options.targets, options.clock, peers)
    text = "\n".join([*notes, "", report.text()]) if notes else report.text()
    save(options, program, rival, report, measurements, references, text)
    print(report.text())
    print(f"saved in {options.out}: bench-error.json, bench-error.txt, error-time.svg, error-spp.svg")


def main(arguments=None):
    options = parse_options(arguments)
    try:
        run(options)
    except (running.ProgramError, OSError, ValueError) as error:
        print(f"bench-error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("\nbench-error: interrupted", file=sys.stderr)
        return 130
    return 0
