#!/usr/bin/env python3
"""no_device_test.py PROGRAMS SCENES DRIVER NEEDY PART WORK [FOLDER]: what is said where no device can be used.

Every fault that a driver's manifest, its library or a variable can have, by every variable and folder that can name it,
alone and beside a driver that works, with the real Vulkan loader: this machine's, or the one in FOLDER, which
`tools/unpack-debian SUITE FOLDER libvulkan1` made. DRIVER is the tests' faulty driver, NEEDY a library that needs PART.
"""

import os
import pathlib
import re
import shutil
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from checks import check, finish, make_anew
from no_device_bench import MARK, Bench, faults, manifest


def namings(file):
    """Every way in which the loader comes to read a manifest, with what is said of that."""
    folder = file.parent
    base = folder.parent.parent
    for variable in ('VK_DRIVER_FILES', 'VK_ICD_FILENAMES', 'VK_ADD_DRIVER_FILES'):
        yield {variable: file}, f'"{variable}" names "{file}", '
        if file.exists():
            yield {variable: folder}, f'"{variable}" names the folder "{folder}", which holds "{file.name}", '
    if file.exists():
        for variable in ('XDG_CONFIG_HOME', 'XDG_CONFIG_DIRS', 'XDG_DATA_HOME', 'XDG_DATA_DIRS'):
            yield {variable: base}, f'the folder "{folder}" holds "{file.name}", '
        yield {'HOME': base.parent.parent}, f'the folder "{folder}" holds "{file.name}", '


def test_manifests(bench, good):
    for name, (content, text, gives_up) in faults(bench).items():
        folder = bench.work / name / '.local/share/vulkan/icd.d'
        folder.mkdir(parents=True)
        file = folder / f'{name}.json'
        if content is not None:
            # A path of a library is relative to the manifest.
            file.write_bytes(content.replace(b'"./', f'"{os.path.relpath(bench.work, folder)}/'.encode()))
        for variables, naming in namings(file):
            found = bench.run(['--list-devices'], variables)
            what = f'{name} by {variables}'
            check(found.returncode == 4, what, found)
            check(found.stderr.startswith(f'lavaray: no device can be used: {naming}'), what, found)
            check(text in found.stderr and found.stderr.count('\n') == 1, f'{what}: {text}', found)
            check('mesa-vulkan-drivers' not in found.stderr, f'{what}: no advice', found)
        if good is None:
            continue
        for variables, naming in ((({'VK_DRIVER_FILES': f'{file}:{good}'}), f'"VK_DRIVER_FILES" names "{file}", '),
                                  (({'VK_ICD_FILENAMES': f'{good}:{file}'}), f'"VK_ICD_FILENAMES" names "{file}", ')):
            found = bench.run(['--list-devices', '-q'], variables)
            what = f'{name} beside a good driver by {variables}'
            check(found.returncode == 0 and '\n0: ' in '\n' + found.stderr, what, found)
            warning = f'warning: {naming}' in found.stderr and text in found.stderr
            check(warning == gives_up and found.stderr.count('\n') == 1 + gives_up, f'{what}: a warning', found)
            found = bench.run(['--list-devices', '-v'], variables)
            check(found.returncode == 0 and naming in found.stderr and text in found.stderr, f'{what}: -v', found)
            check(f'names "{good}", whose driver "' in found.stderr and '" has a device\n' in found.stderr,
                  f'{what}: -v, the good one', found)


