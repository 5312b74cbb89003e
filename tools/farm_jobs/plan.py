"""What there is to do for a picture: the parts and how they are merged, as shell commands."""

import hashlib
import json
import shlex
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from farm_jobs import cuts

# Ranges of samples begin at multiples of it (kMaxSamplesPerItem in shaders/interface.h).
SAMPLES_PER_ITEM = 4
# Options that do not change what a picture costs from row to row, or that --view cost does not take.
NOT_FOR_ESTIMATE = ("--width", "--height", "--spp", "--target-error", "--max-spp", "--time-limit", "--seed", "--filter",
                    "--sampler", "--device")


class PlanError(Exception):
    """What was asked for cannot be done; the message says why."""


@dataclass
class Task:
    """Renders a part."""
    file: Path
    command: list


@dataclass
class Picture:
    tasks: list
    merge: list  # the command
    checksum: str  # of all that decides the parts


def join(words):
    return shlex.join(map(str, words))


def scene_facts(lavaray, scene, options):
    """Width and height of the picture that the options ask for, and the files that the scene is made of."""
    with tempfile.TemporaryDirectory() as folder:
        facts = Path(folder) / "facts.json"
        found = subprocess.run([lavaray, scene, *options, "--check", "--json", facts], capture_output=True, text=True)
        if found.returncode != 0:
            raise PlanError(found.stderr.strip())
        known = json.loads(facts.read_text())
    picture = known["picture"]
    return picture["width"], picture["height"], [scene, *(mesh["file"] for mesh in known["scene"]["meshFiles"])]


def checksum(files, command):
    digest = hashlib.sha256(join(command).encode())
    for file in files:
        digest.update(Path(file).read_bytes())
    return digest.hexdigest()


def value(options, name, default):
    return options[options.index(name) + 1] if name in options else default


def without(options, names):
    """The options without these, each of which has a value."""
    leave_out = {i + offset for i, option in enumerate(options) if option in names for offset in (0, 1)}
    return [option for i, option in enumerate(options) if i not in leave_out]


def by_samples(options, parts):
    """Every part has all pixels, and the same share of their samples."""
    samples = int(value(options, "--spp", "1"))
    groups = samples // SAMPLES_PER_ITEM
    if parts > groups:
        raise PlanError(f"{parts} parts of {samples} samples a pixel; at most {groups} are possible, of "
                        f"{SAMPLES_PER_ITEM} samples or more each")
    bounds = [groups * i // parts * SAMPLES_PER_ITEM for i in range(parts)] + [samples]
    return [["--sample-range", f"{first}:{end}"] for first, end in zip(bounds, bounds[1:])]


def by_rows(lavaray, scene, options, parts, width, height):
    """Strips of the picture that cost about the same, in an order in which neighbours are far apart."""
    try:
        costs = cuts.row_costs(lavaray, scene, without(options, NOT_FOR_ESTIMATE), height)
        rows = cuts.equal_cuts(costs, height, parts)
    except ValueError as error:
        raise PlanError(str(error)) from error
    strips = [["--crop", f"0,{first},{width},{end}"] for first, end in zip(rows, rows[1:])]
    return [strips[i] for i in cuts.interleaved(parts)]


def plan_picture(programs, scene, options, parts, by, output, folder):
    lavaray = programs / "lavaray"
    width, height, files = scene_facts(lavaray, scene, options)
    render = [lavaray, scene, *options, "-q"]
    if parts == 1:
        cut = [[]]
    elif by == "samples":
        cut = by_samples(options, parts)
    else:
        cut = by_rows(lavaray, scene, options, parts, width, height)
    films = [folder / f"{output.stem}-{i:04}.film" for i in range(parts)]
    tasks = [Task(film, [*render, *which, "-o", film]) for film, which in zip(films, cut)]
    merge = [programs / "lavaray-merge", *films, "-q", "-o", output]
    return Picture(tasks, merge, checksum(files, [*render, by, parts]))


def is_done(programs, task):
    """Whether the task's part is there, whole and complete."""
    check = [programs / "lavaray-merge", "--check", task.file]
    return task.file.exists() and subprocess.run(check, capture_output=True).returncode == 0
