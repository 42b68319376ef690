# SPDX-License-Identifier: GPL-3.0-or-later
"""The fault matrix as data (docs/faults.md): each row is a fault, where it is done, and how the run must end. Rows expand over roles and
phases into cells; fault_matrix.py plays them."""
import dataclasses
import signal

# Points of one life of the run, in order, as fault plans name them. `once` comes a single time, `often` in many intervals.
PHASES = {
    "structure": {"once": ("hello", "join", "finish"), "often": ("insert", "advance", "answer", "report", "save")},
    "network": {"once": ("hello", "join", "finish"), "often": ("insert", "advance", "answer", "report", "save")},
    "coupler": {"once": ("start", "finish"),
                "often": ("network", "structure", "insertion", "report", "segment", "checkpoint-prepare", "checkpoint-commit")},
}
PARTICIPANTS = ("structure", "network")
ROLES = ("structure", "network", "coupler")
# Where in the run a phase is struck: the first time, and later, when much has happened.
LATER = {"advance": 33, "answer": 40, "network": 33, "structure": 33}
LATER_TIME = {"insert": 5, "insertion": 5, "report": 5, "segment": 5, "save": 6, "checkpoint-prepare": 6, "checkpoint-commit": 6}
RESUMING = {"structure": ("hello", "join", "restore"), "network": ("hello", "join", "restore"), "coupler": ("start", "resume")}

# Where a participant is about to say something of its solver's work.
ANSWERING = ("advance", "answer", "insert", "report", "save", "finish")


@dataclasses.dataclass(frozen=True)
class End:
    """How a run must end."""
    code: object           # or a regular expression of codes
    who: str = ""        # regular expressions of the last line
    says: str = ""
    interval: int = -1   # that the last line names; -1: any


CLEAN = End(0)


@dataclasses.dataclass(frozen=True)
class Cell:
    row: str
    place: str                 # role, phase and when: with `row` the name of the cell
    end: End
    faults: tuple = ()         # fault plan: dictionaries
    acts: tuple = ()           # done from outside, see fault_matrix.Act
    within: float = 0.25       # s from the fault to the last line
    resumes: str = "same bytes"  # after `coupler resume`; "no": not asked for
    options: tuple = ()
    values: tuple = ()         # (key, value) for --set
    script: str = ""           # function of fault_scripts.py that plays this cell instead
    arguments: tuple = ()
    needs: tuple = ()          # programs, options, tools

    @property
    def name(self):
        return f"{self.row}/{self.place}"


def points(role, phases=None):
    """(phase, words for the plan, interval the last line must name) for each point of `role`."""
    for phase in phases or PHASES[role]["once"] + PHASES[role]["often"]:
        yield phase, {"phase": phase}, -1
        if phase in LATER:
            yield f"{phase}@{LATER[phase]}", {"phase": phase, "interval": LATER[phase]}, LATER[phase]
        if phase in LATER_TIME:
            yield f"{phase}#{LATER_TIME[phase]}", {"phase": phase, "occurrence": LATER_TIME[phase]}, -1


@dataclasses.dataclass(frozen=True)
class Row:
    """A fault of one process, done by itself at every one of its points."""
    name: str
    do: dict
    code: int
    says: str
    within: float = 0.25
    roles: tuple = ROLES
    phases: tuple = ()
    who: str = ""        # instead of the role


SILENT = "(made no progress for [0-9.]+ s|did not introduce itself in|stopped by a signal|heard nothing|did not end|does not end|has not ended)"

PROCESS_ROWS = (
    Row("killed", {"do": "kill"}, 20, r"was killed by signal 9"),
    Row("segmentation fault", {"do": "segfault"}, 20, r"was killed by signal 11"),
    Row("abort", {"do": "abort"}, 20, r"was killed by signal 6"),
    Row("leaves with success", {"do": "exit", "code": 0}, 20, r"ended early with the exit code of success|has ended, but its BYE did not come"),
    Row("leaves with a code", {"do": "exit", "code": 3}, 20, r"ended with exit code 3"),
    Row("uncaught exception", {"do": "throw"}, 70, r"injected exception"),
    Row("says it failed", {"do": "fail"}, 24, r"injected failure"),
    Row("out of memory", {"do": "exhaust"}, 26, r"memory"),
    Row("rounding left changed", {"do": "round_up"}, 22, "left floating-point arithmetic changed: numbers are rounded upward", within=1,
        roles=PARTICIPANTS, phases=ANSWERING),
    Row("denormal numbers left flushed", {"do": "flush_denormals"}, 22, "arithmetic changed: numbers below the smallest normal one", within=1,
        roles=PARTICIPANTS, phases=ANSWERING),
    Row("stopped", {"do": "stop"}, 21, SILENT, within=2.5),
    Row("endless loop", {"do": "spin"}, 21, SILENT, within=5),
)
SURVIVED_ROWS = (
    Row("stopped for a moment", {"do": "stop_for", "seconds": 0.5}, 0, ""),
    Row("slow", {"do": "sleep", "seconds": 0.5}, 0, ""),
)


