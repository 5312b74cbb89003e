"""Each way to trace (--tuning) on each driver: whole programs, from scene file to image file, with warm shader caches."""

import os
import subprocess
import tempfile
from pathlib import Path

from bench_error.tables import table
from bench_speed.processes import ProgramError, bunny_scene

TUNINGS = [f"{scene},{rays}" for scene in ("texels", "storage") for rays in (1, 2, 4)]


def drivers(folder):
    """Name and command prefix of each driver that tools/unpack-drivers has unpacked, or else of the installed one."""
    runs = sorted(folder.glob("*/run"))
    return [(run.parent.name, [run]) for run in runs] or [("installed", [])]


def scenes(root, folder):
    """Name and arguments of each render."""
    found = [("showcase, 1600 wide", [root / "scenes/showcase.txt", "--width", "1600"])]
    mesh = root.parent / "shared/meshes/stanford-bunny.obj"
    if mesh.exists():
        (folder / "bunny.txt").write_text(bunny_scene(mesh))
        found.append(("bunny, 1024 wide", [folder / "bunny.txt"]))
    return found


def cpu_seconds(command):
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as child:
        errors = child.stderr.read()
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise ProgramError(f"{' '.join(map(str, command))} failed: {errors.strip()}")
    return usage.ru_utime + usage.ru_stime


def measure(lavaray, root, rounds):
    """For each scene and driver the least CPU seconds of each tuning; the tunings take turns."""
    results = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for scene, arguments in scenes(root, folder):
            for driver, prefix in drivers(root / "build/drivers"):
                commands = {tuning: [*prefix, lavaray, *arguments, "-q", "-o", folder / "picture.pfm", "--tuning", tuning]
                            for tuning in TUNINGS}
                for command in commands.values():
                    cpu_seconds(command)  # fills the shader cache
                turns = [{tuning: cpu_seconds(command) for tuning, command in commands.items()} for _ in range(rounds)]
                results.append({"scene": scene, "driver": driver,
                                "seconds": {tuning: min(turn[tuning] for turn in turns) for tuning in TUNINGS}})
    return results


def report(results):
    rows = [[result["scene"], result["driver"], *(f"{result['seconds'][tuning]:.3f}" for tuning in TUNINGS)]
            for result in results]
    return table("CPU seconds of a whole process, the least, by how the scene is read and the most rays that an invocation "
                 "traces together", ["scene", "driver", *TUNINGS], rows)
