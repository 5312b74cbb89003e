"""The program."""

import argparse
import shlex
import sys
from pathlib import Path

from farm_jobs import jobs
from farm_jobs.plan import PlanError, is_done, join, plan_picture

ROOT = Path(__file__).resolve().parents[2]

DESCRIPTION = """\
Renders pictures in parts on many machines: submits a Slurm job array with a task for each part and a job that merges
the parts when all are done, bit for bit the picture that one machine makes. Run again, it submits only what is
missing or damaged, and a task goes on from its checkpoint. All machines must see the same files.
"""

EPILOG = """\
All other options go to lavaray (--width, --spp, --seed ...), but for --checkpoint, --crop, --resume, --sample-range
and --watch, which are the farm's own.

  tools/farm poster.txt --width 30000 --spp 1024 --parts 400 -o poster.png
  tools/farm sweep/*.txt -o 'pictures/{}.png'
  tools/farm poster.txt --parts 16 --print=tasks -o poster.png | parallel
  tools/farm poster.txt --parts 16 --print=openjd -o poster.png >poster.json && openjd run poster.json
"""

THE_FARMS_OWN = ("--checkpoint", "--checkpoint-every", "--crop", "--resume", "--sample-range", "--watch", "--display",
                 "--json", "--check", "--list-devices")


def positive(text):
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number above 0")
    return int(text)


def parse_options(arguments):
    parser = argparse.ArgumentParser(prog="farm", description=DESCRIPTION, epilog=EPILOG, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("scenes", nargs="+", type=Path, metavar="SCENE", help="scene files")
    add("-o", "--output", required=True, metavar="OUT",
        help="the picture; of several scenes the pictures, where {} stands for a scene's name without its ending")
    add("--parts", type=positive, default=1, metavar="N", help="tasks a picture (default: 1)")
    add("--by", choices=("rows", "samples"), default="rows",
        help="what the parts divide: the picture's rows, in strips that cost about the same (default), or the samples "
        "of --spp, where each part is a file of the whole picture's size")
    add("--folder", type=Path, metavar="DIR", help="for parts, scripts and logs (default: OUT with .farm)")
    add("--print", nargs="?", const="commands", choices=("commands", "tasks", "merge", "openjd"),
        help="submit nothing, but print the sbatch commands; or the tasks that are left, a shell command a line; or the "
        "command that merges; or all as a template for OpenJD")
    add("--sbatch", default="", metavar="OPTIONS", help="more options for sbatch, as one word: '--partition=x --mem=4G'")
    add("--programs", type=Path, default=ROOT / "build" / "host", metavar="DIR",
        help="where lavaray is (default: this checkout's build)")
    options, others = parser.parse_known_args(arguments)
    for option in others:
        if option.split("=")[0] in THE_FARMS_OWN:
            parser.error(f"{option} is not for the farm's pictures")
    # `--name=value` and `--name value` are the same to lavaray.
    options.render = [word for option in others
                      for word in (option.split("=", 1) if option.startswith("--") else [option])]
    if Path("-") in options.scenes:
        parser.error("a scene must be a file that all machines see, which standard input is not")
    if len(options.scenes) > 1 and "{}" not in options.output:
        parser.error("of several scenes OUT must have {}, for the scene's name")
    return options


def outputs(options):
    """The picture of each scene."""
    here = Path.cwd()
    pictures = [here / options.output.replace("{}", scene.stem) for scene in options.scenes]
    for i, picture in enumerate(pictures):
        if picture in pictures[:i]:
            raise PlanError(f"{options.scenes[i]} and {options.scenes[pictures.index(picture)]} would both be "
                            f"{picture}")
    return pictures


def run(options):
    here = Path.cwd()
    programs = (here / options.programs).resolve()
    if not (programs / "lavaray-merge").exists():
        raise PlanError(f"there is no lavaray-merge in {programs}; build it, or name its folder by --programs")
    wanted = outputs(options)
    folder = here / (options.folder or options.output.replace("{}", "all") + ".farm")
    pictures = [plan_picture(programs, here / scene, options.render, options.parts, options.by, output, folder)
                for scene, output in zip(options.scenes, wanted)]
    removed = jobs.forget_other_pictures(folder, pictures)
    if removed:
        print(f"{removed} parts were of other scenes or options, and are removed", file=sys.stderr)
    tasks = jobs.write_folder(folder, here, pictures)
    left = [i for i, task in enumerate(tasks) if not is_done(programs, task)]
    print(f"{len(tasks) - len(left)} of {len(tasks)} tasks are done already", file=sys.stderr)

    name = wanted[0].stem if len(wanted) == 1 else "lavaray"
    commands = jobs.slurm_commands(folder, left, name, shlex.split(options.sbatch))
    if options.print == "commands":
        print(jobs.as_script(commands))
    elif options.print == "tasks":
        print("\n".join(join(["sh", folder / "task.sh", number]) for number in left))
    elif options.print == "merge":
        print(join(["sh", folder / "merge.sh"]))
    elif options.print == "openjd":
        print(jobs.openjd_template(folder, left, name))
    else:
        print(f"submitted: {' '.join(jobs.submit(commands))}", file=sys.stderr)


def main():
    try:
        run(parse_options(sys.argv[1:]))
    except PlanError as error:
        print(f"farm: {error}", file=sys.stderr)
        return 2
    return 0
