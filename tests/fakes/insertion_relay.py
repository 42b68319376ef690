#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stands between the coupler and a participant and disturbs the first growth of the fractures on its way:

insertion_relay.py lost|doubled|late|faithful PROGRAM --connect ENDPOINT
"""
import ctypes
import struct
import subprocess
import sys
import tempfile

import zmq

ENVELOPE = struct.Struct("<4sBBH16sIIQQQII")
INSERT, TYPE, REVISION = 11, 3, 9


def deliveries(kind, frames, held):
    """What the participant gets when `frames` arrive; `held` are messages kept back so far."""
    fields = ENVELOPE.unpack(frames[0])
    if fields[TYPE] == INSERT and fields[REVISION] == 1:
        if kind == "lost":
            return []
        if kind == "doubled":
            return [frames, frames]
        if kind == "late":
            held.append(frames)
            return []
    late, held[:] = list(held), []
    return [frames, *late]


def main():
    kind, program, endpoint = sys.argv[1], sys.argv[2], sys.argv[sys.argv.index("--connect") + 1]
    context, held = zmq.Context.instance(), []
    outside, inside = context.socket(zmq.DEALER), context.socket(zmq.DEALER)
    outside.setsockopt(zmq.RECONNECT_IVL, -1)
    with tempfile.TemporaryDirectory() as folder:
        inside.bind(f"ipc://{folder}/relay")
        outside.connect(endpoint)
        participant = subprocess.Popen([program, "--connect", f"ipc://{folder}/relay"])
        poller = zmq.Poller()
        poller.register(outside, zmq.POLLIN)
        poller.register(inside, zmq.POLLIN)
        while participant.poll() is None:
            ready = dict(poller.poll(50))
            if outside in ready:
                for frames in deliveries(kind, outside.recv_multipart(), held):
                    inside.send_multipart(frames)
            if inside in ready:
                outside.send_multipart(inside.recv_multipart())
        while inside.poll(0):
            outside.send_multipart(inside.recv_multipart())
        outside.poll(500)  # the last word must still find the coupler
    return participant.returncode


if __name__ == "__main__":
    ctypes.CDLL(None).prctl(1, 15)  # PR_SET_PDEATHSIG
    sys.exit(main())
