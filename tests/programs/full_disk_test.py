#!/usr/bin/env python3
"""full_disk_test.py PROGRAMS SCENES WORK: outputs that cannot be written, and pictures that cannot be made.

Full disks (ext4 in a loop mount, tmpfs), a full standard output, read-only folders, limits on the size of files, names
that cannot be replaced: for each program and kind of output the exit code is 5, the old file stays, nothing is left
behind, and the message has the name and the system's reason. What can be known before a render is. What needs root is
skipped by name where this is not root.
"""

import contextlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from checks import demand, finish, make_anew

programs, scenes, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
lavaray, diff, merge = (str(programs / name) for name in ('lavaray', 'lavaray-diff', 'lavaray-merge'))
scene = str(scenes / 'extensions.txt')
NO_SPACE = 'No space left on device'
LONG = ['--spp', '100000', '--width', '1000']
skipped = []


def run(*command, **options):
    options = {'stdout': subprocess.PIPE, 'timeout': 120, **options}
    return subprocess.run([str(word) for word in command], cwd=work, stderr=subprocess.PIPE, text=True, **options)


def contents(folder):
    return {file.name: file.read_bytes() for file in folder.iterdir() if file.is_file()}


def outputs(folder):
    """What the programs write: a name, and the command that writes it."""
    # One sample: the scene has a spherical light, and its error is not what is tried.
    render = [lavaray, scene, '--width', '200', '--spp', '1']
    for ending in ('bmp', 'png', 'ppm', 'pfm', 'film'):
        yield f'picture.{ending}', [*render, '-o', folder / f'picture.{ending}']
    yield 'numbers.json', [*render, '-o', work / 'free.png', '--json', folder / 'numbers.json']
    yield 'check.json', [lavaray, scene, '--check', '--json', folder / 'check.json']
    yield 'kept.film', [*render, '-o', work / 'free.png', '--checkpoint', folder / 'kept.film']
    for ending in ('bmp', 'png', 'ppm', 'pfm'):
        yield f'diff.{ending}', [diff, work / 'a.png', work / 'b.png', '-o', folder / f'diff.{ending}']
        yield f'merge.{ending}', [merge, work / 'a.film', '-o', folder / f'merge.{ending}']


def try_all(what, folder, reason, codes=(5,), prefix=()):
    """Each output, where there is a file and where there is none."""
    for name, command in outputs(folder):
        before = contents(folder)
        found = run(*prefix, *command)
        demand(found.returncode in codes, f'{what}, {name}: exit code {found.returncode}, {found.stderr}')
        if found.returncode == 5:
            demand(re.search(rf'{re.escape(name)}.*: .*{reason}', found.stderr), f'{what}, {name}: {found.stderr}')
        demand(contents(folder) == before, f'{what}, {name}: the folder holds {sorted(contents(folder))}')


def make_old_files(folder):
    for name, _ in list(outputs(folder))[::2]:
        (folder / name).write_bytes(b'old')


def fill(folder):
    with contextlib.suppress(OSError), open(folder / 'filler', 'wb', buffering=0) as file:
        for size in (65536, 512):
            with contextlib.suppress(OSError):
                while True:
                    file.write(bytes(size))


@contextlib.contextmanager
def mounted(name, *arguments):
    folder = work / name
    folder.mkdir()
    subprocess.run(['mount', *arguments, folder], check=True, capture_output=True)
    try:
        yield folder
    finally:
        subprocess.run(['umount', folder], check=True)


def try_full_disks():
    with open(work / 'disk', 'wb') as file:
        file.truncate(4 << 20)
    disks = {'tmpfs': ['-t', 'tmpfs', '-o', 'size=256k', 'tmpfs'], 'ext4': ['-o', 'loop', work / 'disk']}
    for name, arguments in disks.items():
        try:
            if name == 'ext4':
                subprocess.run(['mkfs.ext4', '-q', work / 'disk'], check=True, capture_output=True)
            with mounted(name, *arguments) as folder:
                make_old_files(folder)
                fill(folder)
                try_all(f'a full {name}', folder, NO_SPACE)
                try_checkpoints(folder)
                subprocess.run(['mount', '-o', 'remount,ro', folder], check=True)
                try_all(f'a read-only {name}', folder, 'Read-only file system')
        except (OSError, subprocess.CalledProcessError) as error:
            skipped.append(f'a full {name} ({error})')


