"""Measures one run of many scenes against a run for each: its share of their time, with a shader cache of the driver
that knows the scenes, and with one that is empty at first."""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def seconds(commands, environment):
    """CPU time and wall clock of processes, one after the other."""
    cpu, begin = 0.0, time.monotonic()
    for command in commands:
        process = subprocess.Popen(command, env=environment)
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            raise subprocess.CalledProcessError(status, command)
        cpu += usage.ru_utime + usage.ru_stime
    return cpu, time.monotonic() - begin


def shares(program, scenes, rounds):
    """One run's share of the time of a run for each scene, [warm CPU, warm wall, cold CPU, cold wall], least of the
    rounds; warm and cold is the driver's shader cache."""
    with tempfile.TemporaryDirectory() as folder:
        options = ["--width", "600", "-q"]
        # Copies, as a scene's name is its picture's, with whatever meshes lie beside it.
        copies = []
        for number, scene in enumerate(scenes):
            copy = Path(folder) / str(number)
            copy.mkdir()
            for file in scene.parent.glob("*.obj"):
                (copy / file.name).symlink_to(file)
            copies.append(copy / f"scene{number}.txt")
            copies[-1].write_bytes(scene.read_bytes())
        each = [[program, copy, "-o", Path(folder) / f"{copy.stem}.bmp", *options] for copy in copies]
        together = [[program, *copies, "-o", f"{folder}/{{}}.bmp", *options]]
        best = [float("inf")] * 4
        for number in range(rounds):
            for place, is_cold in ((0, False), (2, True)):
                found = []
                for which, commands in (("each", each), ("together", together)):
                    cache = f"{folder}/cache-{number}-{which}" if is_cold else f"{folder}/cache"
                    environment = {**os.environ, "MESA_SHADER_CACHE_DIR": cache}
                    if not is_cold:
                        seconds(together, environment)
                    found.append(seconds(commands, environment))
                for i in range(2):
                    best[place + i] = min(best[place + i], found[1][i] / found[0][i])
        return best


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="bench-batch", description=__doc__, allow_abbrev=False)
    parser.add_argument("--program", type=Path, default=ROOT / "build/host/lavaray", metavar="FILE",
                        help="the lavaray to measure (default: build/host/lavaray of this checkout)")
    parser.add_argument("--rounds", type=int, default=3, metavar="N", help="the least counts (default: 3)")
    parser.add_argument("--out", type=Path, default=ROOT / "build/bench-batch", metavar="FOLDER",
                        help="for bench-batch.json (default: build/bench-batch of this checkout)")
    options = parser.parse_args(arguments)
    here = sorted((ROOT / "scenes").glob("*.txt"))
    batches = {"`scenes/torus.txt`, 40 times": [ROOT / "scenes/torus.txt"] * 40,
               f"the {len(here)} scenes of `scenes/`, each twice": here * 2}
    try:
        found = {name: shares(options.program.resolve(), scenes, options.rounds) for name, scenes in batches.items()}
        options.out.mkdir(parents=True, exist_ok=True)
        (options.out / "bench-batch.json").write_text(json.dumps(found, indent=1) + "\n")
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"bench-batch: {error}", file=sys.stderr)
        return 1
    for name, best in found.items():
        print(f"{name}: CPU time {best[0]:.2f}, wall clock {best[1]:.2f}; with an empty cache {best[2]:.2f}, {best[3]:.2f}")
    return 0
