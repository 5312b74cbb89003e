#!/usr/bin/env python3
"""slurm_test.py PROGRAMS SCENES TOOLS WORK: tools/farm with a real Slurm of two nodes on this machine.

A picture is rendered in 16 parts; in the middle one node dies, with all that runs on it. Slurm runs its tasks again on
the other one, and the picture has the bits of one render. Takes a minute or two, so it runs only with
LAVARAY_STRESS=full. Needs root, slurmctld, slurmd and munge (Debian: slurmctld, slurmd, slurm-client, munge); skips
itself by name where one is missing.
"""

import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from checks import fail, make_anew, skip, until

PARTS = 16
SECONDS = 300

CONFIGURATION = """\
ClusterName=farm
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port0}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={work}/munge.socket
StateSaveLocation={work}/state
SlurmdSpoolDir={work}/%n
SlurmctldPidFile={work}/slurmctld.pid
SlurmdPidFile={work}/%n.pid
SlurmctldLogFile={work}/slurmctld.log
SlurmdLogFile={work}/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdTimeout=5
SlurmctldTimeout=10
SchedulerParameters=sched_interval=5
NodeName=node1 NodeHostname={host} NodeAddr=127.0.0.1 Port={port1} CPUs=1
NodeName=node2 NodeHostname={host} NodeAddr=127.0.0.1 Port={port2} CPUs=1
PartitionName=all Nodes=node1,node2 Default=YES State=UP
"""


def run(*command, code=0, **options):
    found = subprocess.run([*map(str, command)], capture_output=True, text=True, **options)
    if found.returncode != code:
        fail(f'{command} ended with {found.returncode}: {found.stdout}{found.stderr}')
    return found.stdout + found.stderr


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(('127.0.0.1', 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def processes_with(text):
    """Numbers of the processes whose command line or environment has this text."""
    found = []
    for folder in pathlib.Path('/proc').glob('[0-9]*'):
        try:
            if any(text in (folder / name).read_bytes() for name in ('cmdline', 'environ')):
                found.append(int(folder.name))
        except OSError:
            pass
    return found


class Cluster:
    """Two nodes on the loopback address, with a key, a socket and ports of their own."""

    def __init__(self, work):
        self.work = work
        port0, port1, port2 = free_ports(3)
        (work / 'state').mkdir()
        (work / 'slurm.conf').write_text(CONFIGURATION.format(
            host=socket.gethostname().split('.')[0], work=work, port0=port0, port1=port1, port2=port2))
        os.environ['SLURM_CONF'] = str(work / 'slurm.conf')

    def __enter__(self):
        work = self.work
        run('mungekey', '--create', '--keyfile', work / 'munge.key')
        run('munged', '--force', '--key-file', work / 'munge.key', '--socket', work / 'munge.socket', '--pid-file',
            work / 'munge.pid', '--log-file', work / 'munge.log', '--seed-file', work / 'munge.seed')
        run('slurmctld')
        for node in ('node1', 'node2'):
            run('slurmd', '-N', node)
        until(lambda: run('sinfo', '-h', '-t', 'idle', '-o', '%D').startswith('2'), 'two idle nodes', SECONDS)
        return self

    def __exit__(self, *_):
        subprocess.run(['scancel', '-u', 'root'], capture_output=True)
        for name in ('node1', 'node2', 'slurmctld', 'munge'):
            file = self.work / f'{name}.pid'
            if file.exists():
                try:
                    os.kill(int(file.read_text()), signal.SIGTERM)
                except (OSError, ValueError):
                    pass

    def kill(self, node):
        """As a machine dies: the daemon and all that it runs at once."""
        daemon = int((self.work / f'{node}.pid').read_text())
        for number in [daemon, *processes_with(f'SLURMD_NODENAME={node}'.encode())]:
            try:
                os.kill(number, signal.SIGKILL)
            except OSError:
                pass


def main():
    programs, scenes, tools, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    if os.environ.get('LAVARAY_STRESS') != 'full':
        skip('it takes minutes; LAVARAY_STRESS=full runs it')
    if os.geteuid() != 0:
        skip('slurmd needs root')
    for program in ('munged', 'mungekey', 'slurmctld', 'slurmd', 'sbatch'):
        if not shutil.which(program):
            skip(f'{program} is not installed')
    make_anew(work)
    scene = scenes / 'extensions.txt'
    options = ['--width', '500', '--spp', '256']
    farm = [tools / 'farm', '--programs', programs, scene, *options, '--parts', PARTS, '-o', 'picture.png']
    start = time.monotonic()
    run(programs / 'lavaray', scene, *options, '-o', 'whole.png', '-q', cwd=work)
    print(f'one render of the whole: {time.monotonic() - start:.1f} s')
    films = work / 'picture.png.farm'

    with Cluster(work) as cluster:
        start = time.monotonic()
        print(run(*farm, cwd=work).strip())
        until(lambda: len(list(films.glob('*.film'))) >= PARTS // 3, 'a third of the parts', SECONDS)
        cluster.kill('node1')
        print(f'{time.monotonic() - start:.1f} s: killed node1 and all on it')
        until(lambda: 'down' in run('sinfo', '-h', '-n', 'node1', '-o', '%T'), 'the loss of node1', SECONDS)
        print(f'{time.monotonic() - start:.1f} s: Slurm has noticed: {run("sinfo", "-h", "-N", "-o", "%N %T").split()}')
        until(lambda: (work / 'picture.png').exists() and not run('squeue', '-h'), 'the picture', SECONDS)
        print(f'{time.monotonic() - start:.1f} s: the picture is there')
        log = (work / 'slurmctld.log').read_text()
        requeued = [line for line in log.splitlines() if 'requeue' in line.lower()]
        print('\n'.join(requeued))
        if not requeued:
            fail('no task was run again: the node died too late')
        print(run(programs / 'lavaray-diff', 'picture.png', 'whole.png', cwd=work).strip())

        # Damaged parts are refused by name, and a second submission renders these only.
        (work / 'picture.png').unlink()
        damaged, cut = films / 'picture-0003.film', films / 'picture-0009.film'
        data = bytearray(damaged.read_bytes())
        data[-1000] ^= 1
        damaged.write_bytes(data)
        cut.write_bytes(cut.read_bytes()[:-1])
        refused = run('sh', films / 'merge.sh', code=3)
        print(refused.strip())
        if damaged.name not in refused or cut.name not in refused:
            fail('the damaged parts are not named')
        again = run(*farm, cwd=work)
        print(again.strip())
        if f'{PARTS - 2} of {PARTS} tasks are done already' not in again:
            fail('more than the damaged parts are rendered again')
        until(lambda: (work / 'picture.png').exists() and not run('squeue', '-h'), 'the picture again', SECONDS)
        run(programs / 'lavaray-diff', 'picture.png', 'whole.png', cwd=work)
    print(f'figure: {PARTS} parts on two nodes, one of them killed: the same bits; 2 damaged parts refused and '
          'rendered again: the same bits')


main()
