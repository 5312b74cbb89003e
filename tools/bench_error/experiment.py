"""What is run: each method at each of its settings, on each scene, with several seeds, in turns.

In turns, so that whatever else the machine does meets all contestants alike. A repetition has a seed of its
own: the same seed would give the same image, and one seed's error says little. POV-Ray has no seeds: its repetitions
differ in time alone.
"""

from dataclasses import asdict, dataclass

from bench_error.images import errors

FIXED = ("random", "sobol")
ADAPTIVE = "adaptive"
PEERS = {"povray-am1": "+AM1", "povray-am2": "+AM2"}  # all of POV-Ray 3.7's methods


@dataclass(frozen=True)
class Contestant:
    method: str  # one of FIXED, ADAPTIVE, or one of PEERS
    setting: float | str  # samples per pixel, the target error, or POV-Ray's options

    def options(self, seed, max_spp):
        if self.method in PEERS:
            return [PEERS[self.method], *self.setting.split()]
        if self.method != ADAPTIVE:
            return ["--spp", str(self.setting), "--sampler", self.method, "--seed", str(seed)]
        limit = ["--max-spp", str(max_spp)] if max_spp else []
        return ["--target-error", repr(self.setting), "--sampler", "sobol", "--seed", str(seed), *limit]


@dataclass(frozen=True)
class Measurement:
    scene: str
    method: str
    setting: float | str
    seed: int
    cpu: float
    wall: float
    rmse: float
    relmse: float
    max: float
    flip: float | None = None


@dataclass(frozen=True)
class Team:
    """A program, and what it takes part in."""

    program: object  # with render(file, options)
    files: dict  # scene name -> file
    contestants: list


def label(method, setting):
    if method in PEERS:
        return f"povray {PEERS[method]} {setting}"
    return f"{method} {'E=' if method == ADAPTIVE else ''}{setting:g}"


def contestants(spps, targets):
    fixed = [Contestant(method, spp) for spp in spps for method in FIXED]
    return fixed + [Contestant(ADAPTIVE, target) for target in targets]


def measure(teams, references, repeats, seeds, max_spp, with_flip, progress):
    """Measurements of all contestants in `repeats` rounds; more rounds of the adaptive ones up to `seeds`.

    `references` by scene name; progress(text) is told what runs.
    """
    measurements = []
    for number in range(max(repeats, seeds)):
        for name in references:
            for team, contestant in entries(teams, name):
                if number >= (seeds if contestant.method == ADAPTIVE else repeats):
                    continue
                progress(f"seed {number + 1}: {name}, {label(contestant.method, contestant.setting)}")
                run = team.program.render(team.files[name], contestant.options(number + 1, max_spp))
                found = errors(run.image, references[name].image, with_flip)
                measurements.append(
                    Measurement(name, contestant.method, contestant.setting, number + 1, run.cpu_seconds,
                                run.wall_seconds, **found)
                )
    return measurements


def entries(teams, scene):
    return [(team, contestant) for team in teams if scene in team.files for contestant in team.contestants]


def as_json(measurements):
    return [asdict(measurement) for measurement in measurements]
