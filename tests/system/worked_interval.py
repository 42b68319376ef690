#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks a flow solver for the worked intervals of docs/flow_solvers.md, section 7, and prints its answers beside those
of the page: worked_interval.py COMMAND. Exit code 0: they agree within the digits printed. A solver that takes more
than one step per interval will be off by its own error in time."""
import array, json, pathlib, struct, subprocess, sys, tempfile, zlib
import zmq

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "flow_solvers.md"
ENVELOPE = struct.Struct("<4sBBH16sIIQQQII")
WELCOME, INSERT, ADVANCE, FAIL, PROGRESS = 2, 11, 20, 60, 61
UNITS = {"aperture": "m", "aperture_rate": "m/s", "reference_pressure": "Pa", "compliance": "m/Pa", "closed": "1"}
PATIENCE, PRINTED = 10, 1e-6  # [s]; relative


def tables():
    """{"7a": [{column: cell}, ...]}"""
    found, number = {}, None
    for line in PAGE.read_text().splitlines():
        if line.startswith("Table "):
            number, names = line[6:].split(":")[0], None
        elif line.startswith("|") and number:
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if names is None:
                names, found[number] = cells, []
            elif not cells[0].startswith("---"):
                found[number].append(dict(zip(names, cells)))
        elif line.startswith("#"):
            number = None
    return found


class Coupler:
    def __init__(self, command, folder):
        self.socket = zmq.Context.instance().socket(zmq.ROUTER)
        endpoint = f"ipc://{folder}/socket"
        self.socket.bind(endpoint)
        self.process = subprocess.Popen(f"{command} --connect {endpoint}", shell=True)
        self.sent, self.peer = 0, None
        self.hear()

    def say(self, kind, body, arrays={}, interval=0, revision=0):
        frames = [array.array("d", values).tobytes() for values in arrays.values()]
        names = [dict(name=n, dtype="float64", shape=[len(v)], unit=UNITS[n]) for n, v in arrays.items()]
        text = json.dumps(dict(body, arrays=names)).encode()
        fields = (kind, b"worked interval.", 0, len(frames), self.sent, interval, revision, len(text), 0)
        head = ENVELOPE.pack(b"FIS1", 1, 1, *fields)[:60]
        checksum = struct.pack("<I", zlib.crc32(b"".join([head, text, *frames])))
        self.socket.send_multipart([self.peer, head + checksum, text, *frames])
        self.sent += 1

    def hear(self):
        while self.socket.poll(1000 * PATIENCE):
            self.peer, head, text, *frames = self.socket.recv_multipart()
            kind, body = ENVELOPE.unpack(head)[3], json.loads(text)
            if kind == FAIL:
                sys.exit(f"the solver says FAIL {body['exit_code']}: {body['reason']}")
            if kind != PROGRESS:
                declared = zip(body.get("arrays", []), frames)
                return body, {e["name"]: list(array.array("d", f)) for e, f in declared if e["dtype"] == "float64"}
        sys.exit(f"the solver says nothing for {PATIENCE} s")

    def end(self):
        self.say(FAIL, dict(role="coupler", phase="worked interval", reason="that was all", exit_code=0))
        self.process.wait(PATIENCE)


def the_case(table):
    value = {row["what"]: float(row["value"]) for row in table}
    fluid = dict(name="fluid", consistency_index=value["mu"], power_index=1.0, bulk_modulus=value["K_f"])
    stage = dict(begin=0.0, control="rate", rate=value["rate"], ramp=0.0, pressure=0.0, fluid="fluid")
    return dict(domain=dict(thickness=value["H"], width=100.0, height=100.0), fluids=[fluid],
                leak_off=dict(coefficient=value["C_l"], spurt_volume=0.0),
                injection=dict(well_index=value["WI"], stages=[stage],
                               perforations=[dict(name="well", position=[0.0, 0.0], aperture=1e-5)]),
                network=dict(minimum_aperture=value["e_min"], tolerance=1e-12, maximum_iterations=100))


def node(number, x, length, role, time=0.0):
    return dict(id=number, x=x, y=0.0, lumped_length=length, fracture=1, role=role, exposure_time=time)


def segment(number, a, b):
    return dict(id=number, node_a=a, node_b=b, fracture=1, kind=0, length=1.0)


FIRST = dict(revision=0, updated_nodes=[], new_nodes=[node(30, 0.0, 0.5, 3), node(20, 1.0, 1.0, 0), node(10, 2.0, 0.5, 1)],
             parents=[], new_segments=[segment(7, 30, 20), segment(8, 10, 20)], removed_segments=[],
             new_perforations=[dict(name="well", node=30)])
GROWTH = dict(revision=1, updated_nodes=[node(10, 2.0, 1.0, 0)], new_nodes=[node(40, 3.0, 0.5, 1, 0.1)],
              parents=[dict(node=40, parent=10)], new_segments=[segment(9, 10, 40)], removed_segments=[], new_perforations=[])


def main(command):
    page, wrong = tables(), 0

    def compare(what, obtained, printed):
        nonlocal wrong
        text = isinstance(obtained, str)
        same = obtained == printed if text else abs(obtained - float(printed)) <= PRINTED * abs(float(printed))
        wrong += not same
        shown = obtained if text else f"{obtained:.9g}"
        print(f"{'' if same else 'WRONG':6}{what:30} page {printed[:16]:16}  solver {shown[:16]}")

    with tempfile.TemporaryDirectory() as folder:
        coupler = Coupler(command, folder)
        coupler.say(WELCOME, dict(run_id=b"worked interval.".hex(), case=the_case(page["7a"]), threads=1,
                                  coupler_deadline=float(PATIENCE), resumes=False))
        for k, (insertion, asked, told, ledger) in enumerate([(FIRST, "7c", "7e", "7f"), (GROWTH, "7h", "7j", "7k")]):
            print(f"interval {k + 1}")
            coupler.say(INSERT, dict(insertion=insertion), {}, k, k)
            compare("hash", coupler.hear()[0]["hash"], page["7b"][k]["hash"])
            arrays = {name: [float(row.get(name, 0)) for row in page[asked]] for name in UNITS}
            coupler.say(ADVANCE, dict(begin=0.1 * k, end=0.1 * (k + 1), carry="content"), arrays, k + 1, k)
            body, answer = coupler.hear()
            for name in ("pressure", "aperture_predicted", "filled"):
                for row, value in zip(page[told], answer[name]):
                    compare(f"{name} of node {row['node']}", value, row[name])
            for row in page[ledger]:
                value = body["well_pressure"] if row["what"] == "well_pressure" else body["ledger"].get(row["what"], 0.0)
                compare(row["what"], float(value), row["value"])
        coupler.end()
    print(f"{wrong} of them differ" if wrong else "all as on the page")
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(" ".join(sys.argv[1:])))
