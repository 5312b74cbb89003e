#!/usr/bin/env python3
"""failing_calls_test.py PROGRAMS SCENES DRIVER WORK: what is said where a call of Vulkan fails.

Each function that the program calls and that can fail does so once, in a driver that is Mesa's software driver otherwise.
The message names what the call was for, with its size, and the result. DRIVER is the tests' failing driver.
"""

import json
import os
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from checks import check, finish, make_anew, skip

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
    ('vkCreateQueryPool', NO_DEVICE_MEMORY, f'make a query pool for {DEVICE}'),
]


def main():
    programs, scenes, driver, work = (pathlib.Path(name).resolve() for name in sys.argv[1:])
    make_anew(work)
    mesa = next(iter(sorted(pathlib.Path('/usr/share/vulkan/icd.d').glob('lvp_icd*.json'))), None)
    if mesa is None:
        skip('there is no software driver of Mesa')
    manifest = work / 'failing.json'
    icd = json.loads(mesa.read_text())
    variables = dict(os.environ, LC_ALL='C', LAVARAY_DRIVER=icd['ICD']['library_path'])
    icd['ICD']['library_path'] = str(driver)
    manifest.write_text(json.dumps(icd))
    variables.update(VK_DRIVER_FILES=str(manifest), VK_ICD_FILENAMES=str(manifest))
    picture = work / 'picture.png'

    def render(function, result):
        return subprocess.run([programs / 'lavaray', '-q', '--json', work / 'stats.json', scenes / 'torus.txt', '--width', '16',
                               '-o', picture],
                              env=dict(variables, LAVARAY_FAILING_FUNCTION=function, LAVARAY_RESULT=str(result)),
                              capture_output=True, text=True, timeout=120)

    for function, result, action in CALLS:
        found = render(function, result)
        message = f'lavaray: cannot {action}: [^:]+[;?][^:]* \\({NAMES[result]}\\)\n'
        check(found.returncode == 4 and re.fullmatch(message, found.stderr) and not picture.exists(), function, found)
    found = render('none', 0)
    check(found.returncode == 0 and picture.exists(), 'without a fault', found)
    finish()


main()
