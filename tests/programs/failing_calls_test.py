#!/usr/bin/env python3
"""failing_calls_test.py PROGRAMS SCENES DRIVER WORK: what is said where a call of Vulkan fails.

Each function that the program calls and that can fail does so once, in a driver that is Mesa's software driver otherwise.
The message names what the call was for, with its size, and the result. DRIVER is the tests' failing driver.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

NO_HOST_MEMORY, NO_DEVICE_MEMORY, LOST, NO_MAP, NO_SHADER = -1, -2, -4, -5, -1000012000
NAMES = {NO_HOST_MEMORY: 'VK_ERROR_OUT_OF_HOST_MEMORY', NO_DEVICE_MEMORY: 'VK_ERROR_OUT_OF_DEVICE_MEMORY',
         LOST: 'VK_ERROR_DEVICE_LOST', NO_MAP: 'VK_ERROR_MEMORY_MAP_FAILED',
         NO_SHADER: 'VK_ERROR_INVALID_SHADER_NV'}
DATA = r'the [a-zA-Z -]+ \(\d+ MiB\)'
SHADER = r'the shader \(\d+ KiB of SPIR-V\)'
DEVICE = 'llvmpipe .*'

CALLS = [
    ('vkCreateDevice', NO_HOST_MEMORY, f'open the device {DEVICE}'),
    ('vkCreateCommandPool', NO_DEVICE_MEMORY, f'make a command pool for {DEVICE}'),
    ('vkAllocateCommandBuffers', NO_DEVICE_MEMORY, f'make a command buffer for {DEVICE}'),
    ('vkCreateFence', NO_HOST_MEMORY, f'make a fence for {DEVICE}'),
    ('vkCreateBuffer', NO_DEVICE_MEMORY, f'make a buffer for {DATA}'),
    ('vkAllocateMemory', NO_DEVICE_MEMORY, f'get memory for {DATA}'),
    ('vkBindBufferMemory', NO_DEVICE_MEMORY, f'give memory to {DATA}'),
    ('vkMapMemory', NO_MAP, f'reach the memory of {DATA}'),
    ('vkCreateBufferView', NO_HOST_MEMORY, f'make a view of {DATA} for the shader'),
    ('vkCreateDescriptorSetLayout', NO_HOST_MEMORY, r"lay out the shader's \d+ buffers"),
    ('vkCreatePipelineLayout', NO_HOST_MEMORY, r"make the layout of the shader's pipeline \(\d+ bytes of constants\)"),
    ('vkCreateShaderModule', NO_SHADER, f'load {SHADER}'),
    ('vkCreateComputePipelines', NO_DEVICE_MEMORY, f'make a pipeline of {SHADER}'),
    ('vkCreateDescriptorPool', NO_DEVICE_MEMORY, r"make a descriptor pool for the shader's \d+ buffers"),
    ('vkAllocateDescriptorSets', NO_DEVICE_MEMORY, r"make a descriptor set for the shader's \d+ buffers"),
    ('vkBeginCommandBuffer', NO_HOST_MEMORY, f'begin the command buffer of {DEVICE}'),
    ('vkEndCommandBuffer', NO_DEVICE_MEMORY, f'end the command buffer of {DEVICE}'),
    ('vkQueueSubmit', LOST, f'submit work to {DEVICE}'),
    ('vkWaitForFences', LOST, f'wait for {DEVICE}'),
    ('vkResetFences', NO_DEVICE_MEMORY, f'reset the fence of {DEVICE}'),
]


def main():
    programs, scenes, driver, work = (pathlib.Path(name).resolve() for name in sys.argv[1:])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    mesa = next(iter(sorted(pathlib.Path('/usr/share/vulkan/icd.d').glob('lvp_icd*.json'))), None)
    if mesa is None:
        print('skipped: there is no software driver of Mesa')
        sys.exit(77)
    manifest = work / 'failing.json'
    icd = json.loads(mesa.read_text())
    variables = dict(os.environ, LC_ALL='C', LAVARAY_DRIVER=icd['ICD']['library_path'])
    icd['ICD']['library_path'] = str(driver)
    manifest.write_text(json.dumps(icd))
    variables.update(VK_DRIVER_FILES=str(manifest), VK_ICD_FILENAMES=str(manifest))
    picture = work / 'picture.png'

    def render(function, result):
        return subprocess.run([programs / 'lavaray', '-q', scenes / 'torus.txt', '--width', '16', '-o', picture],
                              env=dict(variables, LAVARAY_FAILING_FUNCTION=function, LAVARAY_RESULT=str(result)),
                              capture_output=True, text=True, timeout=120)

    failures = 0
    for function, result, action in CALLS:
        found = render(function, result)
        message = f'lavaray: cannot {action}: [^:]+[;?][^:]* \\({NAMES[result]}\\)\n'
        if found.returncode != 4 or not re.fullmatch(message, found.stderr) or picture.exists():
            failures += 1
            print(f'FAILED: {function}: exit code {found.returncode}\n{found.stderr}')
    found = render('none', 0)
    if found.returncode != 0 or not picture.exists():
        failures += 1
        print(f'FAILED: without a fault: exit code {found.returncode}\n{found.stderr}')
    print(f'{len(CALLS)} functions fail, {failures} failures')
    sys.exit(1 if failures else 0)


main()