def try_checkpoints(full):
    """On a full disk, the picture on another: the picture is written."""
    whole = run(lavaray, scene, '--width', '100', '--spp', '64', '-o', work / 'whole.ppm')
    demand(whole.returncode == 0, whole.stderr)
    found = run(lavaray, scene, '--width', '100', '--spp', '64', '-o', work / 'half.ppm', '--checkpoint',
                full / 'other.film', '--checkpoint-every', '0')
    demand(found.returncode == 5 and found.stderr.count(NO_SPACE) == 1, f'one warning, and 5: {found}')
    demand((work / 'half.ppm').read_bytes() == (work / 'whole.ppm').read_bytes(), 'the picture is whole')


def try_stdout():
    with open('/dev/full', 'w') as full:
        for command in ([lavaray, '--version'], [lavaray, '--help'], [diff, '--help'], [merge, '--version'],
                        [diff, 'a.png', 'a.png'], [diff, 'a.png', 'b.png'], [diff, '--info', 'a.png'],
                        [merge, '--check', 'a.film'], [lavaray, scene, '--width', '200', '-o', '-']):
            found = run(*command, stdout=full)
            demand(found.returncode == 5 and NO_SPACE in found.stderr and 'stdout' in found.stderr, f'{command}: {found}')


def try_limit():
    folder = work / 'limited'
    folder.mkdir()
    make_old_files(folder)
    shell = ['bash', '-c', 'ulimit -c 0; ulimit -f 1; "$@"', 'bash']
    # What is too large may be the memory of a driver that keeps it in a file.
    for name, command in outputs(folder):
        if command[0] == lavaray or name.endswith('png'):
            continue
        before = contents(folder)
        found = run(*shell, *command)
        demand(found.returncode == 5 and 'File too large' in found.stderr and name in found.stderr, f'{name}: {found}')
        demand(contents(folder) == before, f'a limit, {name}: {sorted(contents(folder))}')


def refused_at_once(what, output, reason, *prefix):
    begin = time.monotonic()
    before = output.read_bytes()
    found = run(*prefix, lavaray, scene, *LONG, '-o', output)
    demand(found.returncode == 5 and re.search(reason, found.stderr) and output.name in found.stderr, f'{what}: {found}')
    demand(output.read_bytes() == before, f'{what}: it stays')
    demand([file.name for file in output.parent.iterdir()] == [output.name], f'{what}: nothing is left')
    print(f'figure: {what}: known after {time.monotonic() - begin:.1f} s')


def try_names():
    """Names that cannot be replaced."""
    for what, command, undo, reason in (
            ('an immutable file', ['chattr', '+i'], ['chattr', '-i'], 'Operation not permitted'),
            ('a mount point', ['mount', '--bind', work / 'a.png'], ['umount'], 'mounted')):
        output = work / what.replace(' ', '-') / 'picture.png'
        output.parent.mkdir()
        output.write_bytes(b'old')
        try:
            subprocess.run([*command, output], check=True, capture_output=True)
        except (OSError, subprocess.CalledProcessError) as error:
            skipped.append(f'{what} ({error})')
            continue
        try:
            refused_at_once(what, output, reason)
        finally:
            subprocess.run([*undo, output], check=True)
    nobody = ['setpriv', '--reuid', '65534', '--regid', '65534', '--clear-groups']
    try:
        subprocess.run([*nobody, 'test', '-x', lavaray, '-a', '-r', scene], check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError) as error:
        skipped.append(f"another user's file ({error})")
        return
    folder = work / 'sticky'
    folder.mkdir()
    (folder / 'picture.png').write_bytes(b'old')
    os.chmod(folder, 0o1777)
    refused_at_once("another user's file in a sticky folder", folder / 'picture.png', 'not permitted', *nobody)
    os.chmod(folder, 0o755)
    refused_at_once("another user's folder", folder / 'picture.png', 'Permission denied', *nobody)


