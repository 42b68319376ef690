#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges a run by what it left behind and nothing else: report, last line, files, transcripts of its messages. Shares no code with the programs.

    fault_checker.py RUN [--clean RUN] [--expect CODE]

--clean names the directory of the same run without faults. Prints what is wrong, one thing on each line; exit code 0: nothing, 1: something.
"""
import argparse
import collections
import fcntl
import hashlib
import json
import os
import pathlib
import re
import stat
import sys

NAMES = {2: "COMMAND-LINE", 10: "CASE-INVALID", 11: "PRECONDITION", 12: "ROLE-TAKEN", 13: "MISMATCH", 14: "SECURITY", 20: "PARTICIPANT-DIED",
         21: "PARTICIPANT-UNRESPONSIVE", 22: "PROTOCOL-VIOLATION", 23: "INVALID-VALUES", 24: "NUMERICAL-FAILURE", 25: "STORAGE-FAILURE",
         26: "OUT-OF-MEMORY", 27: "CHECKPOINT-UNUSABLE", 70: "INTERNAL", 129: "HANGUP", 130: "INTERRUPTED", 143: "TERMINATED"}
COMPLETE = (0, 1)
NOT_RESUMABLE = (2, 10, 11, 12, 13, 14)  # another start would end the same way
LAST_LINE = re.compile(r"coupler: (?P<name>[A-Z-]+) (?P<who>coupler|structure|network) interval=(?P<interval>\d+) phase=(?P<phase>[^:]*): "
                       r"(?P<sentence>.+?)(?P<resume> Resume: coupler resume \S.* \(from (interval \d+|the beginning)\))?$")
# What may happen to a message without anybody having to notice.
HARMLESS = re.compile(r"^(delay|clog|slow|restamp minor)$")
# What arrives whole first, so that the receiver goes on until the rest arrives.
WHOLE_FIRST = re.compile(r"^(duplicate|nonsense)")
COMMANDS = ("INSERT", "ADVANCE", "REPORT", "SAVE", "RESTORE", "FINISH")
ANSWERS = ("TOPOLOGY", "ACKNOWLEDGE", "PRESSURE", "RESPONSE", "FIELDS", "STATE", "RESTORED")
GROWING = ("history.csv", "ledger.csv", "probes.csv", "remeshing.csv", "meetings.csv", "seismicity/catalogue.csv")


def report_of(run):
    try:
        return json.loads((run / "run.report.json").read_text())
    except (OSError, ValueError):
        return None


def check_report(report, expect):
    if report is None:
        yield "run.report.json is missing or cannot be read"
        return
    code = report.get("code")
    if expect is not None and code != expect:
        yield f"exit code {code} instead of {expect}: {report.get('last_line', '')}"
    if code in COMPLETE:
        return
    if code not in NAMES or NAMES[code] != report.get("name"):
        yield f"exit code {code} is called {report.get('name')}"
    line = LAST_LINE.match(report.get("last_line", ""))
    if not line:
        yield f"the last line has another form: {report.get('last_line')!r}"
        return
    told = {"name": line["name"], "participant": line["who"], "interval": int(line["interval"]), "phase": line["phase"]}
    for key, value in told.items():
        if report.get(key) != value:
            yield f"last line and report differ in {key}: {value!r} and {report.get(key)!r}"
    if bool(line["resume"]) == (code in NOT_RESUMABLE):
        yield f"the last line of exit code {code} {'has' if line['resume'] else 'lacks'} the command to resume"


def check_processes(run):
    """Nothing lives that has the directory of the run in its command line, and nobody holds its lock."""
    name = str(run.resolve())
    mine = {os.getpid(), os.getppid()}
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit() or int(entry.name) in mine:
            continue
        try:
            words = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
        except OSError:
            continue
        program = pathlib.Path(words[0]).name
        if program in ("structure", "network", "coupler", "fault_proxy") and any(name in word for word in words):
            yield f"process {entry.name} ({program}) is left"
    try:
        with open(run / "lock") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except FileNotFoundError:
        pass
    except OSError:
        yield "somebody still holds the lock of the run"


def check_leftovers(run, report):
    """Parts of files are left only where the coupler itself was ended in the middle of writing them; the next start removes them."""
    cut_short = report is None or report.get("participant") == "coupler"
    for path in sorted(run.rglob("*")):
        try:
            mode = path.lstat().st_mode
        except OSError:
            continue
        if stat.S_ISSOCK(mode):
            yield f"a socket is left: {path.relative_to(run)}"
        elif path.name.endswith(".tmp") or (path.name.endswith(".part") and not cut_short):
            yield f"a part of a file is left: {path.relative_to(run)}"


def index_of(run):
    path = run / "segments/index.jsonl"
    return path.read_text().splitlines() if path.exists() else []


def check_segments(run):
    lines = index_of(run)
    reports = sources = 0
    topologies = set()
    for number, text in enumerate(lines, 1):
        try:
            line = json.loads(text)
        except ValueError:
            yield f"line {number} of the index cannot be read"
            return
        file = run / "segments" / line["file"]
        if not file.exists():
            yield f"{line['file']} stands in the index but is missing"
        elif file.stat().st_size != line["bytes"] or hashlib.sha256(file.read_bytes()).hexdigest() != line["sha256"]:
            yield f"{line['file']} is not what the index says"
        if line["reports"][0] != reports + 1 or line["sources"][0] != sources + 1:
            yield f"{line['file']} does not go on where the one before ended"
        reports, sources = line["reports"][1], line["sources"][1]
        for revision in line["networks"]:
            if revision in topologies:
                yield f"topology revision {revision} stands twice in the segments"
            topologies.add(revision)


def check_against(run, clean, complete):
    """What is there is the beginning of what the undisturbed run gives; all of it if the run is complete. A run that fails closes the segment
    that is open, which is then shorter than it would have become; going on replaces it."""
    mine, theirs = index_of(run), index_of(clean)
    if not complete and mine and len(mine) <= len(theirs):
        last, whole = json.loads(mine[-1]), json.loads(theirs[len(mine) - 1])
        shorter = last["reports"][1] < whole["reports"][1] or last["sources"][1] < whole["sources"][1]
        if shorter and last["reports"][0] == whole["reports"][0] and last["sources"][0] == whole["sources"][0]:
            mine.pop()
    if mine != theirs[:len(mine)]:
        first = next(i for i in range(len(mine)) if i >= len(theirs) or mine[i] != theirs[i])
        yield f"closed segment {first + 1} differs from that of the undisturbed run"
    if complete and len(mine) != len(theirs):
        yield f"{len(mine)} closed segments, the undisturbed run has {len(theirs)}"
    for name in GROWING:
        if not (clean / name).exists():
            continue
        whole = (clean / name).read_bytes()
        found = (run / name).read_bytes() if (run / name).exists() else b""
        if complete and found != whole:
            yield f"{name} differs from that of the undisturbed run"
        elif name == "history.csv" and not whole.startswith(found[:found.rfind(b"\n") + 1]):
            yield f"{name} is not the beginning of that of the undisturbed run"


def transcript_of(run, role):
    path = run / f"fault_transcript_{role}.jsonl"
    if not path.exists():
        return None
    return [json.loads(line) for line in path.read_text().splitlines()]


def transcript_hash(run, role):
    """The same for the same plan, whatever the machine does; what a run says when it ends is left out, as it may cross."""
    lines = [line for line in transcript_of(run, role) if line["type"] not in ("FAIL", "PROGRESS")]
    return hashlib.sha256(json.dumps(lines).encode()).hexdigest()


def check_transcript(lines, role, complete):
    counts = collections.Counter()
    inserted, faulty = {}, None
    for line in lines:
        key = (line["epoch"], line["direction"])
        if "n" in line:
            counts[key] += 1
            if line["n"] != counts[key]:
                yield f"the transcript of {role} lacks messages before {line}"
                return
        if faulty and faulty["epoch"] == line["epoch"]:
            accepted = COMMANDS if faulty["direction"] == "to_coupler" else ANSWERS
            if line["direction"] != faulty["direction"] and line["type"] in accepted:
                if faulty["spare"] == 0:
                    yield f"{role}: {line['type']} of interval {line['interval']} followed although {faulty['type']} before was spoilt ({faulty['did']})"
                faulty["spare"] -= 1
        else:
            faulty = None
        if line["type"] == "INSERT" and line["direction"] == "to_participant":
            last = inserted.get(line["epoch"])
            if last is not None and line["revision"] != last + 1:
                yield f"{role}: insertion of revision {line['revision']} after {last}"
            inserted[line["epoch"]] = line["revision"]
        did = line.get("did", "")
        if did and not did.endswith("no such thing") and not HARMLESS.match(did) and faulty is None:
            faulty = {**line, "spare": 1 if WHOLE_FIRST.match(did) else 0}
            if complete:
                yield f"{role}: the run is complete although {line['type']} of interval {line['interval']} was spoilt ({did})"


def check(run, clean=None, expect=None):
    """What is wrong, in words."""
    run = pathlib.Path(run)
    report = report_of(run)
    code = report.get("code") if report else None
    problems = [*check_report(report, expect), *check_processes(run), *check_leftovers(run, report), *check_segments(run)]
    if clean:
        problems += check_against(run, pathlib.Path(clean), code in COMPLETE)
    for role in ("structure", "network"):
        lines = transcript_of(run, role)
        for epoch in sorted({line["epoch"] for line in lines or ()}):
            complete = code in COMPLETE and epoch == report.get("epoch")
            problems += check_transcript([line for line in lines if line["epoch"] == epoch], role, complete)
    return problems


def main():
    parser = argparse.ArgumentParser(description="Judges a run by what it left behind.")
    parser.add_argument("run", type=pathlib.Path)
    parser.add_argument("--clean", type=pathlib.Path, help="the same run without faults")
    parser.add_argument("--expect", type=int, help="its exit code")
    options = parser.parse_args()
    problems = check(options.run, options.clean, options.expect)
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