def test_variables(bench):
    start = bench.work / 'start.json'
    start.write_bytes(manifest('./no-start.so'))
    other = bench.work / 'start.manifest'
    shutil.copy(start, other)
    empty = bench.work / 'empty-folder'
    empty.mkdir()
    for name in ('VK_DRIVER_FILES', 'VK_ICD_FILENAMES'):
        for value in ('', ':'):
            expect(bench, {name: value}, f'"{name}" is set, but empty, so that no manifest is looked for; unset it')
    for name in ('VK_DRIVER_FILES', 'VK_ICD_FILENAMES', 'VK_ADD_DRIVER_FILES'):
        expect(bench, {name: other}, f'"{name}" names "{other}", which does not end in .json, so that it is not read')
        expect(bench, {name: '/dev/null'}, f'"{name}" names "/dev/null", which does not end in .json')
        expect(bench, {name: '/no/such'}, f'"{name}" names "/no/such", which is not there')
        expect(bench, {name: empty}, f'"{name}" names the folder "{empty}", which holds no manifest to be read')
        for separator in ',;':
            expect(bench, {name: f'{start}{separator}{start}'},
                   f'"{name}" names "{start}{separator}{start}", which is not there; colons separate the files of a '
                   'list, not commas or semicolons')
        for file in ('~/driver.json', '~'):
            expect(bench, {name: file},
                   f'"{name}" names "{file}", which is not there; nobody has replaced the ~ by a home folder')
    # The first wins, even empty; what it replaces is not spoken of.
    found = expect(bench, {'VK_DRIVER_FILES': '', 'VK_ICD_FILENAMES': start, 'VK_ADD_DRIVER_FILES': start},
                   '"VK_DRIVER_FILES" is set, but empty')
    check('start.json' not in found.stderr, 'VK_DRIVER_FILES wins', found)
    found = expect(bench, {'VK_ICD_FILENAMES': start, 'VK_ADD_DRIVER_FILES': '/no/such.json'}, f'names "{start}"')
    check('such.json' not in found.stderr, 'VK_ICD_FILENAMES wins', found)
    for name, value in (('SELECT', 'other*'), ('SELECT', 'start'), ('DISABLE', '*'), ('DISABLE', 'x.json,START*'),
                        ('DISABLE', '~all~')):
        name = f'VK_LOADER_DRIVERS_{name}'
        expect(bench, {'VK_DRIVER_FILES': start, name: value},
               f'"VK_DRIVER_FILES" names "{start}", which "{name}" leaves out: it is "{value}"')
    for name, value in (('SELECT', '*ART.json'), ('SELECT', 'x,*tar*'), ('DISABLE', 'tart*')):
        expect(bench, {'VK_DRIVER_FILES': start, f'VK_LOADER_DRIVERS_{name}': value}, 'does not start')
    # Several: a line for each.
    found = expect(bench, {'VK_DRIVER_FILES': f'{start}:/no/such.json'},
                   f'\n  "VK_DRIVER_FILES" names "{start}", whose')
    check('\n  "VK_DRIVER_FILES" names "/no/such.json", which is not there\n' in found.stderr, 'several', found)
    found = bench.run(['--list-devices'], {})
    if not list(pathlib.Path('/etc/vulkan/icd.d').glob('*.json')):
        check(found.returncode == 4 and 'there is no Vulkan driver: none of the folders ' in found.stderr and
              f'"{bench.work}/nowhere/vulkan/icd.d"' in found.stderr and
              found.stderr.endswith('install mesa-vulkan-drivers\n'), 'no manifest anywhere', found)


def expect(bench, variables, text):
    found = bench.run(['--list-devices'], variables)
    check(found.returncode == 4 and text in found.stderr, f'{variables}: {text}', found)
    return found


def test_drivers(bench):
    """What only some drivers do."""
    for name in ('old', 'crash', 'libGLX_nvidia'):
        (bench.work / f'{name}.json').write_bytes(manifest(f'./{name}.so'))
    old = {'VK_DRIVER_FILES': f'{bench.work}/old.json:/no/such.json'}
    scene = bench.work / 'scene.txt'
    scene.write_text('1\ncamera\npos: 0 0 0\nfov: 60\nf: 10\na: 1\n')
    found = bench.run([scene], old)
    check(found.returncode == 4 and 'no device has what is needed, Vulkan 1.2 and a compute queue; there are:\n  0: '
          'Old Device (not usable)\n' in found.stderr, 'an old device', found)
    check('"VK_DRIVER_FILES" names "/no/such.json", which is not there\n' in found.stderr, 'beside an old device',
          found)
    found = bench.run(['--list-devices', '-v'], {'VK_DRIVER_FILES': bench.work / 'crash.json'})
    check(f'whose driver "{bench.work}/crash.so" ends the program that loads it: Aborted\n' in found.stderr,
          'a driver that ends the program', found)
    if bench.runner:
        return  # which has library folders of its own
    broken = bench.work / 'libraries'
    broken.mkdir()
    (broken / 'libEGL.so.1').write_text('This is no library.\n')
    found = bench.run(['--list-devices'], {'VK_DRIVER_FILES': bench.work / 'libGLX_nvidia.json',
                                           'LD_LIBRARY_PATH': broken})
    check(found.returncode == 4 and re.search(r"; NVIDIA's driver needs .*\"libEGL\.so\.1\".* of this system, which "
                                              r'cannot be loaded: install .*libegl1', found.stderr), 'NVIDIA', found)


