#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A participant that greets properly and answers its first ADVANCE wrongly: misbehaving_network.py KIND --connect ENDPOINT."""
import argparse
import json
import os
import struct
import time
import zlib

import zmq

ENVELOPE = struct.Struct("<4sBBH16sIIQQQII")
HELLO, WELCOME, INSERT, ACKNOWLEDGE, ADVANCE, PRESSURE = 1, 2, 11, 12, 20, 21
KINDS = ("garbage", "damaged", "lost", "doubled", "foreign", "stale", "wrong-type", "wrong-length", "wrong-revision",
         "wrong-hash", "negative-aperture", "absurd-pressure", "unconverged", "leaking", "silent", "other-version", "unclaimed")
UNITS = {"pressure": "Pa", "aperture_predicted": "m"}


class Sender:
    def __init__(self, socket):
        self.socket, self.run, self.sequence = socket, bytes(16), 0

    def frames(self, kind, body, arrays=(), interval=0, revision=0, run=None, major=1):
        data = [struct.pack(f"<{len(v)}d", *v) for _, v in arrays]
        body = dict(body, arrays=[dict(name=n, dtype="float64", shape=[len(v)], unit=UNITS.get(n, "1")) for n, v in arrays])
        text = json.dumps(body).encode()
        head = ENVELOPE.pack(b"FIS1", major, 0, kind, run or self.run, 0, len(data), self.sequence, interval, revision,
                             len(text), 0)[:60]
        self.sequence += 1
        return [head + struct.pack("<I", zlib.crc32(b"".join([head, text, *data]))), text, *data]

    def send(self, *arguments, **named):
        self.socket.send_multipart(self.frames(*arguments, **named))


def answer(sender, kind, body, count, interval, revision):
    """PRESSURE of a fluid that stays where it is, spoilt in one way."""
    ledger = dict(injected=0, in_place=0, in_fractures=0, leaked=0, reset=0, residual=0)
    newton = dict(converged=True, iterations=1, residual=0, halvings=0)
    pressure, aperture, filled = [0.0] * count, [0.0] * count, [0.0] * count
    if kind == "garbage":
        sender.socket.send_multipart([b"nonsense", b"more nonsense"])
        return
    if kind == "silent":
        time.sleep(1000)
    if kind == "lost":
        sender.sequence += 1
    if kind == "stale":
        sender.sequence -= 1
    if kind == "wrong-length":
        pressure.append(0.0)
    if kind == "wrong-revision":
        revision += 1
    if kind == "negative-aperture":
        aperture[0] = -1e-3
    if kind == "absurd-pressure":
        pressure[0] = 1e12
    if kind == "unconverged":
        newton["converged"] = False
    if kind == "leaking":
        ledger["injected"] = 1.0
    run = bytes(range(16)) if kind == "foreign" else None
    frames = sender.frames(999 if kind == "wrong-type" else PRESSURE,
                           dict(ledger=ledger, newton=newton, well_pressure=0.0, rate=0.0),
                           [("pressure", pressure), ("aperture_predicted", aperture), ("filled", filled)],
                           interval, revision, run, 2 if kind == "other-version" else 1)
    if kind == "damaged":
        frames[2] = bytes([frames[2][0] ^ 1]) + frames[2][1:]
    sender.socket.send_multipart(frames)
    if kind == "doubled":
        sender.socket.send_multipart(frames)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("kind", choices=KINDS)
    parser.add_argument("--connect", required=True)
    options = parser.parse_args()
    socket = zmq.Context.instance().socket(zmq.DEALER)
    socket.setsockopt(zmq.RECONNECT_IVL, -1)
    socket.connect(options.connect)
    sender = Sender(socket)
    claims = dict(physics=["viscous_flow"]) if options.kind == "unclaimed" else {}
    sender.send(HELLO, dict(role="network", solver="misbehaving", version="1", pid=os.getpid(), capabilities=[], **claims))
    nodes = 0
    while socket.poll(60000):
        frames = socket.recv_multipart()
        _, _, _, kind, run, _, _, _, interval, revision, _, _ = ENVELOPE.unpack(frames[0])
        body = json.loads(frames[1])
        if kind == WELCOME:
            sender.run = run
        elif kind == INSERT:
            nodes += len(body["insertion"]["new_nodes"])
            # The hash of revision 0 is left to the real solvers; this one only has to reach its first ADVANCE.
            hash_text = topology_hash(body["insertion"]) if options.kind != "wrong-hash" else "0" * 64
            sender.send(ACKNOWLEDGE, dict(hash=hash_text), (), interval, revision)
        elif kind == ADVANCE:
            answer(sender, options.kind, body, nodes, interval, revision)


def topology_hash(insertion):
    import hashlib
    content = struct.pack("<Q", insertion["revision"])
    for n in insertion["new_nodes"]:
        content += struct.pack("<QdddQQ", n["id"], n["x"], n["y"], n["lumped_length"], n["fracture"], n["role"])
    for s in insertion["new_segments"]:
        content += struct.pack("<QQQd", s["id"], s["node_a"], s["node_b"], s["length"])
    return hashlib.sha256(content).hexdigest()


if __name__ == "__main__":
    main()
