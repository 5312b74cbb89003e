"""What no_device_test.py loads: a folder of manifests and libraries with every fault, and what is said of each."""
import ctypes
import json
import os
import re
import shutil
import subprocess
import sys

MARK = b'\xef\xbb\xbf'


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
