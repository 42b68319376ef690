# SPDX-License-Identifier: GPL-3.0-or-later
"""A run that goes from flow solver to flow solver: stopped after chosen coupling intervals, resumed with another one each time. On a machine
so busy that the stop comes late it is an interval or more after the chosen one: `stopped_after` tells."""
import csv
import json
import pathlib
import shutil
import subprocess
import tempfile
import time

from trio import COUPLER, ROOT

PATIENCE = 300
LEDGER = 1e-10  # of the largest volume: what every interval of every run keeps


class SwapFailure(Exception):
    pass


def plan(folder, interval, epoch):
    """The structure sleeps in that interval: long enough to be asked to stop, in every life of the run at the same place."""
    file = folder / f"plan_{epoch}.toml"
    file.write_text(f'[[fault]]\nrole = "structure"\nphase = "advance"\ninterval = {interval}\nepoch = {epoch}\ndo = "sleep"\nseconds = 1.5\n')
    return file


class SwappedRun:
    """`case` from the first of `solvers` to the last; the k-th one is stopped after the coupling interval stops[k]."""

    def __init__(self, case, solvers, stops, options=("--short",)):
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="fissura-swap-"))
        self.directory, self.solvers, self.stops = self.home / "run", solvers, stops
        self.errors = []
        words = ["run", ROOT / "cases" / case, "--out", self.directory, "--network", solvers[0], *options]
        for epoch, stop in enumerate(stops):
            self.live(words, epoch, stop)
            words = ["resume", self.directory, "--network", solvers[epoch + 1]]
        self.code = self.call(words)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.home, ignore_errors=True)

    def call(self, words):
        done = subprocess.run([str(word) for word in (COUPLER, *words)], capture_output=True, text=True, timeout=PATIENCE)
        self.errors.append(done.stderr)
        return done.returncode

    def live(self, words, epoch, stop):
        """One life of the run, up to its end after the interval `stop`."""
        command = [COUPLER, *words, "--fault-plan", plan(self.home, stop, epoch)]
        process = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        try:
            self.wait_until_asleep(process, stop)
            subprocess.run([str(COUPLER), "stop", str(self.directory)], capture_output=True, timeout=PATIENCE, check=False)
            self.errors.append(process.communicate(timeout=PATIENCE)[1])
        finally:
            if process.poll() is None:
                process.kill()
                process.communicate()
        if process.returncode != 143:
            raise SwapFailure(f"{words[0]} with {self.solvers[epoch]} ended with {process.returncode}: {self.errors[-1][-500:]}")

    def wait_until_asleep(self, process, stop):
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline and process.poll() is None:
            answer = subprocess.run([str(COUPLER), "status", str(self.directory), "--json"], capture_output=True, text=True, timeout=PATIENCE)
            status = json.loads(answer.stdout) if answer.returncode == 0 else {}
            if status.get("interval", 0) >= stop and status.get("phase") == "structure":
                return
            time.sleep(0.02)
        raise SwapFailure(f"interval {stop} was not reached: {process.stderr.read()[-500:] if process.poll() is not None else 'too slow'}")

    def description(self):
        return json.loads((self.directory / "run.json").read_text())

    def changes(self):
        return self.description().get("network_changes", [])

    def stopped_after(self):
        return [change["interval"] for change in self.changes()]

    def history(self):
        """Columns of history.csv by name."""
        with open(self.directory / "history.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        return {name: [float(row[name]) for row in rows] for name in rows[0]}

    def events(self):
        return [json.loads(line) for line in (self.directory / "log.jsonl").read_text().splitlines()]

    def epochs(self):
        return [json.loads(line) for line in (self.directory / "epochs.jsonl").read_text().splitlines()]


def pressure_jumps(history, stops):
    """At each swap: what the inlet pressure changes by, relative to it, and the greatest such change within five intervals before it."""
    pressure = history["inlet_pressure"]
    change = [abs(new - old) / max(abs(old), 1.0) for old, new in zip(pressure, pressure[1:])]
    # Line k holds interval k + 1, so the step across a stop after interval `stop` is number stop - 1.
    return [(change[stop - 1], max(change[max(0, stop - 6):stop - 1], default=0.0)) for stop in stops]
