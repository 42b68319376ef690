# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the real trio for tests: start, look at its processes, disturb it, see how it ended."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = pathlib.Path(os.environ.get("FISSURA_PROGRAMS", ROOT / "build/release/bin"))
COUPLER = PROGRAMS / "coupler"
CASE = ROOT / "cases/kgd_mixed"


class Run:
    """One `coupler run` in a directory of its own."""

    def __init__(self, *options, case=CASE, form="--short", threads=1):
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="fissura-test-"))
        self.directory = self.home / "run"
        command = [COUPLER, "run", case, "--out", self.directory, "--threads", str(threads), *options]
        if form:
            command.append(form)
        self.process = subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for pid in self.pids():
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        if self.process.poll() is None:
            self.process.kill()
        for stream in (self.process.stdout, self.process.stderr):
            stream.close()
        self.process.wait()
        shutil.rmtree(self.home, ignore_errors=True)

    def wait(self, seconds=60):
        """Exit code; a run that does not end in time fails the test."""
        self.output, self.errors = self.process.communicate(timeout=seconds)
        return self.process.returncode

    @property
    def last_line(self):
        lines = [line for line in self.errors.splitlines() if line.startswith("coupler: ")]
        return lines[-1] if lines else ""

    def pids(self, role=None):
        """Processes of this run: the participants by role, the coupler's worker, or all but the supervisor."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            if not entry.name.isdigit():
                continue
            try:
                words = (entry / "cmdline").read_bytes().decode().split("\0")
                state = (entry / "stat").read_text().rsplit(")", 1)[1].split()[0]
            except (OSError, IndexError):
                continue
            if state == "Z" or str(self.directory) not in " ".join(words) or int(entry.name) == self.process.pid:
                continue
            program = pathlib.Path(words[0]).name
            if role is None or program == role or role in " ".join(words[:2]):
                found.append(int(entry.name))
        return found

    def wait_until_running(self, seconds=60, segments=0):
        """Until the participants are at work on intervals, and that many segments are closed."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            closed = len(list((self.directory / "segments").glob("*.h5")))
            if (self.directory / "history.csv").exists() and closed >= segments and self.pids("structure"):
                return
            time.sleep(0.01)
        raise AssertionError("the trio did not start: " + (self.process.stderr.read() if self.process.poll() is not None else ""))

    def summary(self):
        return json.loads((self.directory / "summary.json").read_text())

    def history(self):
        return (self.directory / "history.csv").read_bytes()