def process_cells():
    for row in PROCESS_ROWS:
        for role in row.roles:
            for place, point, interval in points(role, row.phases):
                # Before it is connected it cannot say why: its exit code must do.
                speechless = point["phase"] == "hello" and row.name in ("uncaught exception", "says it failed")
                says = f"ended with exit code {row.code}" if speechless else row.says
                yield Cell(row.name, f"{role} {place}", End(row.code, row.who or role, says, interval),
                           faults=({"role": role, **point, **row.do},), within=row.within, needs=("--fault-plan",))
    for row in SURVIVED_ROWS:
        for role in row.roles:
            for place, point, _ in points(role, row.phases):
                yield Cell(row.name, f"{role} {place}", CLEAN, faults=({"role": role, **point, **row.do},), resumes="no",
                           needs=("--fault-plan",))


def resume_cells():
    """A second life that dies too; the checkpoint is untouched, and the third goes on from it."""
    first = {"role": "network", "phase": "advance", "interval": 33, "do": "kill"}
    for row in PROCESS_ROWS:
        if row.name in ("killed", "uncaught exception", "stopped", "leaves with success"):
            for role, phases in RESUMING.items():
                for phase in phases:
                    says = "exit code 70" if phase == "hello" and row.code == 70 else row.says
                    yield Cell(f"{row.name} while resuming", f"{role} {phase}", End(row.code, role, says), within=row.within,
                               faults=(first, {"role": role, "phase": phase, "epoch": 1, **row.do}), script="dies_while_resuming",
                               needs=("--fault-plan", "resume"))


def together_cells():
    """Two at once: the code is that of the first; which one that is, the kernel decides."""
    for interval in (1, 20, 33, 50):
        for second in ("kill", "throw", "spin"):
            yield Cell("two at once", f"structure kill, network {second} @{interval}", End(20, "structure|network|coupler", "", -1),
                       faults=({"role": "structure", "phase": "advance", "interval": interval, "do": "kill"},
                               {"role": "network", "phase": "answer", "interval": interval, "do": second})
                       if second == "kill" else
                       ({"role": "structure", "phase": "advance", "interval": interval, "do": "kill"},
                        {"role": "network", "phase": "advance", "interval": interval + 1, "do": second}),
                       needs=("--fault-plan",))


# A run is held at a point by stopping one of its processes there; then the signal comes, and the process goes on.
HOLDS = (("network", "advance@1"), ("network", "advance@33"), ("structure", "advance@33"), ("structure", "insert#3"), ("network", "report#4"),
         ("structure", "save#4"), ("coupler", "checkpoint-prepare#4"), ("coupler", "checkpoint-commit#4"), ("coupler", "network@50"))


def hold(role, place):
    phase, _, when = place.replace("#", "@").partition("@")
    key = "occurrence" if "#" in place else "interval"
    return {"role": role, "phase": phase, key: int(when), "do": "stop"}


