# SPDX-License-Identifier: GPL-3.0-or-later
"""One program of the trio with a fault in it, watched from outside: who dies or stops when, what it says last, what it leaves behind."""
import atexit
import dataclasses
import functools
import hashlib
import os
import pathlib
import re
import shutil
import signal
import stat
import subprocess
import tempfile
import threading
import time
import uuid

from trio import COUPLER, PROGRAMS, ROOT

SMALL_CASE = ROOT / "tests/cases/fault_small"
FAULT_PLAN = "plan.toml"
MARK = "FISSURA_CELL"
WALL_TIMES = "remeshing_wall.csv"  # differ from run to run
TICK = 0.01  # s between two looks at the processes
# Short deadlines, so that an endless loop is found soon; a slow machine must still get through the start.
DEADLINES = {"deadlines.progress": "2 s", "deadlines.join": "4 s", "deadlines.finish": "3 s"}
LAST_LINE = re.compile(r"coupler: (?P<name>[A-Z-]+) (?P<who>\w+) interval=(?P<interval>\d+) phase=(?P<phase>[^:]*): (?P<sentence>.*)$")


def settings(values):
    """--set options; texts in quotes, numbers as they are."""
    words = []
    for key, value in values.items():
        words += ["--set", f"{key}={value}" if isinstance(value, (int, float)) else f'{key}="{value}"']
    return words


def run_command(directory, *options, case=SMALL_CASE, **values):
    return [COUPLER, "run", case, "--out", directory, "--threads", "1", *options, *settings({**DEADLINES, **values})]


def plan_text(faults):
    """The fault plan of docs/operation.md: one table for each dictionary, [[fault]] or what its key `table` says."""
    text = ""
    for fault in faults:
        text += f"[[{fault.get('table', 'fault')}]]\n"
        for key, value in fault.items():
            if key != "table":
                text += f"{key} = " + (f'"{value}"' if type(value) is str else str(value).lower()) + "\n"
    return text


class Home:
    """A directory for one cell, with its own place for temporary files; gone afterwards."""

    def __init__(self, prefix="fissura-cell-"):
        self.path = pathlib.Path(tempfile.mkdtemp(prefix=prefix))
        self.temporary = self.path / "tmp"
        self.temporary.mkdir()
        self.run = self.path / "run"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        subprocess.run(["chmod", "-R", "u+rwX", self.path], check=False)
        shutil.rmtree(self.path, ignore_errors=True)

    def plan(self, faults):
        file = self.path / FAULT_PLAN
        file.write_text(plan_text(faults))
        return file

    def sockets(self):
        found = []
        for folder, _, names in os.walk(self.path):
            for name in names:
                try:
                    if stat.S_ISSOCK(os.lstat(pathlib.Path(folder) / name).st_mode):
                        found.append(str(pathlib.Path(folder) / name))
                except OSError:
                    pass
        return found


