# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells of the fault matrix that are no fault of a process at work: start-up, surroundings, files, foreign peers. Each function plays one cell:
(cell, clean, home, played) -> None; what is wrong goes to `played`."""
import calendar
import json
import os
import pathlib
import resource
import signal
import socket
import struct
import subprocess
import time

import fault_matrix as matrix
from fault_run import COUPLER, PROGRAMS, ROOT, Watched, differences, has_command, results, resume, run_command

CHECKPOINTS = {"checkpoint.intervals": 5}


class Skip(Exception):
    """The machine has not what the cell needs."""


def values(cell):
    return {**CHECKPOINTS, **dict(cell.values)}


def finish(run, cell, clean, home, played, patience=40):
    """Waits for the end and judges it."""
    try:
        played.code = run.finish(patience)
        if played.code is None:
            played.wrong("hang", f"living: {run.members()}; said: {run.errors[-300:]}")
            return
        matrix.judge_end(played, run, home)
        matrix.judge_times(played, run, None)
        if sockets := home.sockets():
            played.wrong("socket", ", ".join(sockets))
        if cell.end.code == 0 and played.code == 0 and (wrong := differences(results(home.run), clean.files)):
            played.wrong("bytes", "other bytes in " + ", ".join(wrong))
    finally:
        run.clear()


def run_ends(cell, clean, home, played):
    finish(Watched(run_command(home.run, *cell.arguments, **values(cell)), home), cell, clean, home, played)


def unusable_directory(cell, clean, home, played):
    if cell.arguments[0] == "file":
        home.run.write_text("")
        directory = home.run
    else:
        locked = pathlib.Path("/proc/fissura")  # nobody may create anything there, root included
        directory = locked / "run"
    finish(Watched(run_command(directory, **values(cell)), home), cell, clean, home, played)


def held_run(home, cell, role="network", interval=20):
    """A run that is stopped in the middle. Whoever calls lets it go on by SIGCONT."""
    fault = {"role": role, "phase": "advance", "interval": interval, "do": "stop"}
    run = Watched(run_command(home.run, "--fault-plan", home.plan((fault,)), **{**values(cell), "deadlines.progress": "10 s"}), home)
    if not run.until(lambda: run.stopped(role) or run.ended(), 20) or run.ended():
        errors = run.errors
        run.clear()
        raise RuntimeError("the run could not be held: " + errors[-300:])
    return run


def go_on(run, role="network"):
    run.send(role, signal.SIGCONT)


def second_run(cell, clean, home, played):
    first = held_run(home, cell)
    second = Watched(run_command(home.run), home)
    try:
        played.code = second.finish(10)
        go_on(first)
        matrix.judge_end(played, second, home)
        if first.finish(40) != 0 or differences(results(home.run), clean.files):
            played.wrong("bytes", "the first run was disturbed: " + first.errors[-300:])
    finally:
        second.clear()
        first.clear()


def stale_files(cell, clean, home, played):
    """What a machine that went down leaves behind is taken over."""
    killed_run(cell, home)
    (home.run / "lock").write_text("4194303\n")
    (home.run / "coupler.ipc").unlink(missing_ok=True)
    with socket.socket(socket.AF_UNIX) as dead:
        dead.bind(str(home.run / "coupler.ipc"))
    resumed(cell, clean, home, played)


def port_in_use(cell, clean, home, played):
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        endpoint = f"tcp://127.0.0.1:{other.getsockname()[1]}"
        finish(Watched(run_command(home.run, **{**values(cell), "exchange.endpoint": endpoint}), home), cell, clean, home, played)


def few_descriptors(cell, clean, home, played):
    command = ["sh", "-c", f"ulimit -n {cell.arguments[0]}; exec \"$@\"", "sh", *run_command(home.run, **values(cell))]
    finish(Watched(command, home), cell, clean, home, played)


def odd_environment(cell, clean, home, played):
    removed = [name for name, value in cell.arguments if value is None]
    changed = {name: value for name, value in cell.arguments if value is not None}
    command = ["env", *(word for name in removed for word in ("-u", name)), *run_command(home.run, **values(cell))]
    finish(Watched(command, home, changed), cell, clean, home, played)


def jumping_clock(cell, clean, home, played):
    shim = home.path / "jumping_clock.so"
    subprocess.run(["c++", "-O1", "-shared", "-fPIC", "-o", shim, ROOT / "tests/system/jumping_clock.cpp"], check=True)
    finish(Watched(run_command(home.run, **values(cell)), home, {"LD_PRELOAD": str(shim)}), cell, clean, home, played)
    started = json.loads((home.run / "run.json").read_text())["started"]
    if abs(time.time() - calendar.timegm(time.strptime(started, "%Y-%m-%dT%H:%M:%SZ"))) < 200:
        played.wrong("error", f"the clock of the run did not jump: it started at {started}")


def odd_umask(cell, clean, home, played):
    command = ["sh", "-c", f"umask {cell.arguments[0]:03o}; exec \"$@\"", "sh", *run_command(home.run, **values(cell))]
    finish(Watched(command, home), cell, clean, home, played)


def vanished_directory(cell, clean, home, played):
    folder = home.path / "gone"
    folder.mkdir()
    command = ["sh", "-c", f"rmdir '{folder}'; exec \"$@\"", "sh", *run_command(home.run, **values(cell))]
    finish(Watched(command, home, cwd=folder), cell, clean, home, played)


def broken_pipe(cell, clean, home, played):
    redirect = "2>&1 1>/dev/null | head -c 1 >/dev/null" if cell.arguments[0] == "stderr" else "| head -c 1 >/dev/null"
    command = ["bash", "-c", f'set -o pipefail; "$@" {redirect}; exit ${{PIPESTATUS[0]}}', "bash", *run_command(home.run, **values(cell))]
    finish(Watched(command, home), cell, clean, home, played)


def damage(file, how):
    if how == "remove":
        file.unlink()
    elif how == "empty":
        file.write_bytes(b"")
    else:
        content = bytearray(file.read_bytes())
        if how == "truncate":
            content = content[:len(content) // 2]
        else:
            content[len(content) // 2] ^= 0x10
        file.write_bytes(bytes(content))


def killed_run(cell, home, interval=43):
    fault = {"role": "network", "phase": "advance", "interval": interval, "do": "kill"}
    run = Watched(run_command(home.run, "--fault-plan", home.plan((fault,)), **values(cell)), home)
    code = run.finish(40)
    run.clear()
    if code != 20:
        raise RuntimeError(f"the run to be resumed ended with {code}: {run.errors[-300:]}")


def checkpoints(home):
    return sorted(path for path in (home.run / "checkpoints").iterdir() if path.name.isdigit())


def resumed(cell, clean, home, played):
    run = Watched([COUPLER, "resume", home.run], home)
    finish(run, cell, clean, home, played)
    return run


def damaged_checkpoint(cell, clean, home, played):
    file, how, number = cell.arguments
    killed_run(cell, home)
    found = checkpoints(home)
    if len(found) != 2:
        played.wrong("error", f"{len(found)} checkpoints are kept instead of 2")
    for folder in found[-number:]:
        damage(folder / file, how)
    run = resumed(cell, clean, home, played)
    if number == 1 and found[-1].name.lstrip("0") not in run.errors:
        played.wrong("sentence", "nothing was said about the damaged checkpoint: " + run.errors[-300:])


def swapped_states(cell, clean, home, played):
    killed_run(cell, home)
    newest = checkpoints(home)[-1]
    a, b, between = newest / "structure.state", newest / "network.state", newest / "between"
    a.rename(between)
    b.rename(a)
    between.rename(b)
    resumed(cell, clean, home, played)


def rotation(cell, clean, home, played):
    run = Watched(run_command(home.run, **{**values(cell), "checkpoint.intervals": 3}), home)
    kept = set()

    def look():
        try:
            kept.add(tuple(int(path.name) for path in checkpoints(home) if (path / "MANIFEST.json").exists()))
        except OSError:
            pass
        return run.ended()

    run.until(look, 40)
    finish(run, cell, clean, home, played)
    wrong = [numbers for numbers in kept if len(numbers) > 3 or any(b - a != 3 for a, b in zip(numbers, numbers[1:]))]
    if wrong or len(kept) < 3:
        played.wrong("error", f"checkpoints seen: {sorted(kept)}")


def damaged_segment(cell, clean, home, played):
    number, how = cell.arguments
    run = Watched(run_command(home.run), home)
    if run.finish(40) != 0:
        raise RuntimeError("the run to be verified failed: " + run.errors[-300:])
    run.clear()
    damage(home.run / f"segments/{number:06d}.h5", how)
    answer = subprocess.run([COUPLER, "verify", home.run], capture_output=True, text=True)
    played.code, said = answer.returncode, answer.stdout + answer.stderr
    played.line = said.strip().splitlines()[-1] if said.strip() else ""
    if played.code != cell.end.code:
        played.wrong("code", f"verify ends with {played.code} instead of {cell.end.code}: {said[-300:]}")
    if f"{number:06d}" not in said:
        played.wrong("sentence", f"the segment is not named: {said[-300:]}")


def file_size_limit(cell, clean, home, played):
    command = ["sh", "-c", f"ulimit -f {cell.arguments[0] // 512}; exec \"$@\"", "sh", *run_command(home.run, **values(cell))]
    finish(Watched(command, home), cell, clean, home, played)
    if has_command("resume") and played.code_fits() and (problem := resume(home, clean)):
        played.wrong("resume", problem)


def small_disk(cell, clean, home, played):
    home.run.mkdir()
    inner = f"mount -t tmpfs -o size={cell.arguments[0]}k none '{home.run}' && exec \"$@\""
    if subprocess.run(["unshare", "-rm", "sh", "-c", "mount -t tmpfs none /mnt"], capture_output=True).returncode != 0:
        raise Skip("no private mounts (unshare -rm)")
    run = Watched(["unshare", "-rm", "sh", "-c", inner, "sh", *run_command(home.run, **values(cell))], home)
    try:
        played.code = run.finish(40)
        matrix.judge_end(played, run, home)
    finally:
        run.clear()


def deleted_directory(cell, clean, home, played):
    run = held_run(home, cell)
    subprocess.run(["rm", "-rf", home.run], check=True)
    go_on(run)
    finish(run, cell, clean, home, played)


def dies_while_resuming(cell, clean, home, played):
    """Life 0 is killed, life 1 dies at the point of the cell, life 2 ends well. The checkpoint is the same before and after life 1."""
    plan = home.plan(cell.faults)
    first = Watched(run_command(home.run, "--fault-plan", plan, **values(cell)), home)
    code = first.finish(40)
    first.clear()
    if code != 20:
        raise RuntimeError(f"the first life ended with {code}: {first.errors[-300:]}")
    before = {path: path.read_bytes() for folder in checkpoints(home) for path in folder.iterdir()}
    second = Watched([COUPLER, "resume", home.run], home, {"FISSURA_FAULT_PLAN": str(plan)})
    finish(second, cell, clean, home, played)
    if {path: path.read_bytes() for folder in checkpoints(home) for path in folder.iterdir()} != before:
        played.wrong("bytes", "the checkpoints are not those of before")
    if played.code_fits() and (problem := resume(home, clean)):
        played.wrong("resume", problem)


def intruder(cell, clean, home, played):
    """Another solver claims a role that is held: refused with a sentence, and the run does not notice."""
    role, code = cell.arguments
    run = held_run(home, cell)
    second = Watched([PROGRAMS / role, "--connect", f"ipc://{home.run}/coupler.ipc"], home)
    try:
        run.until(lambda: second.process.poll() is not None, 0.8)
        go_on(run)
        found = second.finish(10)
        if found != code:
            played.wrong("code", f"the intruder ends with {found} instead of {code}: {second.errors[-300:]}")
        if not second.errors:
            played.wrong("sentence", "the intruder is told nothing")
        finish(run, cell, clean, home, played)
    finally:
        second.clear()
        run.clear()


GREETING = b"\xff\0\0\0\0\0\0\0\0\x7f\x03\0" + b"NULL".ljust(20, b"\0") + b"\0" + bytes(31)


def ready(identity):
    def word(name, value):
        return bytes([len(name)]) + name + struct.pack(">I", len(value)) + value

    body = b"\x05READY" + word(b"Socket-Type", b"DEALER") + word(b"Identity", identity)
    return bytes([4, len(body)]) + body


def hostile_peer(cell, clean, home, played):
    """A stranger on the loopback port of a run: whatever it sends, the results do not change by a bit."""
    kind = cell.arguments[0]
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    fault = {"role": "network", "phase": "advance", "interval": 20, "do": "stop"}
    run = Watched(run_command(home.run, "--fault-plan", home.plan((fault,)),
                              **{**values(cell), "exchange.endpoint": f"tcp://127.0.0.1:{port}", "deadlines.progress": "10 s"}), home)
    peers = []
    try:
        if not run.until(lambda: run.stopped("network") or run.ended(), 20) or run.ended():
            raise RuntimeError("the run could not be held: " + run.errors[-300:])
        begin = time.monotonic()
        for _ in range(500 if kind == "many connections" else 1):
            if time.monotonic() - begin > 0.5:
                break  # the network must not stay stopped for long
            try:
                peer = socket.create_connection(("127.0.0.1", port), timeout=0.3)
            except OSError:
                break  # as many as are let in
            peer.setblocking(False)
            peers.append(peer)
        said = {"random bytes": os.urandom(100_000), "silence": b"", "greeting only": GREETING,
                "forged identity": GREETING + ready(b"network") + b"\0\x10" + bytes(16),
                "huge frame": GREETING + ready(b"x") + b"\x02" + struct.pack(">Q", 8 << 30), "many connections": b""}[kind]
        try:
            peers[0].send(said)
        except OSError:
            pass
        time.sleep(0.3)
        go_on(run)
        finish(run, cell, clean, home, played)
    finally:
        for peer in peers:
            peer.close()
        run.clear()