def signal_cells():
    supervisor = (("SIGINT", 130, "as asked"), ("SIGTERM", 143, "as asked"), ("SIGHUP", 129, "as asked"))
    for role, place in HOLDS:
        held = (hold(role, place),)
        for name, code, says in supervisor:
            yield Cell(f"{name} to the coupler", f"held {role} {place}", End(code, "", says), faults=held, within=10,
                       acts=(("stopped", role), ("signal", "supervisor", name), ("signal", role, "SIGCONT")), needs=("--fault-plan",))
        yield Cell("SIGINT twice", f"held {role} {place}", End(130, "", "at once"), faults=held, within=1,
                   acts=(("stopped", role), ("signal", "supervisor", "SIGINT"), ("wait", 0.4), ("signal", "supervisor", "SIGINT")),
                   needs=("--fault-plan",))
        yield Cell("storm of SIGINT", f"held {role} {place}", End(130, "", "as asked"), faults=held, within=10,
                   acts=(("stopped", role), ("storm", "supervisor", "SIGINT"), ("signal", role, "SIGCONT")), needs=("--fault-plan",))
        yield Cell("SIGUSR1", f"held {role} {place}", CLEAN, faults=held, resumes="no",
                   acts=(("stopped", role), ("signal", "supervisor", "SIGUSR1"), ("signal", role, "SIGCONT")), needs=("--fault-plan",))
        yield Cell("supervisor killed", f"held {role} {place}", End(137), faults=held, within=5,
                   acts=(("stopped", role), ("signal", "supervisor", "SIGKILL")), needs=("--fault-plan",))
        yield Cell("supervisor killed, others going on", f"held {role} {place}", End(137), faults=held, within=5,
                   acts=(("stopped", role), ("signal", "supervisor", "SIGKILL"), ("signal", role, "SIGCONT")), needs=("--fault-plan",))
        for other in ROLES:
            # Who is held at that moment may be the coupler's worker: then that it is stopped is the first fault.
            dead = End("20|21", f"{other}|coupler", "") if role == "coupler" != other else End(20, other, "killed by signal 9")
            yield Cell("killed from outside", f"{other}, held {role} {place}", dead, faults=held, within=2.5 if role == "coupler" != other else 0.25,
                       acts=(("stopped", role), ("signal", other, "SIGKILL")), needs=("--fault-plan",))
        for other in PARTICIPANTS:
            yield Cell("SIGTERM to a participant", f"{other}, held {role} {place}", End(143, "", ""), faults=held, within=10,
                       acts=(("stopped", role), ("signal", other, "SIGTERM"), ("signal", role, "SIGCONT")), needs=("--fault-plan",))
        if role != "coupler":
            yield Cell("illegal instruction", f"network, held {role} {place}", End(20, "network", "killed by signal 4"), faults=held,
                       acts=(("stopped", role), ("signal", "network", "SIGILL"), ("signal", "network", "SIGCONT")), needs=("--fault-plan",))


def value_cells():
    """A participant that computes nonsense is caught by whom it tells."""
    for role, fields in (("network", ("", "pressure", "aperture_predicted", "filled")), ("structure", ("", "aperture", "pressure_applied"))):
        for field in fields:
            for how in ("nan", "negative"):
                for place, point, interval in points(role, ("answer",)):
                    if how == "negative" and not field:
                        continue
                    if how == "negative" and field == "aperture_predicted":
                        continue
                    first = place == "answer"
                    point = {**point, "interval": 2} if first else point
                    yield Cell(f"{how} in a reply", f"{role} {field or 'first array'} {place}", End(23, role, "", 2 if first else interval),
                               faults=({"role": role, **point, "do": how, **({"field": field} if field else {})},),
                               needs=("--fault-plan",))


def storage_cells():
    """The file system refuses: nothing acknowledged is lost, and resuming with room again gives the same bytes."""
    for do, says in (("disk_full", "No space left|space"), ("write_error", "Input/output error|write"), ("sync_error", "Input/output error|sync"),
                     ("rename_error", "Input/output error|rename")):
        for place, point, _ in points("coupler", ("segment", "checkpoint-prepare", "checkpoint-commit", "report", "network")):
            if do == "rename_error" and point["phase"] in ("report", "network") or do != "rename_error" and point["phase"] == "checkpoint-commit":
                continue
            yield Cell(f"{do.replace('_', ' ')}", f"coupler {place}", End(25, "coupler", ""), faults=({"role": "coupler", **point, "do": do},),
                       within=5, needs=("--fault-plan",))


