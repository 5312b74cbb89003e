"""A folder of tasks as scripts that anything can run, and what hands them to Slurm or OpenJD."""

import json
import subprocess

from farm_jobs.plan import PlanError, join

# Slurm's default for the largest array is 1001.
LARGEST_ARRAY = 1000

# An interrupted task has a checkpoint, from which it goes on; one that is of no use (exit code 3) is thrown away.
TASK_SCRIPT = """\
#!/bin/sh
# task.sh NUMBER: renders one part, from where an earlier run of it was ended.
cd {here} || exit 1
command=$(sed -n "$(($1 + 1))p" {folder}/tasks)
kept={folder}/$1.checkpoint
# The driver would take all cores of the machine, whatever the job was given.
if [ -n "$SLURM_CPUS_PER_TASK" ]; then export LP_NUM_THREADS=$SLURM_CPUS_PER_TASK; fi
code=3
if [ -e "$kept" ]; then
  eval "$command --checkpoint \\"\\$kept\\" --resume \\"\\$kept\\""
  code=$?
fi
if [ $code -eq 3 ]; then
  eval "$command --checkpoint \\"\\$kept\\""
  code=$?
fi
if [ $code -eq 0 ]; then rm -f "$kept"; fi
exit $code
"""

MERGE_SCRIPT = """\
#!/bin/sh
# merge.sh: merges the parts of each picture.
cd {here} || exit 1
set -e
{merges}
"""


def write_folder(folder, here, pictures):
    """Writes tasks, a line each, and the scripts that run one of them and merge all."""
    tasks = [task for picture in pictures for task in picture.tasks]
    merges = "\n".join(join(picture.merge) for picture in pictures)
    names = {"here": join([here]), "folder": join([folder]), "merges": merges}
    (folder / "tasks").write_text("".join(join(task.command) + "\n" for task in tasks))
    (folder / "task.sh").write_text(TASK_SCRIPT.format(**names))
    (folder / "merge.sh").write_text(MERGE_SCRIPT.format(**names))
    return tasks


def forget_other_pictures(folder, pictures):
    """Removes what is left of other scenes or options, which is of no use, and returns how many parts that were."""
    file = folder / "pictures.json"
    before = json.loads(file.read_text()) if file.exists() else {}
    now = {str(picture.tasks[0].file): picture.checksum for picture in pictures}
    removed = 0
    for picture in pictures:
        name = str(picture.tasks[0].file)
        if before.get(name) == now[name]:
            continue
        for task in picture.tasks:
            removed += task.file.exists()
            task.file.unlink(missing_ok=True)
    if before != now:  # They have the tasks' numbers, which are others now.
        for kept in folder.glob("*.checkpoint"):
            kept.unlink()
    folder.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(now, indent=1))
    return removed


def ranges(numbers):
    """Like 0-3,7,9-10."""
    text = []
    for number in sorted(numbers):
        if text and text[-1][1] == number - 1:
            text[-1][1] = number
        else:
            text.append([number, number])
    return ",".join(str(a) if a == b else f"{a}-{b}" for a, b in text)


def slurm_commands(folder, numbers, name, extra):
    """The sbatch commands: arrays of the tasks of these numbers, and last the merge, in which `$jobs` stands for the
    arrays' jobs. A task's number is its place in the array and an offset, since arrays have a largest number."""
    def sbatch(kind, script, *options):
        return ["sbatch", "--parsable", f"--job-name={name}{kind}", "--requeue", *options, *extra, "--wrap", script]

    commands = []
    for offset in range(0, max(numbers, default=-1) + 1, LARGEST_ARRAY):
        chosen = [n - offset for n in numbers if offset <= n < offset + LARGEST_ARRAY]
        if chosen:
            script = f"sh {join([folder / 'task.sh'])} $((SLURM_ARRAY_TASK_ID + {offset}))"
            commands.append(sbatch("", script, f"--array={ranges(chosen)}", f"--output={folder / 'log-%A-%a'}"))
    after = ["--dependency=afterok:$jobs", "--kill-on-invalid-dep=yes"] if commands else []
    merge = f"sh {join([folder / 'merge.sh'])}"
    return [*commands, sbatch("-merge", merge, *after, f"--output={folder / 'log-merge-%j'}")]


def as_script(commands):
    """The sbatch commands as lines for a shell."""
    *arrays, merge = [join(command) for command in commands]
    lines = [f"job{i}=$({array})" for i, array in enumerate(arrays)]
    jobs = ":".join(f"$job{i}" for i in range(len(arrays)))
    return "\n".join([*lines, merge.replace("'--dependency=afterok:$jobs'", f'"--dependency=afterok:{jobs}"')])


def submit(commands):
    """Runs the sbatch commands and returns the jobs' numbers."""
    jobs = []
    for command in commands:
        command = [word.replace("$jobs", ":".join(jobs)) for word in command]
        try:
            found = subprocess.run(command, capture_output=True, text=True)
        except FileNotFoundError:
            raise PlanError("sbatch is not installed; --print shows what it would be given") from None
        if found.returncode != 0:
            raise PlanError(f"sbatch: {found.stderr.strip()}")
        jobs.append(found.stdout.strip().split(";")[0])
    return jobs


def openjd_template(folder, numbers, name):
    """An Open Job Description, 2023-09, as JSON."""
    def script(file, *arguments):
        return {"actions": {"onRun": {"command": "sh", "args": [str(folder / file), *arguments]}}}

    merge = {"name": "Merge", "script": script("merge.sh")}
    steps = [merge]
    if numbers:
        part = {"name": "Part", "type": "INT", "range": ranges(numbers)}
        merge["dependencies"] = [{"dependsOn": "Render"}]
        steps.insert(0, {"name": "Render", "parameterSpace": {"taskParameterDefinitions": [part]},
                         "script": script("task.sh", "{{Task.Param.Part}}")})
    return json.dumps({"specificationVersion": "jobtemplate-2023-09", "name": name, "steps": steps}, indent=2)