def try_long_names():
    longest = 'x' * 251 + '.ppm'
    for name, code in ((longest, 0), ('x' + longest, 5)):
        found = run(lavaray, scene, '--width', '40', '-o', name)
        demand(found.returncode == code and (code == 0 or 'File name too long' in found.stderr), f'{len(name)}: {found}')
    output = work / 'last' / longest
    (work / 'last').mkdir()
    finish_at_folder(output)
    shutil.rmtree(work / 'last')


def try_last_step():
    """A folder that comes into being where the picture is to be."""
    output = work / 'last' / 'picture.ppm'
    output.parent.mkdir()
    finish_at_folder(output)


def finish_at_folder(output):
    render = subprocess.Popen([lavaray, scene, '--spp', '100000', '-q', '-o', output], stderr=subprocess.PIPE, text=True)
    time.sleep(2.0)
    output.mkdir()
    render.send_signal(signal.SIGTERM)
    said = render.communicate(timeout=60)[1]
    found = re.search(r'Is a directory; it is complete, and stays as (\S+)', said)
    if render.returncode == 143 and 'before anything' in said:
        skipped.append('the last step, on a machine that is too busy')
        return
    demand(render.returncode == 5 and found, f'the last step: {render.returncode}, {said}')
    demand(run(diff, '--info', found.group(1)).returncode == 0, 'what stays is a picture')
    demand(found.group(1).endswith('.ppm') and len(list(output.parent.iterdir())) == 2, 'and nothing else')


def try_sizes():
    found = run(lavaray, scene, '--width', '40000', '--height', '40000', '-o', 'huge.bmp')
    demand(found.returncode == 5 and '4294967295' in found.stderr, f"BMP's bound: {found}")
    limit = ['bash', '-c', 'ulimit -v 1500000; "$@"', 'bash']
    if run(*limit, lavaray, '--version').returncode != 0:
        skipped.append('too little memory (a sanitizer takes more than any limit leaves)')
        return
    for options, more in ((['--spp', '2'], 'one sample'), (['--target-error', '0.01'], 'one sample')):
        found = run(*limit, lavaray, scene, '--width', '20000', *options, '-o', 'huge.ppm')
        demand(found.returncode == 6 and re.search(r'needs \d+\.\d GB, and .*ulimit -v\) leaves', found.stderr) and
              more in found.stderr, f'{options}: {found}')
    group = pathlib.Path('/sys/fs/cgroup/memory/lavaray-test')
    try:
        group.mkdir()
        (group / 'memory.limit_in_bytes').write_text(str(600 << 20))
    except OSError as error:
        skipped.append(f'a control group ({error})')
        return
    try:
        found = run('sh', '-c', f'echo $$ >{group}/cgroup.procs; exec "$@"', 'sh', lavaray, scene, '--width', '20000',
                    '--spp', '2', '-o', 'huge.ppm')
        demand(found.returncode == 6 and 'control group' in found.stderr, f'a control group: {found}')
    finally:
        group.rmdir()
    demand(not (work / 'huge.ppm').exists(), 'nothing is written')


def main():
    make_anew(work)
    for name, options in (('a.png', []), ('b.png', ['--seed', '1', '--spp', '4']), ('a.film', [])):
        demand(run(lavaray, scene, '--width', '200', *options, '-o', name).returncode == 0, f'{name} is made')
    try_stdout()
    try_limit()
    try_names()
    try_long_names()
    try_last_step()
    try_sizes()
    try_full_disks()
    for what in skipped:
        print(f'skipped: {what}')
    finish()


main()