def script_cells():
    """What is not a fault of a process at work: fault_scripts.py plays these."""
    def cell(row, place, end, script, *arguments, **more):
        return Cell(row, place, end, script=script, arguments=arguments, **more)

    for role in PARTICIPANTS:
        yield cell("program missing", role, End(11, role, "No such file|not found|cannot"), "run_ends", f"--{role}", "/nowhere/solver", resumes="no")
        yield cell("program not executable", role, End(11, role, "ermission|not executable|cannot"), "run_ends", f"--{role}", "/etc/passwd", resumes="no")
        yield cell("never introduces itself", role, End(21, role, "did not introduce itself in 4 s"), "run_ends", f"--{role}", "sleep 100 #",
                   within=5, resumes="no")
    for what in ("file", "missing parent without permission"):
        yield cell("run directory unusable", what, End(11, "coupler", ""), "unusable_directory", what, resumes="no")
    yield cell("run directory in use", "by a living run", End(12, "coupler", "pid [0-9]+|process [0-9]+"), "second_run", resumes="no", needs=("--fault-plan",))
    yield cell("stale socket and lock", "of a dead run", CLEAN, "stale_files", resumes="no", needs=("--fault-plan", "resume"))
    yield cell("port in use", "tcp", End(12, "coupler", "[0-9]{4,5}"), "port_in_use", resumes="no")
    yield cell("few descriptors", "ulimit -n 12", End(11, "coupler", "descriptor|files"), "few_descriptors", 12, resumes="no")
    for name, environment in (("decimal comma", {"LC_ALL": "de_DE.UTF-8"}), ("time zone", {"TZ": "Asia/Kathmandu"}),
                              ("no home", {"HOME": None}), ("no language", {"LANG": None, "LC_ALL": None}), ("C locale", {"LC_ALL": "C"})):
        yield cell("odd surroundings", name, CLEAN, "odd_environment", *environment.items(), resumes="no")
    yield cell("odd surroundings", "wall clock jumps by minutes and years", CLEAN, "jumping_clock", resumes="no", needs=("c++",))
    yield cell("odd surroundings", "umask 077", CLEAN, "odd_umask", 0o077, resumes="no")
    yield cell("odd surroundings", "directory it was started in is gone", CLEAN, "vanished_directory", resumes="no")
    for stream in ("stdout", "stderr"):
        yield cell("reader of the log gone", stream, CLEAN, "broken_pipe", stream, resumes="no")
    for file in ("structure.state", "network.state", "network_neutral.state", "scheme.state", "record.state", "seismicity.state", "MANIFEST.json"):
        for how in ("flip", "truncate", "empty", "remove"):
            yield cell(f"checkpoint: {how}", f"newest {file}", CLEAN, "damaged_checkpoint", file, how, 1, needs=("--fault-plan", "resume"))
            yield cell(f"checkpoint: {how}", f"every {file}", End(27, "coupler", "checkpoint"), "damaged_checkpoint", file, how, 2, resumes="no",
                       needs=("--fault-plan", "resume"))
    yield cell("checkpoint: swapped", "structure and network", CLEAN, "swapped_states", needs=("--fault-plan", "resume"))
    yield cell("checkpoint: rotation", "the two newest, always", CLEAN, "rotation", resumes="no")
    for segment in (1, 4):
        for how in ("flip", "truncate", "empty", "remove"):
            yield cell(f"segment: {how}", f"segment {segment}", End(25, "coupler", "segments?/0*" + str(segment)), "damaged_segment", segment, how,
                       resumes="no", needs=("verify",))
    yield cell("limit on file size", "RLIMIT_FSIZE", End(25, "coupler", "large|limit|size"), "file_size_limit", 60000, within=5)
    yield cell("disk full", "tmpfs of 400 kB", End(25, "coupler", "space"), "small_disk", 400, within=5, resumes="no", needs=("unshare",))
    yield cell("run directory deleted", "in mid-run", End(25, "coupler", ""), "deleted_directory", within=5, resumes="no", needs=("--fault-plan",))
    yield cell("second network solver", "on the socket of a run", CLEAN, "intruder", "network", 12, resumes="no", needs=("--fault-plan",))
    yield cell("second structure", "on the socket of a run", CLEAN, "intruder", "structure", 12, resumes="no", needs=("--fault-plan",))
    for peer in ("random bytes", "silence", "greeting only", "forged identity", "huge frame", "many connections"):
        yield cell("hostile peer", peer, CLEAN, "hostile_peer", peer, resumes="no", needs=("--fault-plan",))


COMMANDS = ("WELCOME", "INSERT", "ADVANCE", "REPORT", "SAVE", "FINISH")
REPLIES = {"structure": ("HELLO", "TOPOLOGY", "ACKNOWLEDGE", "RESPONSE", "FIELDS", "STATE", "BYE"),
           "network": ("HELLO", "ACKNOWLEDGE", "PRESSURE", "FIELDS", "STATE", "BYE")}
