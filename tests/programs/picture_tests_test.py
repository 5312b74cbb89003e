#!/usr/bin/env python3
"""picture_tests_test.py BUILD CONSUMER MANUAL CMAKE SCRATCH: a project of somebody else with picture tests, in the folder
CONSUMER, is built against an install of BUILD; what ctest prints and leaves is looked at. So is the project that MANUAL,
docs/testing-pictures.md, makes from zero. SCRATCH is made anew."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, demand, described, finish, make_anew

build, consumer, manual, cmake = (pathlib.Path(argument) for argument in sys.argv[1:5])
scratch = pathlib.Path(sys.argv[5]).resolve()
source, binary = scratch / "the source", scratch / "the build"
pictures = binary / "lavaray-pictures"
FAIL = {"consumer.soft-ball", "consumer/brighter gradient", "consumer.new"}
ALL = FAIL | {"consumer.ball", "consumer.gradient"}
FIXTURE = {"lavaray-pictures-begin", "lavaray-pictures-report"}


def run(*command, **environment):
    return subprocess.run(command, env=os.environ | environment, capture_output=True, text=True)


def ctest(*options, **environment):
    """The finished process, and for each test how it went."""
    environment.setdefault("LAVARAY_UPDATE_REFERENCES", "0")
    found = run(cmake.with_name("ctest"), "--test-dir", binary, *options, **environment)
    results = re.findall(r"^ *\d+/\d+ Test +#\d+: (.*?) \.*\.* *(Passed|\*\*\*\w+)", found.stdout, re.M)
    return found, {name: result.strip("*") for name, result in results}


def shown():
    page = (pictures / "report.html").read_text()
    return {pair["name"]: pair for pair in map(json.loads, re.findall(r'class="pair">(.*?)</script>', page))}


def configure(*options):
    return run(cmake, "-S", source, "-B", binary, f"-DCMAKE_PREFIX_PATH={scratch / 'prefix'}", *options)


def make():
    make_anew(scratch)
    shutil.copytree(consumer, source)
    # The compiler and its options are the consumer's own.
    for command in ((cmake, "--install", build, "--prefix", scratch / "prefix"),):
        found = run(*command)
        demand(found.returncode == 0, f"the install: {described(found)}")
    found = configure()
    demand(found.returncode == 0, f"the consumer is configured: {described(found)}")
    found = run(cmake, "--build", binary)
    demand(found.returncode == 0, f"the consumer is built: {described(found)}")


def failures():
    found, results = ctest("--output-on-failure", "-j2")
    check(found.returncode != 0, "the run fails", found)
    expected = {name: "Failed" if name in FAIL else "Passed" for name in ALL | FIXTURE}
    check(results == expected, f"the tests end as they must, not {results}", found)
    pairs = shown()
    check(set(pairs) == FAIL, f"one page has all that failed: {set(pairs)}")
    ball = pairs["consumer.soft-ball"]
    check(ball["verdict"] == "differs" and ball["limits"] == {"tolerance": 2, "maxDiffering": 10, "maxRmse": None, "maxFlip": 0.001},
          f"limits are passed on: {ball['limits']}")
    check(ball["driver"] and ball["image"]["device"] in ball["driver"], f"the driver is told: {ball['driver']}")
    gradient = pairs["consumer/brighter gradient"]["difference"]
    check(gradient["differing"] == gradient["pixels"] == 64 * 48, "every pixel is brighter by 9")
    check(pairs["consumer.new"]["verdict"] == "unreadable", "a reference that is missing is a failure")
    left = {path.name for path in (pictures / "consumer.soft-ball").iterdir()}
    check(left == {"actual.png", "reference.png", "difference.png", "comparison.json"}, f"what a failure leaves: {left}")
    check(not (pictures / "consumer.ball").exists(), "what passes leaves nothing")
    for what in ("actual", "reference", "difference"):
        check(f"lavaray-pictures: {what} {pictures}/consumer.soft-ball/{what}.png" in found.stdout, f"{what} is named", found)
    check(f"report {pictures}/report.html" in found.stdout and "LAVARAY_UPDATE_REFERENCES=1" in found.stdout, "so is what to do", found)
    found, results = ctest("-R", "consumer.ball")
    check(found.returncode == 0 and not (pictures / "report.html").exists(), "the next run begins anew", found)
    check(set(results) == FIXTURE | {"consumer.ball"}, f"it has {set(results)}")


def other_ends():
    found, results = ctest("-V", "-L", "pictures", VK_DRIVER_FILES="/nowhere.json", VK_ICD_FILENAMES="/nowhere.json")
    check(found.returncode == 0 and results["consumer.ball"] == results["consumer.soft-ball"] == "Skipped" and
          results["consumer.gradient"] == "Passed", f"without a driver: {results}", found)
    check("skipped: there is no software driver" in found.stdout and "/nowhere.json" in found.stdout, "the reason is told", found)
    # A program that writes nothing, while its last picture is still there.
    gradient = binary / "gradient.ppm"
    demand(gradient.exists(), "there is a picture")
    draw = (binary / "draw").rename(binary / "kept")
    (binary / "draw").write_text("#!/bin/sh\nexit 3\n")
    (binary / "draw").chmod(0o755)
    found, results = ctest("-R", "consumer.gradient", "--output-on-failure")
    check(results["consumer.gradient"] == "Failed" and "gradient.ppm 0 ended with 3" in found.stdout, "a program that fails", found)
    check(set(shown()) == {"consumer.gradient"}, "is on the page")
    draw.rename(binary / "draw")


def update():
    untouched = (source / "gradient.png").read_bytes(), (source / "ball.png").read_bytes()
    found, results = ctest("-V", "-R", "consumer.soft-ball|consumer.new|consumer.gradient", LAVARAY_UPDATE_REFERENCES="1")
    written = set(re.findall(r"lavaray-pictures: wrote (.*)$", found.stdout, re.M))
    check(found.returncode == 0 and written == {str(source / "ball.png"), str(source / "new/new.ppm")}, f"written: {written}", found)
    check((source / "gradient.png").read_bytes() == untouched[0], "a reference that is fine stays as it is")
    check((source / "ball.png").read_bytes() != untouched[1], "the other is another now")
    check((pictures / "updated.txt").read_text().split("\n")[:-1] == sorted(written), "a file lists them")
    found, results = ctest("-R", "consumer.soft-ball|consumer.new")
    check(found.returncode == 0, "afterwards they pass", found)
    found, results = ctest("-R", "brighter", "--output-on-failure", LAVARAY_UPDATE_REFERENCES="1")
    check(results["consumer/brighter gradient"] == "Failed" and "cannot be updated from a file that ends with .ppm" in " ".join(found.stdout.split()),
          "no picture is written under a wrong name", found)


def mistakes():
    good = (source / "CMakeLists.txt").read_text()
    for line, why in (
        ("lavaray_add_image_test(NAME x SCENE ball.txt)", "REFERENCE is missing"),
        ("lavaray_add_image_test(NAME x SCENE ball.txt REFERENCE x.jpg)", "must end with"),
        ("lavaray_add_image_test(NAME x SCENE ball.txt REFERENCE x.png OPTIONS -o y.png)", "must not name the output"),
        ("lavaray_add_image_test(NAME x SCENE ball.txt REFERENCE x.png TOLERANCE -1)", "TOLERANCE -1 is no number"),
        ("lavaray_add_image_test(NAME x SCENE ball.txt REFERENCE x.png REFLECT 1)", "not understood.*REFLECT"),
        ("lavaray_add_image_comparison(NAME x COMMAND draw IMAGE ${CMAKE_CURRENT_SOURCE_DIR}/x.png REFERENCE x.png)", "the same file"),
    ):
        (source / "CMakeLists.txt").write_text(good + line + "\n")
        found = configure()
        check(found.returncode != 0 and re.search(why, " ".join(found.stderr.split())), f"{line} is refused", found)
    (source / "CMakeLists.txt").write_text(good)


def from_zero():
    """What the manual's first section says, block for block."""
    section = manual.read_text().split("\n## ")[1]
    scene, project, commands = ("".join(line[4:] for line in block.splitlines(True))
                                for block in re.findall(r"(?:^    .*\n)+", section, re.M))
    folder = scratch / "zero"
    folder.mkdir()
    (folder / "scene.txt").write_text(scene)
    (folder / "CMakeLists.txt").write_text(project)
    found = subprocess.run(["bash", "-ec", commands], cwd=folder, capture_output=True, text=True, env=os.environ | {
        "CMAKE_PREFIX_PATH": str(scratch / "prefix"), "PATH": f"{cmake.parent}:{os.environ['PATH']}"})
    check(found.returncode == 0 and f"wrote {folder}/references/sphere.png" in found.stdout and "tests passed" in found.stdout,
          "the manual's commands work", found)
    (folder / "scene.txt").write_text(scene.replace("dif: 0.7", "dif: 0.6"))
    found = subprocess.run(["bash", "-ec", commands.splitlines()[-1]], cwd=folder, capture_output=True, text=True)
    check(found.returncode != 0 and (folder / "build/lavaray-pictures/report.html").exists(), "a change fails", found)


make()
for part in (failures, other_ends, update, mistakes, from_zero):
    part()
finish()
