#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stands between the conformance kit and a flow solver and breaks one promise of the contract in its name:

deviating_relay.py KIND PROGRAM --connect ENDPOINT
"""
import array
import ctypes
import json
import math
import signal
import struct
import subprocess
import sys
import tempfile
import zlib

import zmq

ENVELOPE = struct.Struct("<4sBBH16sIIQQQII")
HELLO, ACKNOWLEDGE, PRESSURE, BYE, FAIL, WELCOME, ADVANCE, PROGRESS = 1, 12, 21, 51, 60, 2, 20, 61
MAJOR, TYPE, RUN, EPOCH, SEQUENCE, REVISION, CRC = 1, 3, 4, 5, 7, 9, 11


class Message:
    def __init__(self, frames):
        self.fields, self.body, self.arrays = list(ENVELOPE.unpack(frames[0])), frames[1], frames[2:]

    @property
    def kind(self):
        return self.fields[TYPE]

    def edit(self, change):
        body = json.loads(self.body)
        change(body)
        self.body = json.dumps(body).encode()

    def frames(self):
        """With a checksum and a length that fit."""
        self.fields[10] = len(self.body)
        head = ENVELOPE.pack(*self.fields)[:60]
        return [head + struct.pack("<I", zlib.crc32(b"".join([head, self.body, *self.arrays]))), self.body, *self.arrays]


def lose(body):
    ledger = body["ledger"]
    ledger["in_fractures"] *= 0.999
    ledger["residual"] = (ledger["injected"] + ledger["in_place"] + ledger.get("found", 0) + ledger["reset"]
                          - ledger["in_fractures"] - ledger["leaked"])


def finite(frame):
    return array.array("d", [v if math.isfinite(v) else 0.0 for v in array.array("d", frame)]).tobytes()


class Relay:
    def __init__(self, kind):
        self.kind, self.hash, self.resumes, self.heard = kind, None, False, 0

    def to_solver(self, frames):
        if len(frames) < 2 or len(frames[0]) != ENVELOPE.size:
            return frames
        message = Message(frames)
        if message.kind == WELCOME:
            self.resumes = json.loads(message.body).get("resumes", False)
        if self.kind == "takes-any-version":
            message.fields[MAJOR] = 1
        elif self.kind == "forgives-gaps":
            message.fields[SEQUENCE], self.heard = self.heard, self.heard + 1
        elif self.kind == "swallows-nan" and message.kind == ADVANCE:
            message.arrays = [finite(frame) for frame in message.arrays]
        elif self.kind != "takes-damaged":
            return frames
        return message.frames()

    def to_coupler(self, frames):
        message = Message(frames)
        if self.kind == "stale-revision" and message.kind in (ACKNOWLEDGE, PRESSURE):
            message.fields[REVISION] = 0
        elif self.kind == "old-hash" and message.kind == ACKNOWLEDGE:
            self.hash = self.hash or json.loads(message.body)["hash"]
            message.edit(lambda body: body.update(hash=self.hash))
        elif self.kind == "loses-fluid" and message.kind == PRESSURE:
            message.edit(lose)
        elif self.kind == "restores-roughly" and message.kind == PRESSURE and self.resumes:
            message.arrays[0] = array.array("d", [v * (1 + 1e-15) for v in array.array("d", message.arrays[0])]).tobytes()
        elif self.kind == "silent-about-figures" and message.kind == BYE:
            message.edit(lambda body: body.pop("figures"))
        elif self.kind == "deaf" and message.kind == PROGRESS:
            message.edit(lambda body: body.pop("stop_signal", None))
        elif self.kind == "keeps-neutral-state" and message.kind == HELLO:
            message.edit(lambda body: body["capabilities"].remove("neutral_state"))
        elif self.kind == "gives-no-reason" and message.kind == FAIL:
            message.edit(lambda body: body.pop("reason"))
        else:
            return frames
        return message.frames()


def main():
    kind, program, endpoint = sys.argv[1], sys.argv[2], sys.argv[sys.argv.index("--connect") + 1]
    context, relay = zmq.Context.instance(), Relay(kind)
    outside, inside = context.socket(zmq.DEALER), context.socket(zmq.DEALER)
    outside.setsockopt(zmq.RECONNECT_IVL, -1)
    monitor = outside.get_monitor_socket(zmq.EVENT_DISCONNECTED)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with tempfile.TemporaryDirectory() as folder:
        inside.bind(f"ipc://{folder}/relay")
        outside.connect(endpoint)
        solver = subprocess.Popen([program, "--connect", f"ipc://{folder}/relay"])
        signal.signal(signal.SIGTERM, lambda *_: solver.send_signal(signal.SIGTERM))
        poller = zmq.Poller()
        for socket in (outside, inside, monitor):
            poller.register(socket, zmq.POLLIN)
        while solver.poll() is None:
            ready = dict(poller.poll(50))
            if outside in ready:
                inside.send_multipart(relay.to_solver(outside.recv_multipart()))
            if inside in ready:
                outside.send_multipart(relay.to_coupler(inside.recv_multipart()))
            if monitor in ready and kind != "stays":
                poller.unregister(monitor)
                inside.close()  # the solver sees what the relay sees
                poller.unregister(inside)
                solver.wait()
        while not inside.closed and inside.poll(0):
            outside.send_multipart(relay.to_coupler(inside.recv_multipart()))
        outside.poll(300)  # the last word must still find the kit
    return 1 if kind == "ends-with-one" and solver.returncode else solver.returncode


if __name__ == "__main__":
    ctypes.CDLL(None).prctl(1, 15)  # PR_SET_PDEATHSIG
    sys.exit(main())