LATER_MESSAGE = {"ADVANCE": {"interval": 33}, "RESPONSE": {"interval": 33}, "PRESSURE": {"interval": 33}, "INSERT": {"occurrence": 5},
                 "ACKNOWLEDGE": {"occurrence": 5}, "STATE": {"occurrence": 5}}


@dataclasses.dataclass(frozen=True)
class MessageRow:
    """A fault on the way between the coupler and a participant."""
    name: str
    do: dict
    code: str = "22"
    says: str = ""
    within: float = 0.5
    types: tuple = ()    # only these
    without: tuple = ()  # not these
    exceptions: tuple = ()  # (type, code): where another end is right


# The last word of a conversation: nothing comes after it that could tell.
LAST_WORDS = ("FINISH", "BYE")
LOST = "21|22"  # found by the next message of that direction, or by the deadline if none comes
# Before its HELLO a peer has no name: that it was refused is said when the participant ends, or does not introduce itself in time.
NOT_KNOWN_YET = (("HELLO", "21|22"),)
MESSAGE_ROWS = (
    MessageRow("lost message", {"do": "drop"}, LOST, within=5),
    MessageRow("message twice", {"do": "duplicate"}, "22", r"came twice|already|not expected|no answer|twice|again|state", without=("BYE", "FINISH")),
    MessageRow("messages in another order", {"do": "swap"}, LOST, within=5, without=LAST_WORDS + ("HELLO",)),
    MessageRow("late message", {"do": "delay", "seconds": 0.4}, "0"),
    MessageRow("too late message", {"do": "delay", "seconds": 8}, "21", SILENT, within=6, types=("WELCOME", "ADVANCE", "INSERT", "RESPONSE", "PRESSURE",
                                                                                      "ACKNOWLEDGE", "HELLO", "FINISH", "BYE", "STATE")),
    MessageRow("clogged for a moment", {"do": "clog", "seconds": 0.4}, "0", types=("ADVANCE", "INSERT", "RESPONSE", "PRESSURE", "STATE", "BYE")),
    MessageRow("cut short", {"do": "truncate"}, "22", within=5, exceptions=NOT_KNOWN_YET),
    MessageRow("envelope cut short", {"do": "truncate", "frame": 0, "bytes": 7}, "22", within=5, exceptions=NOT_KNOWN_YET),
    MessageRow("bit flipped in the envelope", {"do": "flip", "frame": 0, "bit": 200}, "22", within=5, exceptions=NOT_KNOWN_YET),
    MessageRow("bit flipped in the body", {"do": "flip", "frame": 1, "bit": 3}, "22", within=5, exceptions=NOT_KNOWN_YET),
    MessageRow("bit flipped at the end", {"do": "flip", "bit": 1}, "22", within=5, exceptions=NOT_KNOWN_YET),
    MessageRow("from another run", {"do": "restamp", "stamp": "run", "shift": 1}, "22", "another run|run", without=("HELLO", "WELCOME")),
    MessageRow("from another epoch", {"do": "restamp", "stamp": "epoch", "shift": 1}, "22", "epoch", without=("HELLO", "WELCOME")),
    MessageRow("sequence number gap", {"do": "restamp", "stamp": "sequence", "shift": 3}, "22", "lost", within=5, exceptions=NOT_KNOWN_YET),
    MessageRow("type unknown", {"do": "restamp", "stamp": "type", "value": 99}, "22", "type|99|UNKNOWN|unknown", within=5, exceptions=NOT_KNOWN_YET),
    MessageRow("type out of place", {"do": "restamp", "stamp": "type", "value": 42}, "22", "", without=("HELLO",)),
    MessageRow("another major version", {"do": "restamp", "stamp": "major", "shift": 1}, "13|22", "version|protocol"),
    MessageRow("a higher minor version", {"do": "restamp", "stamp": "minor", "shift": 1}, "0"),
    MessageRow("for another topology", {"do": "restamp", "stamp": "revision", "shift": 1}, "22", "revision", types=("ADVANCE", "RESPONSE", "PRESSURE", "FIELDS", "ACKNOWLEDGE")),
    MessageRow("for another interval", {"do": "restamp", "stamp": "interval", "shift": 1}, "22", "interval", types=("RESPONSE", "PRESSURE", "FIELDS", "ACKNOWLEDGE", "STATE")),
    MessageRow("old message again", {"do": "replay", "back": 1}, "22", "", types=("ADVANCE", "RESPONSE", "PRESSURE", "INSERT", "ACKNOWLEDGE", "STATE")),
    MessageRow("connection cut", {"do": "cut"}, "20|21", "connection|closed", within=1),
    MessageRow("one direction dead", {"do": "half_open"}, LOST, within=5, types=("WELCOME", "ADVANCE", "INSERT", "RESPONSE", "PRESSURE", "ACKNOWLEDGE", "STATE", "SAVE")),
    MessageRow("too large", {"do": "oversize", "bytes": 900_000_000}, "20|21|22", "", within=5, types=("ADVANCE", "RESPONSE", "PRESSURE", "HELLO", "STATE")),
    MessageRow("nonsense before it", {"do": "nonsense", "bytes": 1000}, "22", exceptions=NOT_KNOWN_YET),
)
ARRAYS = {"ADVANCE": {"network": ("aperture", "compliance"), "structure": ("pressure_begin", "pressure_end")},
          "PRESSURE": {"network": ("pressure", "aperture_predicted", "filled")}, "RESPONSE": {"structure": ("aperture", "pressure_applied")},
          "ACKNOWLEDGE": {"structure": ("aperture",)}}


