"""What tests in Python check with, count and end with. They find it by

    sys.dont_write_bytecode = True  # leaves no __pycache__ in the checkout
    sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
"""
import shutil
import sys
import time

SKIPPED = 77

checks = 0
failures = 0


def check(holds, what, found=None):
    """Where it does not hold says so, with what `found`, a finished process, has printed; the test goes on."""
    global checks, failures
    checks += 1
    if not holds:
        failures += 1
        print(f'FAILED: {what}' + (described(found) if found else ''))


def demand(holds, what):
    """As check(), but the test ends: what follows makes no sense where this does not hold."""
    global checks
    checks += 1
    if not holds:
        fail(what)


def described(found):
    return f': {found.args} ended with {found.returncode}\n{found.stdout or ""}{found.stderr or ""}'


def fail(what):
    sys.exit(f'FAILED: {what}')


def skip(why):
    print(f'skipped: {why}')
    sys.exit(SKIPPED)


def finish():
    print(f'{checks} checks, {failures} failures')
    sys.exit(1 if failures else 0)


def until(condition, what, seconds):
    """What `condition` returns as soon as that is true."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        result = condition()
        if result:
            return result
        time.sleep(0.05)
    return fail(f'{what} did not happen within {seconds} s')


def make_anew(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
