#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays the fault matrix (fault_cells.py, docs/faults.md) with the real trio on a small case: every fault at every role and phase must end the
run, or be survived, as the table says. Counts hangs, orphans, leftover sockets, wrong codes, wrong sentences, late ends and resumed runs with
other bytes.

    tests/system/fault_matrix.py [--short] [--jobs N] [--only PATTERN] [--again FILE] [--json FILE] [--list]

FISSURA_PROGRAMS names the directory with the programs. Exit code 0: every cell as the table says; 1: not; 3: as the table says, but cells
were skipped because a tool is missing. Times to detection count on an idle machine only: what is late is played once more alone before it
counts, and the short form (a test) does not judge them.
"""
import argparse
import collections
import concurrent.futures
import dataclasses
import functools
import json
import os
import re
import shutil
import signal
import sys
import time

import fault_checker
import fault_scripts
from fault_cells import SIGNALS, Cell, all_cells, short_cells
from fault_run import COUPLER, LAST_LINE, Home, Watched, clean_run, differences, has_command, has_program, results, resume, run_command

PATIENCE = 25.0   # s until a run that does not end counts as hanging
GONE = 5.0        # s from the first fault until no process of the run may be left
CHECKPOINTS = {"checkpoint.intervals": 5}
# Whoever is refused before there is a run to speak of is told so in one line without interval and phase.
BEFORE_THE_RUN = (2, 10, 11, 12)
BEFORE = re.compile(r"coupler: [A-Z-]+: (?P<sentence>.*)")
KINDS = ("hang", "orphan", "socket", "code", "sentence", "report", "late", "gone", "bytes", "resume", "checker", "error")


@dataclasses.dataclass
class Played:
    cell: Cell
    code: int = None
    line: str = ""
    problems: list = dataclasses.field(default_factory=list)  # (kind, words)
    detected: float = None   # s from the fault to the last line
    gone: float = None       # s from the fault until nobody was left
    seconds: float = 0.0
    skipped: str = ""
    resumed: bool = True

    def code_fits(self):
        return re.fullmatch(str(self.cell.end.code), str(self.code)) is not None

    def wrong(self, kind, words):
        self.problems.append((kind, words))


@functools.cache
def can_resume():
    return has_command("resume")


def do_acts(run, cell):
    """Plays what is done from outside. @returns monotonic time of the first signal that is a fault"""
    fault_at = None
    for verb, *words in cell.acts:
        if verb == "stopped":
            if not run.until(lambda: run.stopped(words[0]) or run.ended(), PATIENCE) or run.ended():
                raise RuntimeError(f"{words[0]} was never stopped: {run.errors[-500:]}")
        elif verb == "wait":
            run.until(run.ended, words[0])
        else:
            number = SIGNALS[words[1]]
            if fault_at is None:
                fault_at = time.monotonic()
            for _ in range(1000 if verb == "storm" else 1):
                run.send(words[0], number) if verb != "storm" else os.kill(run.process.pid, number)
    return fault_at


def judge_end(played, run, home):
    """Code, last line and report against what the cell must give."""
    cell = played.cell
    played.line = run.last_line[1]
    if not played.code_fits():
        played.wrong("code", f"{played.code} instead of {cell.end.code}: {played.line or run.errors[-400:]}")
        return
    if cell.end.code in (0, 137):
        return
    match = LAST_LINE.match(played.line)
    if not match and played.code in BEFORE_THE_RUN and (said := BEFORE.search(run.errors)):
        played.line = said[0]
        if not re.search(cell.end.says, said["sentence"]):
            played.wrong("sentence", f"does not say {cell.end.says!r}: {played.line}")
        return
    if not match:
        played.wrong("sentence", f"no last line: {run.errors[-300:]}")
        return
    if cell.end.who and not re.fullmatch(cell.end.who, match["who"]):
        played.wrong("sentence", f"names {match['who']} instead of {cell.end.who}: {played.line}")
    if not re.search(cell.end.says, match["sentence"]):
        played.wrong("sentence", f"does not say {cell.end.says!r}: {played.line}")
    if cell.end.interval >= 0 and int(match["interval"]) != cell.end.interval:
        played.wrong("sentence", f"interval {match['interval']} instead of {cell.end.interval}: {played.line}")
    report = home.run / "run.report.json"
    if report.exists():
        told = json.loads(report.read_text())
        if told.get("code") != played.code or told.get("last_line") != played.line:
            played.wrong("report", f"run.report.json has {told.get('code')}, {told.get('last_line')!r}; the run {played.code}, {played.line!r}")
    elif cell.resumes != "no" or (home.run / "run.json").exists():
        played.wrong("report", "no run.report.json")


def judge_times(played, run, fault_at):
    """From the first fault to the last line, and until nobody is left."""
    begin = fault_at or run.fault_at
    said = run.last_line[0] or run.ended_at
    run.until(lambda: not run.members(), GONE)
    now = time.monotonic()
    left = run.members()
    if left:
        played.wrong("orphan", ", ".join(f"{role} {pid}" for pid, role in left.items()))
    if begin is None or played.cell.end.code == 0:
        return
    played.detected, played.gone = max(0.0, said - begin), (max(said, run.ended_at) if now - run.ended_at < 0.2 else now) - begin
    if played.detected > played.cell.within:
        played.wrong("late", f"{played.detected:.2f} s after the fault, {played.cell.within} s allowed")
    if played.gone > max(GONE, played.cell.within):
        played.wrong("gone", f"{played.gone:.2f} s after the fault a process was left")


def play_run(cell, clean, home, played):
    run = Watched(run_command(home.run, *cell.options, *(("--fault-plan", home.plan(cell.faults)) if cell.faults else ()),
                              **{**CHECKPOINTS, **dict(cell.values)}), home)
    try:
        fault_at = do_acts(run, cell)
        played.code = run.finish(PATIENCE)
        if played.code is None:
            played.wrong("hang", f"not ended {PATIENCE:.0f} s later; living: {run.members()}; said: {run.errors[-300:]}")
            return
        judge_end(played, run, home)
        judge_times(played, run, fault_at)
        if played.code == 0 and cell.end.code == 0:
            wrong = differences(results(home.run), clean.files)
            if wrong:
                played.wrong("bytes", "other bytes in " + ", ".join(wrong))
        if played.code_fits() and played.code != 137:
            for problem in fault_checker.check(home.run, clean.directory, played.code):
                played.wrong("checker", problem)
        if cell.end.code != 137 and (sockets := home.sockets()):
            played.wrong("socket", ", ".join(sockets))
    finally:
        run.clear()
    if cell.resumes != "no" and cell.end.code != 0 and played.code_fits():
        if not (home.run / "run.json").exists():
            return  # ended before there was a run to resume
        played.resumed = can_resume()
        if not played.resumed:
            return
        problem = resume(home, clean)
        if problem:
            played.wrong("resume", problem)
        if sockets := home.sockets():
            played.wrong("socket", "after resume: " + ", ".join(sockets))


def play(cell, clean):
    played, start = Played(cell), time.monotonic()
    try:
        with Home() as home:
            if cell.script:
                getattr(fault_scripts, cell.script)(cell, clean, home, played)
            else:
                play_run(cell, clean, home, played)
    except fault_scripts.Skip as reason:
        played.skipped = str(reason)
    except Exception as problem:  # a defect of the harness must not look like a pass
        played.wrong("error", f"{type(problem).__name__}: {problem}")
    played.seconds = time.monotonic() - start
    return played


def missing(cells):
    """What the cells need and this build or machine has not: need -> words."""
    lacking = {}
    for need in {need for cell in cells for need in cell.needs}:
        if need in ("unshare", "strace", "c++"):
            present = shutil.which(need)
        elif need.startswith("program:"):
            present = has_program(need.split(":")[1])
        else:
            present = has_command(need)
        if not present:
            lacking[need] = f"no {need}"
    return lacking


def tell(played):
    times = "" if played.detected is None else f"  found {played.detected:.2f} s  gone {played.gone:.2f} s"
    if played.problems:
        print(f"WRONG     {played.cell.name}{times}", flush=True)
    for kind, words in played.problems:
        print(f"          {kind}: {words}", flush=True)


def summary(all_played, seconds):
    counts = collections.Counter(kind for played in all_played for kind in {kind for kind, _ in played.problems})
    rows = collections.defaultdict(lambda: [0, 0, 0, 0.0])
    for played in all_played:
        row = rows[played.cell.row]
        row[0] += 1
        row[1] += not played.problems and not played.skipped
        row[2] += bool(played.skipped)
        row[3] = max(row[3], played.detected or 0.0)
    print(f"\n{'row':40} cells  good  skipped  slowest detection")
    for name, (cells, good, skipped, slowest) in rows.items():
        print(f"{name:40} {cells:5d} {good:5d} {skipped:8d}  {f'{slowest:.2f} s' if slowest else ''}")
    for reason, number in collections.Counter(played.skipped for played in all_played if played.skipped).items():
        print(f"\nSKIPPED {number} cells: {reason}")
    if unresumed := sum(not played.resumed for played in all_played):
        print(f"\nNOT RESUMED {unresumed} cells: no coupler resume")
    skipped = sum(bool(played.skipped) for played in all_played)
    good = sum(not played.problems and not played.skipped for played in all_played)
    print(f"\n{len(all_played)} cells in {seconds:.0f} s: {good} as they must, {skipped} SKIPPED; " +
          ", ".join(f"{counts[kind]} {kind}" for kind in KINDS if counts[kind] or kind in ("hang", "orphan", "socket", "code")))
    return 1 if good + skipped < len(all_played) else 3 if skipped or unresumed else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true", help="a hundred cells spread over all rows; times are not judged")
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time")
    parser.add_argument("--only", metavar="PATTERN", default="", help="regular expression for names of cells")
    parser.add_argument("--json", metavar="FILE", help="writes every cell with its code, line, times and problems")
    parser.add_argument("--again", metavar="FILE", help="only what was wrong in this file of --json")
    parser.add_argument("--list", action="store_true", help="prints the names of the cells only")
    options = parser.parse_args()
    cells = all_cells()
    if options.short:
        cells = short_cells(cells)
    cells = [cell for cell in cells if re.search(options.only, cell.name)]
    if options.again:
        with open(options.again, encoding="utf-8") as file:
            wrong = {entry["cell"] for entry in json.load(file) if entry["problems"]}
        cells = [cell for cell in cells if cell.name in wrong]
    if options.list:
        for cell in cells:
            print(f"{cell.end.code!s:8}  {cell.name}")
        return 0
    lacking = missing(cells)
    clean = clean_run(**CHECKPOINTS) if has_command("resume") else clean_run()
    print(f"{len(cells)} cells; undisturbed: {clean.intervals} intervals, {len(clean.insertions)} insertions, {clean.seconds:.2f} s; {COUPLER}", flush=True)
    start, done = time.monotonic(), []

    def one(cell):
        reasons = [lacking[need] for need in cell.needs if need in lacking]
        return Played(cell, skipped=", ".join(reasons)) if reasons else play(cell, clean)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for played in pool.map(one, cells):
            late = {kind for kind, _ in played.problems} and {kind for kind, _ in played.problems} <= {"late", "gone"}
            if late and options.short:
                played.problems.clear()
            elif not late:
                tell(played)
            done.append(played)
    for index, played in enumerate(done):
        if {kind for kind, _ in played.problems} and {kind for kind, _ in played.problems} <= {"late", "gone"}:
            done[index] = play(played.cell, clean)  # alone
            tell(done[index])
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump([{"cell": p.cell.name, "row": p.cell.row, "expected": p.cell.end.code, "code": p.code, "line": p.line, "detected": p.detected,
                        "gone": p.gone, "seconds": p.seconds, "skipped": p.skipped, "problems": p.problems} for p in done], file, indent=1)
    return summary(done, time.monotonic() - start)


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    # A signal with a handler is an ordinary one again in the programs started: under nohup SIGHUP would be ignored in all of them.
    signal.signal(signal.SIGHUP, lambda *_: None)
    sys.exit(main())
