#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""flow_solver.py, but it acknowledges the growth of revision 3 without taking it over."""
import ctypes
import sys

from flow_solver import Channel, FlowSolver, serve


class ForgetfulFlowSolver(FlowSolver):
    last_hash = ""

    def insert(self, change):
        if change["revision"] != 3:
            self.last_hash = super().insert(change)
        return self.last_hash


if __name__ == "__main__":
    ctypes.CDLL(None).prctl(1, 9)  # PR_SET_PDEATHSIG
    serve.__globals__["FlowSolver"] = ForgetfulFlowSolver
    sys.exit(serve(Channel(sys.argv[sys.argv.index("--connect") + 1])))