class Watched:
    """A started program and everything that descends from it, known by a mark in its environment."""

    def __init__(self, command, home, environment=None, cwd=None, stdout=subprocess.DEVNULL):
        self.home, self.mark = home, uuid.uuid4().hex
        surroundings = {**os.environ, "TMPDIR": str(home.temporary), **(environment or {}), MARK: self.mark}
        self.lines = []  # (monotonic time, text) of standard error
        self.seen, self.roles, self.states = set(), {}, {}
        self.fault_at = None   # monotonic time of the first death or stop among the participants and the worker
        self.started_at = time.monotonic()
        self.process = subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=stdout,
                                        stderr=subprocess.PIPE, text=True, errors="replace", env=surroundings, cwd=cwd)
        self.ended_at = None
        self.reader = threading.Thread(target=self._read, daemon=True)
        self.reader.start()

    def _read(self):
        for line in self.process.stderr:
            self.lines.append((time.monotonic(), line.rstrip("\n")))

    @property
    def errors(self):
        return "\n".join(text for _, text in self.lines)

    @property
    def last_line(self):
        """(monotonic time, text) of the last line that the coupler itself wrote, whatever came after."""
        said = [entry for entry in self.lines if entry[1].startswith("coupler: ") and LAST_LINE.match(entry[1])]
        return said[-1] if said else (None, "")

    def _role(self, pid):
        try:
            words = pathlib.Path(f"/proc/{pid}/cmdline").read_bytes().decode(errors="replace").split("\0")
        except OSError:
            return self.roles.get(pid)
        program = pathlib.Path(words[0]).name
        if pid == self.process.pid:
            return "supervisor"
        return {"coupler": "coupler", "structure": "structure", "network": "network"}.get(program) or self.roles.get(pid) or program

    def members(self):
        """Living processes of the run by number: their roles. A zombie is not living."""
        for entry in os.listdir("/proc"):
            if not entry.isdigit() or int(entry) in self.seen:
                continue
            pid = int(entry)
            try:
                surroundings = pathlib.Path(f"/proc/{pid}/environ").read_bytes()
                if f"{MARK}={self.mark}".encode() in surroundings:
                    self.roles[pid] = None
                if surroundings:  # empty while another program is being loaded
                    self.seen.add(pid)
            except OSError:
                pass
        living = {}
        for pid in list(self.roles):
            state = self.state(pid)
            before = self.states.get(pid)
            self.states[pid] = state
            if state not in (None, "Z", "X"):
                living[pid] = self.roles[pid] = self._role(pid)
            fell = state in (None, "Z", "X", "T", "t") and before not in (None, "Z", "X", "T", "t")
            if fell and self.fault_at is None and pid != self.process.pid:
                self.fault_at = time.monotonic()
        return living

    def state(self, pid):
        try:
            return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
        except (OSError, IndexError):
            return None

    def pids(self, role):
        return [pid for pid, found in self.members().items() if found == role]

    def until(self, condition, seconds):
        """Looks again and again; True as soon as the condition holds, False if it never did in that time."""
        end = time.monotonic() + seconds
        while True:
            self.members()
            if self.ended_at is None and self.process.poll() is not None:
                self.ended_at = time.monotonic()
            if condition():
                return True
            if time.monotonic() > end:
                return False
            time.sleep(TICK)

    def ended(self):
        return self.ended_at is not None

    def stopped(self, role):
        return any(self.state(pid) in ("T", "t") for pid in self.pids(role))

    def send(self, role, number):
        """The signal to every process of that role; the time of the fault unless there was one before."""
        pids = self.pids(role)
        for pid in pids:
            try:
                os.kill(pid, number)
            except ProcessLookupError:
                pass
        return bool(pids)

    def finish(self, patience):
        """Waits for the end. @returns exit code as a shell would give it, or None if it does not end: a hang"""
        if not self.until(self.ended, patience):
            return None
        self.reader.join(timeout=2)
        code = self.process.returncode
        return code if code >= 0 else 128 - code

    def clear(self):
        """Ends whatever is left. @returns roles and numbers of what was"""
        left = self.members()
        for pid in left:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        return [f"{role or '?'} {pid}" for pid, role in left.items()]


def results(directory):
    """SHA-256 of each file that an interrupted and resumed run must have in common with an uninterrupted one."""
    files = {}
    for path in sorted(directory.glob("segments/*.h5")) + [directory / "segments/index.jsonl"] + sorted(directory.glob("*.csv")) + [
            directory / "seismicity/catalogue.csv"]:
        if path.exists() and path.name != WALL_TIMES:
            files[str(path.relative_to(directory))] = hashlib.sha256(path.read_bytes()).hexdigest()
    return files


def differences(found, expected):
    """Names of files that differ, are missing or too many."""
    return sorted(name for name in {*found, *expected} if found.get(name) != expected.get(name))


@dataclasses.dataclass
class Clean:
    """What the undisturbed run of the small case gives, and where its events lie."""
    files: dict
    intervals: int
    insertions: list  # coupling intervals after which the topology changed
    seconds: float
    directory: pathlib.Path  # of that run


def clean_run(**values):
    """Its directory stays until the program ends."""
    home = Home()
    atexit.register(home.__exit__)
    start = time.monotonic()
    run = Watched(run_command(home.run, **values), home)
    code = run.finish(120)
    run.clear()
    if code != 0:
        raise SystemExit(f"the undisturbed run ended with {code}:\n{run.errors}")
    seconds = time.monotonic() - start
    rows = [line.split(",") for line in (home.run / "history.csv").read_text().splitlines()]
    revision = rows[0].index("revision")
    revisions = [int(row[revision]) for row in rows[1:]]
    insertions = [i + 1 for i, (a, b) in enumerate(zip(revisions, revisions[1:])) if b > a]
    return Clean(results(home.run), len(rows) - 1, insertions, seconds, home.run)


def resume(home, clean, environment=None, patience=60):
    """`coupler resume` until the end. @returns what is wrong, or nothing"""
    run = Watched([COUPLER, "resume", home.run], home, environment)
    code = run.finish(patience)
    left = run.clear()
    if code is None:
        return "resume hangs"
    if left:
        return f"resume leaves {', '.join(left)}"
    if code != 0:
        return f"resume ends with {code}: {run.last_line[1] or run.errors[-300:]}"
    wrong = differences(results(home.run), clean.files)
    return f"after resume other bytes in {', '.join(wrong)}" if wrong else None


@functools.cache
def has_command(name):
    """Whether this coupler knows the subcommand, or the option of `run`."""
    words = [COUPLER, "run", "--help"] if name.startswith("--") else [COUPLER, "--help"]
    told = subprocess.run(words, capture_output=True, text=True).stdout
    return re.search(rf"^ +{re.escape(name)}\b", told, re.MULTILINE) is not None


def has_program(name):
    return (PROGRAMS / name).exists()
