"""Runs lavaray as a subprocess, times subprocesses, and keeps references from one run of the benchmark to the next."""

import hashlib
import os
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from bench_error.images import mean, read_pfm, rmse, write_pfm

REFERENCE_SEEDS = (1000003, 2000003)  # of the two halves; no contestant uses either


class ProgramError(Exception):
    """The program is missing, is too old or has failed; the message says all that is known."""


@dataclass
class Run:
    image: object
    cpu_seconds: float  # user and system time, of all threads
    wall_seconds: float


@dataclass
class Reference:
    image: object
    rmse: float  # its own estimate
    samples: int


class Program:
    def __init__(self, path, extra_options=()):
        self.path = Path(path)
        self.extra_options = list(extra_options)
        if not os.access(self.path, os.X_OK):
            raise ProgramError(f"{self.path} is not there: build it (tools/render does), or name it by --program")
        self.version = self.text("--version")
        missing = [o for o in ("--spp", "--seed", "--sampler", "--target-error") if o not in self.text("--help")]
        if missing:
            raise ProgramError(f"{self.path} does not know {', '.join(missing)}: it is too old for this benchmark")

    def text(self, option):
        run = subprocess.run([self.path, option], capture_output=True, text=True, check=False)
        if run.returncode != 0:
            raise ProgramError(f"{self.path} {option} failed with exit code {run.returncode}: {run.stderr.strip()}")
        return run.stdout

    def identity(self):
        """Each build counts as a program of its own."""
        return f"{self.version.strip()} {self.path.stat().st_mtime_ns} {' '.join(self.extra_options)}"

    def render(self, scene_file, options):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "image.pfm"
            cpu, wall = timed([self.path, scene_file, "-o", output, *options, *self.extra_options])
            return Run(read_pfm(output), cpu, wall)


def timed(command, folder=None, environment=None):
    """Processor and clock seconds of a command, of that process alone: wait4 counts one child, getrusage would count
    all that there ever were. `environment` is added to the present one."""
    with tempfile.TemporaryFile() as messages:
        start = time.perf_counter()
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=messages, stderr=messages, cwd=folder,
                                 env={**os.environ, **(environment or {})})
        try:
            _, status, usage = os.wait4(child.pid, 0)
        except KeyboardInterrupt:
            child.kill()
            child.wait()
            raise
        wall = time.perf_counter() - start
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            messages.seek(0)
            said = messages.read().decode(errors="replace")[-2000:].strip()
            line = " ".join(str(word) for word in command)
            raise ProgramError(f"{line}\nfailed with exit code {child.returncode}: {said}")
    return usage.ru_utime + usage.ru_stime, wall


def write_scene(scene, folder):
    """Writes the scene's files to a folder of their own; returns the scene file."""
    own = folder / scene.name
    own.mkdir(parents=True, exist_ok=True)
    for name, obj in scene.meshes.items():
        (own / name).write_text(obj)
    file = own / f"{scene.name}.txt"
    file.write_text(scene.text)
    return file


def reference(program, scene, scene_file, samples, error, folder, any_build=False):
    """The mean of two halves with seeds of their own. Half their difference is what is left of the error, if
    the halves are independent: rmse(a - b) / 2 = rmse of (a + b) / 2. Where that is above `error`, it has four times
    the samples, or more. With any_build a kept reference of another build of the program will do."""
    halves = [reference_half(program, scene, scene_file, max(samples // 2, 1), seed, folder, any_build)
              for seed in REFERENCE_SEEDS]
    left = rmse(*halves) / 2
    if left > error:
        return reference(program, scene, scene_file, 4 * samples, error, folder, any_build)
    return Reference(mean(*halves), left, 2 * max(samples // 2, 1))


def reference_half(program, scene, scene_file, samples, seed, folder, any_build):
    meshes = [f"{name}\n{obj}" for name, obj in sorted(scene.meshes.items())]
    name = f"{scene.name}-{short_hash(scene.text, str(samples), *meshes)}"
    file = folder / f"{name}-{short_hash(program.identity())}-{seed}.pfm"
    kept = sorted(folder.glob(f"{name}-*-{seed}.pfm"), key=lambda f: f.stat().st_mtime)
    if any_build and kept:
        file = kept[-1]
    if not file.exists():
        folder.mkdir(parents=True, exist_ok=True)
        options = ["--spp", str(samples), "--sampler", "sobol", "--seed", str(seed)]
        part = file.with_suffix(".part")  # so that an interrupted run leaves no unfinished reference
        write_pfm(part, program.render(scene_file, options).image)
        part.rename(file)
    return read_pfm(file)


def short_hash(*parts):
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:12]
