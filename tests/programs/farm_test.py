#!/usr/bin/env python3
"""farm_test.py PROGRAMS SCENES TOOLS WORK: tools/farm without a scheduler.

Its tasks are run by a shell, in any order, are ended and run again, damaged and made anew; the merged picture has the
bits of one render. The same by OpenJD, where openjd-cli is installed.
"""

import pathlib
import random
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from checks import demand, finish, make_anew


def main():
    programs, scenes, tools, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    sys.path.insert(0, str(tools))
    sys.dont_write_bytecode = True
    from farm_jobs import cuts, jobs, plan
    make_anew(work)

    # Cuts by cost: equal where they can be, every strip a row at least, all rows once.
    chance = random.Random(1)
    for _ in range(1000):
        height = chance.randrange(1, 400)
        parts = chance.randrange(1, height + 1)
        costs = [chance.choice([0.0, 1.0, chance.random() * 50]) for _ in range(chance.randrange(1, 100))]
        rows = cuts.equal_cuts(costs, height, parts)
        demand(rows[0] == 0 and rows[-1] == height and len(rows) == parts + 1, 'cuts have all rows')
        demand(all(a < b for a, b in zip(rows, rows[1:])), f'strips have rows: {rows}')
        demand(sorted(cuts.interleaved(parts)) == list(range(parts)), 'an order of all parts')
    demand(cuts.equal_cuts([1, 1, 3, 3], 400, 4) == [0, 200, 267, 333, 400], 'strips of equal cost')
    demand(jobs.ranges([0, 1, 2, 5, 7, 8]) == '0-2,5,7-8', 'ranges')

    scene = scenes / 'extensions.txt'
    options = ['--width', '150', '--spp', '16', '--seed', '7']

    def run(*command, code=0, cwd=work):
        found = subprocess.run([*map(str, command)], capture_output=True, text=True, cwd=cwd)
        demand(found.returncode == code, f'{command} ended with {found.returncode}: {found.stderr}')
        return found

    def farm(*arguments, code=0):
        return run(tools / 'farm', '--programs', programs, *arguments, code=code)

    whole = work / 'whole.png'
    run(programs / 'lavaray', scene, *options, '-o', whole, '-q')

    def same(picture):
        return run(programs / 'lavaray-diff', picture, whole)

    for by in ('rows', 'samples'):
        for parts in (1, 2, 4):
            arguments = [scene, *options, '--parts', parts, '--by', by, '-o', f'{by}{parts}.png']
            tasks = farm(*arguments, '--print=tasks').stdout.splitlines()
            demand(len(tasks) == parts, f'{parts} tasks: {tasks}')
            chance.shuffle(tasks)
            for task in tasks:
                run('sh', '-c', task)
            run('sh', '-c', farm(*arguments, '--print=merge').stdout)
            same(f'{by}{parts}.png')

    # Sizes that end in a half, which is rounded up, and what the parts' rows are cut from: the program's size.
    for width, height, options_, size in ((1000, 500, ['--width', '1001'], (1001, 501)),
                                          (1000, 500, ['--width', '1003'], (1003, 502)),
                                          (500, 1000, ['--height', '1001'], (501, 1001)),
                                          (500, 1000, ['--height', '1003'], (502, 1003)),
                                          (1000, 500, ['--width', '7'], (7, 4)), (1000, 500, ['--width', '1'], (1, 1)),
                                          (1000, 500, ['--width', '31', '--height', '12'], (31, 12)),
                                          (1000, 500, [], (1000, 500))):
        half = work / 'half.txt'
        half.write_text(f'1\ncamera\npos: 0 0 0\nfov: 90\nf: {height / 2}\na: {width / height}\n')
        demand(plan.scene_facts(programs / 'lavaray', half, options_)[:2] == size, f'{options_} of {width} x {height}')
        run(programs / 'lavaray', half, *options_, '-o', 'half.ppm', '-q')
        header = (work / 'half.ppm').read_bytes().split(b'\n')[1].decode()
        demand(header == '%d %d' % size, f'{options_} of {width} x {height} is a picture of {header}')
    half.write_text('1\ncamera\npos: 0 0 0\nfov: 90\nf: 250\na: 2\n')
    arguments = [half, '--width', '1001', '--parts', 2, '-o', 'half.png']
    for task in farm(*arguments, '--print=tasks').stdout.splitlines():
        run('sh', '-c', task)
    run('sh', '-c', farm(*arguments, '--print=merge').stdout)
    run(programs / 'lavaray', half, '--width', '1001', '-o', 'half-whole.png', '-q')
    run(programs / 'lavaray-diff', 'half.png', 'half-whole.png')

    # What is damaged or missing is named, and only that is rendered again.
    folder = work / 'rows4.png.farm'
    arguments = [scene, *options, '--parts', 4, '-o', 'rows4.png']
    (work / 'rows4.png').unlink()
    damaged, cut, missing = folder / 'rows4-0000.film', folder / 'rows4-0002.film', folder / 'rows4-0003.film'
    data = bytearray(damaged.read_bytes())
    data[len(data) // 2] ^= 4
    damaged.write_bytes(data)
    cut.write_bytes(cut.read_bytes()[:1000])
    missing.unlink()
    found = run('sh', folder / 'merge.sh', code=3)
    for part in (damaged, cut, missing):
        demand(part.name in found.stderr, f'{part.name} is named: {found.stderr}')
    demand('rows4-0001' not in found.stderr, f'a good part is not named: {found.stderr}')
    found = farm(*arguments, '--print=tasks')
    demand([line[-1] for line in found.stdout.splitlines()] == ['0', '2', '3'], f'what is left: {found.stdout}')
    demand('1 of 4 tasks are done already' in found.stderr, found.stderr)
    demand('--array=0,2-3' in farm(*arguments, '--print').stdout, 'only what is left is submitted')

    # A task that is ended goes on from its checkpoint; a checkpoint of no use is thrown away.
    (folder / '0.checkpoint').write_bytes(b'rubbish')
    for task in found.stdout.splitlines():
        run('sh', '-c', task)
    run('sh', folder / 'merge.sh')
    same('rows4.png')
    demand(not list(folder.glob('*.checkpoint')), 'no checkpoint is left')

    # Other options: the parts are of no use.
    other = [word if word != '7' else '8' for word in arguments]
    found = farm(*map(str, other), '--print=tasks')
    demand('4 parts were of other scenes or options' in found.stderr and len(found.stdout.splitlines()) == 4, found.stderr)

    # Several scenes. One has a spherical light: without --spp its parts would be pictures of their own.
    one = ['--width', '60', '--spp', '1']
    found = farm(scene, scenes / 'facets.txt', *one, '-o', '{}.ppm', '--print=tasks')
    for task in found.stdout.splitlines():
        run('sh', '-c', task)
    run('sh', 'all.ppm.farm/merge.sh')
    for name in ('extensions', 'facets'):
        run(programs / 'lavaray', scenes / f'{name}.txt', *one, '-o', 'one.ppm', '-q')
        run(programs / 'lavaray-diff', f'{name}.ppm', 'one.ppm')

    demand('must have {}' in farm(scene, scene, '-o', 'x.png', code=2).stderr, 'several scenes, one picture')
    demand('at most' in farm(scene, '--height', '5', '--parts', '9', '-o', 'x.png', code=2).stderr, 'too many parts')
    demand('--crop' in farm(scene, '--crop', '0,0,9,9', '-o', 'x.png', code=2).stderr, 'an option of the farm')

    if shutil.which('openjd') and subprocess.run(['openjd', '--version'], capture_output=True).returncode == 0:
        arguments = [scene, *options, '--parts', 3, '-o', 'openjd.png']
        (work / 'template.json').write_text(farm(*arguments, '--print=openjd').stdout)
        run('openjd', 'run', 'template.json')
        same('openjd.png')
        print('with openjd-cli')
    else:
        print('without openjd-cli, which is not installed')
    finish()


main()
