"""How sharp the estimate is by which a target error is reached: the true error of renders, in parts of the target.

All renders are made by one process, by the Python package, so that many small pictures take minutes.
"""

import argparse
import json
import sys
from pathlib import Path

from bench_error import scenes, tables, more_scenes
from bench_error.running import write_scene

ROOT = Path(__file__).resolve().parents[2]
REFERENCE_SEEDS = (1000003, 2000003)  # no other render uses either
REFERENCE_PART = 0.3  # of the least target: what the two halves of a reference are rendered to
ALL = {**scenes.GENERATORS, **more_scenes.MORE}


def parse_options(arguments):
    parser = argparse.ArgumentParser(prog="bench-estimate", description=__doc__)
    add = parser.add_argument
    add("--package", type=Path, default=ROOT / "build/python", metavar="FOLDER",
        help="that has the Python package (default: build/python of this checkout)")
    add("--out", type=Path, default=ROOT / "build/bench-estimate", metavar="FOLDER", help="for scenes and references")
    add("--scenes", default=",".join(ALL), metavar="A,B,..", help=f"which (default: all of {', '.join(ALL)})")
    add("--targets", default="0.02,0.01,0.005,0.002,0.001", metavar="E,E,..", help="default: %(default)s")
    add("--seeds", type=int, default=10, metavar="N", help="of each (default: 10)")
    options = parser.parse_args(arguments)
    options.scenes = options.scenes.split(",")
    unknown = [name for name in options.scenes if name not in ALL]
    if unknown:
        parser.error(f"no scene '{unknown[0]}'; there are {', '.join(ALL)}")
    options.targets = [float(target) for target in options.targets.split(",")]
    return options


class Bench:
    size = (160, 120)

    def __init__(self, options):
        sys.path.insert(0, str(options.package))
        import lavaray  # from the folder that was asked for
        import numpy

        self.options = options
        self.numpy = numpy
        self.read = lavaray.Scene.read
        self.renderer = lavaray.Renderer()
        self.models = {name: (ROOT / f"scenes/{name}.obj").read_text() for name in ("torus", "knot")}

    def render(self, scene, target, seed):
        picture = self.renderer.render(scene, width=self.size[0], height=self.size[1], target_error=target, seed=seed)
        return picture.image.astype(self.numpy.float64), picture

    def reference(self, name, scene):
        """The picture, and the squared error that it is left with itself."""
        target = REFERENCE_PART * min(self.options.targets)
        file = self.options.out / f"{name}-{target:g}.npz"
        if not file.exists():
            halves = [self.render(scene, target, seed)[0] for seed in REFERENCE_SEEDS]
            left = self.numpy.mean((halves[0] - halves[1]) ** 2) / 4
            self.numpy.savez(file, image=(halves[0] + halves[1]) / 2, left=left)
        kept = self.numpy.load(file)
        return kept["image"], float(kept["left"])

    def parts(self, scene, target, reference, left):
        """Of one target: each run's true error and the mean of their samples a pixel."""
        parts, samples = [], []
        for seed in range(1, self.options.seeds + 1):
            image, picture = self.render(scene, target, seed)
            square = max(float(self.numpy.mean((image - reference) ** 2)) - left, 0.0)
            parts.append(square**0.5 / target)
            samples.append(picture.samples_per_pixel)
        return parts, sum(samples) / len(samples)

    def rows(self, name):
        scene = self.read(str(write_scene(ALL[name](self.size, self.models), self.options.out)))
        reference, left = self.reference(name, scene)
        medians, all_parts = [], []
        for target in self.options.targets:
            parts, samples = self.parts(scene, target, reference, left)
            medians.append(f"{self.numpy.median(parts):.2f} ({samples:.1f})")
            all_parts += parts
        return all_parts, [name, *medians, *self.summary(all_parts)]

    def summary(self, parts):
        return [f"{self.numpy.median(parts):.2f}", f"{self.numpy.quantile(parts, 0.97):.2f}", f"{max(parts):.2f}"]


def main(arguments):
    options = parse_options(arguments)
    bench = Bench(options)
    everything, rows = [], []
    for name in options.scenes:
        parts, row = bench.rows(name)
        everything += parts
        rows.append(row)
        print(*row, file=sys.stderr, flush=True)
    rows.append(["all", *([""] * len(options.targets)), *bench.summary(everything)])
    header = ["scene", *(f"{target:g}" for target in options.targets), "median", "97 %", "largest"]
    print(tables.table("True RMSE in parts of the target: medians (samples a pixel), and of all runs", header, rows))
    over = sum(part > 1 for part in everything)
    found = {"rows": rows, "header": header, "runs": len(everything), "over": over}
    (options.out / "bench-estimate.json").write_text(json.dumps(found, indent=1) + "\n")
    print(f"{len(everything)} runs, {over} with more than the target, {sum(p > 1.1 for p in everything)} with over 1.1")
    return 0
