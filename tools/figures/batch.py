"""Many scenes in one process, against a process for each."""

import os
import subprocess
import tempfile
import time
from pathlib import Path


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
