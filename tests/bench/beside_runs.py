"""Runs commands in turns, and measures each run: wall time, processor time, and the most memory.

A child that starts inherits the peak of this process as its own. So this process stays small: it imports little, and
makes no scene.
"""
import os
import resource
import select
import signal
import subprocess
import sys
import time
from pathlib import Path

LIMIT = 120 # seconds for a run
MOST_RUNS, LEAST_RUNS = 21, 3 # of a command
BUDGET = 4 # seconds for the runs of a command, after the least number of runs
LONG = 15 # a run that takes as many seconds is not repeated


class Command:
    """made: of the file of the standard output, what came of it. frames: of the text of the standard output, the least,
    median and processor's seconds of what the command timed itself."""

    def __init__(self, label, argv, made=None, frames=None, most_runs=MOST_RUNS, env=()):
        self.label, self.argv, self.made, self.frames, self.most_runs = label, argv, made, frames, most_runs
        self.env, self.runs, self.failed, self.note = dict(env), [], '', ''

    @property
    def seconds(self):
        return sum(run['seconds'] for run in self.runs)

    def wants_another(self):
        n = len(self.runs)
        if self.failed or n >= self.most_runs or (n and self.runs[0]['seconds'] > LONG):
            return False
        return n < LEAST_RUNS or self.seconds * (n + 1) / n < BUDGET


class Children:
    """The one child that runs, if any. A signal ends it, and then this script. The handler raises nothing, so that no
    child is lost between its start and the line that knows it."""

    def __init__(self):
        self.child, self.signal = None, 0
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, self.end)

    def end(self, number, _):
        self.signal = number
        if self.child is not None:
            signal.pidfd_send_signal(self.child, signal.SIGKILL)

    def wait(self, pid, limit=None):
        """Waits for a child. Returns its status, its use of the machine, when it ended, and whether it was late."""
        self.child = os.pidfd_open(pid)
        if self.signal:
            signal.pidfd_send_signal(self.child, signal.SIGKILL)
        late = not select.select([self.child], [], [], limit)[0]
        ended = time.monotonic()
        if late:
            signal.pidfd_send_signal(self.child, signal.SIGKILL)
        _, status, used = os.wait4(pid, 0)
        child, self.child = self.child, None
        os.close(child)
        if self.signal:
            print('beside.py: interrupted', file=sys.stderr)
            sys.exit(128 + self.signal)
        return os.waitstatus_to_exitcode(status), used, ended, late


children = Children()


def say(text):
    print(f'beside.py: {text}', file=sys.stderr, flush=True)


def apart(work):
    """Calls `work` in a process of its own."""
    pid = os.fork()
    if pid == 0:
        status = 1
        try:
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                signal.signal(number, signal.SIG_DFL)
            work()
            status = 0
        finally:
            os._exit(status)
    if children.wait(pid)[0]:
        sys.exit('beside.py: a scene could not be made')


def reason(text, status):
    """Why a program gave up: the last line that it said, without the names of files."""
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1].split(': ', 2)[-1].strip()[:120] if lines else f'status {status}'


def run_once(command, folder):
    out, err = folder / 'stdout', folder / 'stderr'
    env = {key: value for key, value in os.environ.items() if key not in ('DISPLAY', 'LP_NUM_THREADS')}
    with open(out, 'wb') as output, open(err, 'wb') as errors:
        began = time.monotonic()
        child = subprocess.Popen([str(word) for word in command.argv], cwd=folder, env=env | command.env,
                                 stdin=subprocess.DEVNULL, stdout=output, stderr=errors)
        status, used, ended, late = children.wait(child.pid, LIMIT)
        child.returncode = status  # wait4 has reaped it
    run = {'seconds': ended - began, 'processor': used.ru_utime + used.ru_stime, 'bytes': used.ru_maxrss * 1024,
           'least_seen': resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024, 'printed': out.stat().st_size}
    command.runs.append(run)
    if late:
        command.failed = f'more than {LIMIT} s'
        if run['printed'] > 1e6:
            command.failed += f'; {run["printed"] / 1e6:,.0f} MB were printed by then'
    elif status:
        command.failed = 'gives up: ' + reason(err.read_text(errors='replace'), status)
    elif command.frames:
        run['frames'] = command.frames(out.read_text())


def take_turns(commands, folder):
    """Runs the commands in turns, each as often as it wants. `made` looks at what the last run of each printed."""
    while any([command.wants_another() for command in commands]):
        for command in commands:
            if command.wants_another():
                run_once(command, folder)
                if command.made and not command.failed and not command.wants_another():
                    command.note = command.made(folder / 'stdout')
                (folder / 'stdout').unlink()
    for command in commands:
        figures = summary(command)
        say(f'{command.label}: {command.failed or "%.4f s" % figures["least"]}, runs: {len(command.runs)}')


def median_of(numbers):
    return sorted(numbers)[len(numbers) // 2]


def summary(command):
    """What the table says of a command: seconds, and bytes."""
    runs = command.runs
    most = max(runs, key=lambda run: run['bytes'])
    made = {'label': command.label, 'runs': len(runs), 'bytes': most['bytes'], 'least_seen': most['least_seen'],
            'failed': command.failed, 'note': command.note, 'all': runs}
    if command.frames and not command.failed:
        least, median, processor = zip(*[run['frames'] for run in runs])
        return made | {'least': min(least), 'median': median_of(median), 'processor': min(processor)}
    seconds = [run['seconds'] for run in runs]
    return made | {'least': min(seconds), 'median': median_of(seconds),
                   'processor': min(run['processor'] for run in runs)}


def output_of(argv, folder):
    """What a command prints that is not measured; nothing if it fails."""
    command = Command(str(argv[0]), argv)
    run_once(command, folder)
    return '' if command.failed else (folder / 'stdout').read_text(errors='replace')


def processor():
    for line in Path('/proc/cpuinfo').read_text(encoding='utf-8').splitlines():
        if line.startswith('model name'):
            return line.split(':', 1)[1].strip()
    return os.uname().machine