def test_layers(bench, good):
    """Manifests of layers, which the old loader gives up over, too."""
    is_old = bench.version < (1, 4, 0)
    for kind in ('implicit', 'explicit'):
        base = bench.work / f'{kind}-layers'
        folder = base / 'vulkan' / f'{kind}_layer.d'
        folder.mkdir(parents=True)
        (folder / 'layer.json').write_text('{')
        naming = f'the folder "{folder}" holds "layer.json", which is no manifest: it is cut off in line 1'
        for variable in ('XDG_CONFIG_HOME', 'XDG_CONFIG_DIRS', 'XDG_DATA_HOME', 'XDG_DATA_DIRS'):
            found = bench.run(['--list-devices'], {variable: base, 'VK_DRIVER_FILES': good})
            what = f'a broken {kind} layer by {variable}'
            check(found.returncode == 0 and (f'warning: {naming}; it is left out\n' in found.stderr) == is_old,
                  what, found)
        if kind == 'implicit':
            continue
        for variable in ('VK_LAYER_PATH', 'VK_ADD_LAYER_PATH'):
            found = bench.run(['--list-devices'], {variable: folder, 'VK_DRIVER_FILES': good})
            check(found.returncode == 0 and (f'warning: "{variable}" names the folder "{folder}", which holds '
                                             '"layer.json", which is no manifest' in found.stderr) == is_old,
                  f'a broken layer by {variable}', found)


    # A layer that is asked for is found beside a broken one; that another is missing changes nothing.
    folders = f'/usr/share/vulkan/explicit_layer.d:{folder}'
    if pathlib.Path('/usr/share/vulkan/explicit_layer.d/VkLayer_khronos_validation.json').exists():
        found = bench.run(['--list-devices', '--validate'], {'VK_LAYER_PATH': folders, 'VK_DRIVER_FILES': good})
        check(found.returncode == 0 and ('warning: ' in found.stderr) == is_old,
              '--validate beside a broken layer', found)
    found = bench.run(['--list-devices'], {'VK_INSTANCE_LAYERS': 'VK_LAYER_no_such', 'VK_DRIVER_FILES': good})
    check(found.returncode == 0 and 'warning: ' not in found.stderr, 'a missing layer', found)


def test_mark(bench, good):
    """A byte-order mark is a fault to some loaders only."""
    marked = bench.work / 'marked.json'
    marked.write_bytes(MARK + good.read_bytes())
    found = bench.run(['--list-devices', '-v'], {'VK_DRIVER_FILES': marked})
    works = bench.version >= (1, 4, 303)
    check(found.returncode == (0 if works else 4), 'a mark', found)
    check(('" has a device\n' if works else 'byte-order mark') in found.stderr, 'a mark, -v', found)


def test_picture(bench, scenes, good):
    """A picture is the same whatever stands beside the driver."""
    broken = bench.work / 'broken.json'
    broken.write_text('nonsense')
    pictures = set()
    for files in (f'{good}', f'{good}:{broken}', f'{broken}:{good}'):
        found = bench.run([scenes / 'spheres.txt', '--width', '100', '-o', 'picture.ppm'], {'VK_DRIVER_FILES': files})
        check(found.returncode == 0, files, found)
        check(('is no manifest' in found.stderr) == (bench.version < (1, 4, 0) and files != str(good)), files, found)
        pictures.add((bench.work / 'picture.ppm').read_bytes())
    check(len(pictures) == 1, 'one picture', found)


def main():
    programs, scenes, driver, needy, part, work, *folder = (pathlib.Path(name).resolve() for name in sys.argv[1:])
    make_anew(work)
    bench = Bench(programs, driver, needy, part, work, folder[0] if folder else None)
    good = next(iter(sorted(pathlib.Path('/usr/share/vulkan/icd.d').glob('lvp_icd*.json'))), None)
    test_manifests(bench, good)
    test_variables(bench)
    test_drivers(bench)
    if good is None:
        print('there is no software driver of Mesa: nothing is tested beside a driver that works')
    else:
        test_layers(bench, good)
        test_mark(bench, good)
        test_picture(bench, scenes, good)
    print(f'loader {".".join(map(str, bench.version))}')
    finish()


main()
