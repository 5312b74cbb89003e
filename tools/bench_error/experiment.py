"""What is run: each method at each of its settings, on each scene, with several seeds, in turns.

In turns, so that whatever else the machine does meets all contestants alike. A repetition has a seed of its
own: the same seed would give the same image, and one seed's error says little.
"""

from dataclasses import asdict, dataclass

from bench_error.images import errors

FIXED = ("random", "sobol")
ADAPTIVE = "adaptive"


@dataclass(frozen=True)
class Contestant:
    method: str  # of FIXED, or ADAPTIVE
    setting: float  # samples a pixel, or the target error

    def options(self, seed, max_spp):
        if self.method != ADAPTIVE:
            return ["--spp", str(self.setting), "--sampler", self.method, "--seed", str(seed)]
        limit = ["--max-spp", str(max_spp)] if max_spp else []
        return ["--target-error", repr(self.setting), "--sampler", "sobol", "--seed", str(seed), *limit]


@dataclass(frozen=True)
class Measurement:
    scene: str
    method: str
    setting: float
    seed: int
    cpu: float
    wall: float
    rmse: float
    relmse: float
    max: float
    flip: float | None = None


def contestants(spps, targets):
    fixed = [Contestant(method, spp) for spp in spps for method in FIXED]
    return fixed + [Contestant(ADAPTIVE, target) for target in targets]


def measure(program, files, references, plan, repeats, seeds, max_spp, with_flip, progress):
    """Measurements of all contestants in `repeats` rounds; more rounds of the adaptive ones up to `seeds`.

    `files` are scene files by name, `references` their references; progress(text) is told what runs.
    """
    measurements = []
    for number in range(max(repeats, seeds)):
        for name, file in files.items():
            for contestant in plan:
                if number >= (seeds if contestant.method == ADAPTIVE else repeats):
                    continue
                progress(f"seed {number + 1}: {name}, {contestant.method} {contestant.setting:g}")
                run = program.render(file, contestant.options(number + 1, max_spp))
                found = errors(run.image, references[name].image, with_flip)
                measurements.append(
                    Measurement(name, contestant.method, contestant.setting, number + 1, run.cpu_seconds,
                                run.wall_seconds, **found)
                )
    return measurements


def as_json(measurements):
    return [asdict(measurement) for measurement in measurements]
