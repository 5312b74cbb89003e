#!/usr/bin/env python3
"""no_device_test.py PROGRAMS SCENES DRIVER NEEDY PART WORK [FOLDER]: what is said where no device can be used.

Every fault that a driver's manifest, its library or a variable can have, by every variable and folder that can name it,
alone and beside a driver that works, with the real Vulkan loader: this machine's, or the one in FOLDER, which
`tools/unpack-debian SUITE FOLDER libvulkan1` made. DRIVER is the tests' faulty driver, NEEDY a library that needs PART.
"""

import ctypes
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

MARK = b'\xef\xbb\xbf'
checks = 0
failures = 0


class Bench:
    """A folder of manifests and libraries, and a loader that reads them."""

    def __init__(self, programs, driver, needy, part, work, folder):
        self.program = programs / 'lavaray'
        self.work = work
        self.runner = [folder / 'run'] if folder else []
        if folder and (folder / 'usr/share/vulkan/icd.d').exists():
            sys.exit(f'FAILED: {folder} has a driver, whose variables would take the place of the tests\' own')
        self.version = self.loader_version(folder)
        for name in ('no-memory', 'no-start', 'no-terms', 'no-device', 'no-list', 'old', 'crash', 'libGLX_nvidia'):
            shutil.copy(driver, work / f'{name}.so')
        shutil.copy(needy, work / 'needy.so')
        shutil.copy(part, work / 'no-entry.so')
        self.part = part.name
        self.patched('bits.so', driver, 4, b'\x01')
        other = (b'\x3e\x00', b'\xb7\x00')  # x86-64, AArch64
        self.patched('machine.so', driver, 18, other[driver.read_bytes()[18:20] == other[0]])
        (work / 'text.so').write_text('This is no library.\n')

    @staticmethod
    def loader_version(folder):
        if folder:
            return tuple(map(int, re.search(r'^libvulkan1 ([\d.]+)', (folder / 'versions').read_text(),
                                            re.MULTILINE)[1].split('.')[:3]))
        version = ctypes.c_uint32()
        ctypes.CDLL('libvulkan.so.1').vkEnumerateInstanceVersion(ctypes.byref(version))
        return version.value >> 22, version.value >> 12 & 0x3ff, version.value & 0xfff

    def patched(self, name, driver, at, content):
        library = bytearray(driver.read_bytes())
        library[at:at + len(content)] = content
        (self.work / name).write_bytes(library)

    def run(self, arguments, variables):
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(('VK_', 'XDG_', 'LD_LIBRARY_PATH'))}
        nowhere = str(self.work / 'nowhere')
        environment.update(HOME=nowhere, XDG_DATA_DIRS=nowhere, XDG_CONFIG_DIRS=nowhere, LC_ALL='C')
        environment.update({name: str(value) for name, value in variables.items()})
        return subprocess.run([*self.runner, self.program, *arguments], env=environment, cwd=self.work,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120)


def check(condition, what, found):
    global checks, failures
    checks += 1
    if not condition:
        failures += 1
        print(f'FAILED: {what}: exit code {found.returncode}\n{found.stderr}')


def manifest(library, **more):
    return json.dumps({'file_format_version': '1.0.0',
                       'ICD': {'library_path': str(library), 'api_version': '1.0.0', **more}}).encode()


def lacking(key):
    content = json.loads(manifest('no-start.so'))
    del content['ICD'][key]
    return json.dumps(content).encode()


def faults(bench):
    """Of a manifest: its content, and what is said of it; and whether the old loader gives up over it."""
    def library(name):
        return f'"{bench.work}/{name}.so"'

    whole = manifest('./no-start.so')
    unparsable = {
        'nonsense': (b'This is no manifest.\n', 'is no manifest: line 1 is no JSON'),
        'cut': (whole[:-20], 'is no manifest: it is cut off in line 1'),
        'comma': (whole.replace(b'0"}}', b'0",\n}}'), 'is no manifest: a comma too many before the bracket in line 2'),
        'binary': (b'\x7fELF\0\0', 'is no manifest: line 1 is no JSON'),
    }
    if bench.version < (1, 4, 303):
        unparsable['mark'] = (MARK + whole, 'begins with a UTF-8 byte-order mark: this Vulkan loader cannot read it')
    no_such = bench.work / 'no-such.so'
    others = {
        'absent': (None, 'is not there'),
        'empty': (b'', 'is empty'),
        'list': (b'[]', 'is no manifest of a driver: it has no "ICD"'),
        'no-icd': (b'{"file_format_version": "1.0.0"}', 'is no manifest of a driver: it has no "ICD"'),
        'layer': (b'{"file_format_version": "1.0.0", "layer": {}}', 'is the manifest of a layer, not of a driver'),
        'no-version': (b'{"ICD": {"library_path": "./no-start.so", "api_version": "1.0.0"}}',
                       'whose "file_format_version" is missing'),
        'no-path': (lacking('library_path'), 'whose "library_path" is missing or empty, so that it names no driver'),
        'no-api': (lacking('api_version'), 'whose "api_version" is missing'),
        'portability': (manifest('./no-start.so', is_portability_driver=True), 'whose driver lacks parts of Vulkan'),
        'arch': (manifest('./no-start.so', library_arch='32'),
                 'whose driver is for programs of 32 bits, and this one has 64'),
        'no-library': (manifest(no_such), f'whose library "{no_such}" is not there'),
        'unknown': (manifest('libno-such-driver.so'), 'whose library "libno-such-driver.so" is in none of the folders '
                                                      'where this system looks for libraries'),
        'text': (manifest('./text.so'), f'whose library {library("text")} is no library'),
        'folder': (manifest(bench.work), f'whose library "{bench.work}" is no library'),
        'bits': (manifest('./bits.so'), f'whose library {library("bits")} is for programs of 32 bits'),
        'machine': (manifest('./machine.so'), f'whose library {library("machine")} is for another machine: '),
        'needy': (manifest('./needy.so'), f'whose library {library("needy")} needs "{bench.part}", '
                                          'which is not there; install it'),
        'no-entry': (manifest('./no-entry.so'), f'whose library {library("no-entry")} has no entry point for Vulkan'),
        'no-terms': (manifest('./no-terms.so'), f'whose driver {library("no-terms")} does not come to terms'),
        'no-start': (manifest('./no-start.so'), f'whose driver {library("no-start")} does not start: it says that'),
        'no-device': (manifest('./no-device.so'), f'whose driver {library("no-device")} has no device'),
    }
    memory = (manifest('./no-memory.so'), f'whose driver {library("no-memory")} does not start: it says that it gets '
                                          'no memory')
    no_list = (manifest('./no-list.so'), f'whose driver {library("no-list")} cannot list its devices')
    is_old = bench.version < (1, 4, 0)  # both are known: 1.3.239 gives up, 1.4.309 does not
    return {**{name: (*fault, is_old) for name, fault in unparsable.items()},
            **{name: (*fault, False) for name, fault in others.items()},
            'no-memory': (*memory, True), 'no-list': (*no_list, is_old)}


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
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
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
    print(f'loader {".".join(map(str, bench.version))}: {checks} checks, {failures} failed')
    sys.exit(1 if failures else 0)


main()