def message_slots(role):
    """(place, words for the plan, type) for each kind of message of that participant, at its first time and later."""
    for direction, types in (("to_participant", COMMANDS), ("to_coupler", REPLIES[role])):
        for kind in types:
            words = {"table": "message", "role": role, "direction": direction, "type": kind}
            yield f"{role} {kind}", words, kind
            if kind in LATER_MESSAGE:
                yield f"{role} {kind} later", {**words, **LATER_MESSAGE[kind]}, kind


def message_cells():
    needs = ("--fault-plan", "program:fault_proxy")
    for row in MESSAGE_ROWS:
        for role in PARTICIPANTS:
            for place, words, kind in message_slots(role):
                if (row.types and kind not in row.types) or kind in row.without:
                    continue
                code = dict(row.exceptions).get(kind, row.code)
                end = CLEAN if code == "0" else End(code, "structure|network|coupler", row.says if code == row.code else "")
                yield Cell(row.name, place, end, faults=({**words, **row.do},), within=row.within, resumes="no" if code == "0" else "same bytes",
                           needs=needs)
    for role in PARTICIPANTS:
        for place, words, kind in message_slots(role):
            for field in ARRAYS.get(kind, {}).get(role, ()):
                for name, value in (("not a number", "nan"), ("infinite", "inf"), ("absurd", "-1e9")):
                    # A pressure far below zero, an aperture of minus a thousand kilometres, a filling or a compliance below zero.
                    yield Cell(f"value on the way: {name}", f"{place} {field}", End("22|23", "structure|network|coupler", field.split("_")[0]),
                               faults=({**words, "do": "poison", "field": field, "index": 0, "value": Bare(value)},), needs=needs)
                yield Cell("array in another unit", f"{place} {field}", End(13, "structure|network|coupler", f'{field} must be in "'),
                           faults=({**words, "do": "relabel", "field": field, "unit": "furlong"},), needs=needs)
                yield Cell("array of another length", f"{place} {field}", End(22, "structure|network|coupler", ""),
                           faults=({**words, "do": "resize", "field": field, "length": 1},), needs=needs)


class Bare(str):
    """A word of TOML that is no text."""


def all_cells():
    cells = []
    for group in (process_cells, resume_cells, together_cells, signal_cells, value_cells, storage_cells, message_cells, script_cells):
        cells += list(group())
    return cells


def short_cells(cells, number=100):
    """About `number` cells spread over all rows: of each row the first, then evenly through the rest."""
    rows = {}
    for cell in cells:
        rows.setdefault(cell.row, []).append(cell)
    chosen, turn = [], 0
    while len(chosen) < min(number, len(cells)):
        for row in rows.values():
            # Not always the same point of a row: walk through it with a stride that meets all of it.
            index = (turn * 7 + 3 * len(chosen)) % len(row)
            for offset in range(len(row)):
                cell = row[(index + offset) % len(row)]
                if cell not in chosen:
                    chosen.append(cell)
                    break
            if len(chosen) == number:
                break
        turn += 1
    return chosen


SIGNALS = {name: getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGUSR1", "SIGKILL", "SIGCONT", "SIGSTOP", "SIGILL")}
