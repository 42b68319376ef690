#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A second, independent flow solver: shows that docs/protocol.md is all a program needs to take the network's part.

One Newtonian fluid, one perforation, constant rates and shut-in; no leak-off. Anything else it refuses with a sentence.
"""
import array, ctypes, hashlib, json, os, struct, sys, zlib
import zmq

HELLO, WELCOME, REJECT, INSERT, ACKNOWLEDGE, ADVANCE, PRESSURE = 1, 2, 3, 11, 12, 20, 21
REPORT, FIELDS, FINISH, BYE, FAIL, PROGRESS = 30, 31, 50, 51, 60, 61
ENVELOPE = struct.Struct("<4sBBH16sIIQQQII")
MEGAPASCAL, NUDGE = 1e6, 1e-6
Refusal = type("Refusal", (Exception,), {"__doc__": "(exit code, sentence)"})


class Channel:
    """Envelope, checksum and sequence numbers on one DEALER."""
    def __init__(self, endpoint):
        self.socket = zmq.Context.instance().socket(zmq.DEALER)
        self.socket.setsockopt(zmq.RECONNECT_IVL, -1)
        self.socket.connect(endpoint)
        self.run, self.epoch, self.sent, self.received = bytes(16), 0, 0, 0

    def send(self, kind, body, arrays=(), interval=0, revision=0):
        """`arrays` are (name, unit, numbers)."""
        frames = [array.array("d", values).tobytes() for _, _, values in arrays]
        names = [dict(name=name, dtype="float64", shape=[len(v)], unit=unit) for name, unit, v in arrays]
        text = json.dumps(dict(body, arrays=names)).encode()
        fields = (kind, self.run, self.epoch, len(frames), self.sent, interval, revision, len(text), 0)
        head = ENVELOPE.pack(b"FIS1", 1, 0, *fields)[:60]
        checksum = struct.pack("<I", zlib.crc32(b"".join([head, text, *frames])))
        self.socket.send_multipart([head + checksum, text, *frames])
        self.sent += 1

    def receive(self, patience):
        if not self.socket.poll(1000 * patience):
            raise Refusal(21, f"the coupler has said nothing for {patience} s")
        frames = self.socket.recv_multipart()
        magic, major, _, kind, run, epoch, _, sequence, interval, revision, _, crc = ENVELOPE.unpack(frames[0])
        whole = zlib.crc32(b"".join([frames[0][:60], *frames[1:]])) == crc and sequence == self.received
        if magic != b"FIS1" or major != 1 or not whole:
            raise Refusal(22, f"message {self.received} is lost, damaged or of another protocol")
        self.received, self.run, self.epoch = sequence + 1, run, epoch
        body = json.loads(frames[1])
        arrays = {entry["name"]: list(array.array("d", frame))
                  for entry, frame in zip(body.get("arrays", []), frames[2:]) if entry["dtype"] == "float64"}
        return kind, body, arrays, interval, revision


def solve_sparse(rows, right):
    """Gaussian elimination of rows {column: value}, the sparsest row first; the matrix is diagonally dominant."""
    order, left, x = [], set(range(len(rows))), [0.0] * len(rows)
    while left:
        k = min(left, key=lambda i: (len(rows[i]), i))
        left.remove(k), order.append(k)
        for i in [i for i in rows[k] if i in left]:
            factor = rows[i].pop(k, 0.0) / rows[k][k]
            for j in rows[k].keys() & left:
                rows[i][j] = rows[i].get(j, 0.0) - factor * rows[k][j]
            right[i] -= factor * right[k]
    for k in reversed(order):
        x[k] = (right[k] - sum(value * x[j] for j, value in rows[k].items() if j != k)) / rows[k][k]
    return x


class FlowSolver:
    def __init__(self, case):
        self.fluid, self.stages, leak_off = case["fluids"][0], case["injection"]["stages"], case["leak_off"]
        for beyond, sentence in (
                (len(case["fluids"]) != 1 or self.fluid["power_index"] != 1, "knows one Newtonian fluid only"),
                (leak_off["coefficient"] > 0 or leak_off["spurt_volume"] > 0, "knows no leak-off"),
                (any(s["control"] == "pressure" or s["ramp"] > 0 for s in self.stages), "knows constant rates only"),
                (len(case["injection"]["perforations"]) != 1, "knows one perforation only")):
            if beyond:
                raise Refusal(10, "flow_solver.py " + sentence)
        self.thickness, self.well_index = case["domain"]["thickness"], case["injection"]["well_index"]
        self.controls, self.floor = case["network"], case["network"]["minimum_aperture"]
        self.nodes, self.segments, self.place, self.wells, self.revision = [], [], {}, [], 0
        self.content, self.pressure, self.filled, self.contact, self.joining = [], [], [], [], []
        self.injected, self.in_place, self.found, self.iterations = 0.0, None, 0.0, 0

    def insert(self, change):
        for node in change["updated_nodes"]:
            i = self.place[node["id"]]
            self.content[i] *= self.nodes[i]["lumped_length"] / node["lumped_length"]
            self.nodes[i] = node
        for values in (self.content, self.pressure, self.filled):
            values += [0.0] * len(change["new_nodes"])
        self.nodes += change["new_nodes"]
        self.contact += [node.get("formation_pressure", 0.0) for node in change["new_nodes"]]
        self.joining += [node.get("saturated", False) for node in change["new_nodes"]]
        self.place = {node["id"]: i for i, node in enumerate(self.nodes)}
        self.segments = [s for s in self.segments if s["id"] not in change["removed_segments"]] + change["new_segments"]
        self.wells += [self.place[perforation["node"]] for perforation in change["new_perforations"]]
        self.natural = [0.0] * len(self.nodes)
        for s in (s for s in self.segments if s["kind"] == 1):
            for end in (self.place[s["node_a"]], self.place[s["node_b"]]):
                self.natural[end] += s["length"] / 2
        self.revision = change["revision"]
        text = struct.pack("<Q", self.revision)
        for layout, keys, entries in (("<QdddQQ", "id x y lumped_length fracture role", self.nodes),
                                      ("<QQQd", "id node_a node_b length", self.segments)):
            text += b"".join(struct.pack(layout, *(entry[key] for key in keys.split())) for entry in entries)
        return hashlib.sha256(text).hexdigest()

    def joint(self, i, p):
        """What a touching joint opens by itself, and its slope."""
        compliance, origin = (self.nodes[i].get(key, 0.0) for key in ("joint_compliance", "formation_pressure"))
        return compliance * (min(p, self.contact[i]) - origin), compliance * (p < self.contact[i])

    def predicted(self, i, p, a):
        """What the structure will make of p, and its slope."""
        slope = a["compliance"][i] * (not (a["closed"][i] and p < a["reference_pressure"][i]))
        e = a["aperture"][i] + slope * (p - a["reference_pressure"][i])
        return (e, slope) if e >= 0 else (0.0, 0.0)

    def node(self, i, u, a):
        """p, dp/du, e, m, dm/du of one node."""
        p = max(u, 0.0) * MEGAPASCAL
        e, slope = map(sum, zip(self.predicted(i, p, a), self.joint(i, p)))
        e, slope = (e, slope) if e >= 0 else (0.0, 0.0)
        if u < 0:
            return 0.0, 0.0, e, e + u * max(e, self.floor), max(e, self.floor)
        compression, film = p / self.fluid["bulk_modulus"], 1e-6 * self.floor
        steepness = slope * (1 + compression) + (e + film) / self.fluid["bulk_modulus"]
        return p, MEGAPASCAL, e, e * (1 + compression), MEGAPASCAL * steepness

    def arm(self, k, i, end, a):
        """Aperture of segment k at its end in node i, where natural arms share the joint's opening."""
        e = a["arm_aperture_" + end][k] if "arm_aperture_a" in a else a["aperture"][i]
        if self.segments[k]["kind"] == 1:
            e += self.joint(i, self.pressure[i])[0] * self.nodes[i]["lumped_length"] / self.natural[i]
        return max(e, self.floor)

    def solve(self, a, duration, injected):
        """Newton on u: pressure where positive, missing content where negative."""
        n, length, edges = len(self.nodes), [node["lumped_length"] for node in self.nodes], []
        for k, s in enumerate(self.segments):
            i, j = self.place[s["node_a"]], self.place[s["node_b"]]
            e = 0.5 * (self.arm(k, i, "a", a) + self.arm(k, j, "b", a))
            edges.append((i, j, duration * e ** 3 / (12 * self.fluid["consistency_index"] * s["length"])))
        u = [p / MEGAPASCAL if f >= 1 else -NUDGE for p, f in zip(self.pressure, self.filled)]
        for iteration in range(self.controls["maximum_iterations"] + 1):
            now = [self.node(i, u[i], a) for i in range(n)]
            residual = [length[i] * (now[i][3] - self.content[i]) for i in range(n)]
            moved = sum(map(abs, residual)) + abs(injected)
            noise = sum(length[i] * (now[i][3] + a["compliance"][i] * now[i][0]) for i in range(n))
            rows, inflow = [{i: length[i] * now[i][4]} for i in range(n)], [0.0] * n
            inflow[self.wells[0]] = injected
            for i, j, conductance in edges:
                noise += conductance * (now[i][0] + now[j][0])
                for here, there in ((i, j), (j, i)):
                    inflow[here] -= conductance * (now[here][0] - now[there][0])
                    rows[here][here] += conductance * now[here][1]
                    rows[here][there] = rows[here].get(there, 0.0) - conductance * now[there][1]
            residual = [stored - entered for stored, entered in zip(residual, inflow)]
            imbalance = sum(map(abs, residual))
            if imbalance <= self.controls["tolerance"] * moved + 2e-15 * noise:
                return u, now, inflow, iteration, imbalance / moved if moved else 0.0
            for i, target in enumerate(here - change for here, change in zip(u, solve_sparse(rows, residual))):
                crossed = (target < 0) != (u[i] < 0)
                u[i] = (NUDGE if target >= 0 and iteration < 40 else -NUDGE) if crossed else target
        raise Refusal(24, f"flow_solver.py did not converge in {iteration} iterations: imbalance {imbalance} m2")

    def advance(self, body, a):
        stored = lambda: sum(node["lumped_length"] * m for node, m in zip(self.nodes, self.content))
        if body["carry"] != "content": raise Refusal(10, "flow_solver.py carries the content only")
        begun = self.in_place is not None
        if not begun:
            self.content, self.filled = list(a["aperture"]), [float(e > 0) for e in a["aperture"]]
        before = stored()
        for i in [i for i, joins in enumerate(self.joining) if joins]:  # full of pore fluid
            p = self.nodes[i]["formation_pressure"]
            self.content[i] = a["aperture"][i] * (1 + p / self.fluid["bulk_modulus"])
            self.pressure[i], self.filled[i], self.joining[i] = p, 1.0, False
        self.found += (stored() - before) * begun
        self.in_place = self.in_place if begun else stored()
        for i, p in enumerate(self.pressure):
            if a["closed"][i] and p <= self.contact[i]:
                self.contact[i] = max(a["reference_pressure"][i], p)
        # Per unit thickness; the coupler ends its intervals at changes of the schedule.
        rate = [stage["rate"] for stage in self.stages if stage["begin"] <= body["begin"]][-1] / self.thickness
        duration = body["end"] - body["begin"]
        u, now, inflow, iterations, residual = self.solve(a, duration, rate * duration)
        for i, (p, _, e, _, _) in enumerate(now):
            self.content[i] += inflow[i] / self.nodes[i]["lumped_length"]
            part = min(max(self.content[i] / e, 0.0), 1 - 1e-15) if e > 0 else 0.0
            self.pressure[i], self.filled[i] = p, 1.0 if u[i] >= 0 else part
        self.injected, self.iterations = self.injected + rate * duration, self.iterations + iterations
        volumes = [self.thickness * v for v in (self.injected, self.in_place, self.found, stored())]
        ledger = dict(zip(("injected", "in_place", "found", "in_fractures"), volumes), leaked=0.0, reset=0.0,
                      residual=sum(volumes[:3]) - volumes[3])
        newton = dict(converged=True, iterations=iterations, residual=residual, halvings=0)
        answer = dict(ledger=ledger, rate=rate * self.thickness, newton=newton,
                      well_pressure=self.pressure[self.wells[0]] + rate / self.well_index)
        predicted = ("aperture_predicted", "m", [self.predicted(i, p, a)[0] for i, p in enumerate(self.pressure)])
        return answer, [("pressure", "Pa", self.pressure), predicted, ("filled", "1", self.filled)]


def serve(channel):
    channel.send(HELLO, dict(role="network", solver="flow_solver.py", version="1", pid=os.getpid(), capabilities=[]))
    solver, patience = None, 60
    while True:
        kind, body, arrays, interval, revision = channel.receive(patience)
        if kind == WELCOME:
            solver, patience = FlowSolver(body["case"]), body.get("coupler_deadline", patience)
        elif kind == INSERT:
            channel.send(ACKNOWLEDGE, dict(hash=solver.insert(body["insertion"])), (), interval, solver.revision)
        elif kind == ADVANCE and revision == solver.revision:
            channel.send(PRESSURE, *solver.advance(body, arrays), interval, revision)
        elif kind == REPORT:
            channel.send(FIELDS, dict(geometry=revision), [("pressure", "Pa", solver.pressure)], interval, revision)
        elif kind == FINISH:
            channel.send(BYE, dict(figures=dict(newton_iterations=solver.iterations)), (), interval, revision)
        elif kind in (BYE, REJECT, FAIL):
            return {BYE: 0, REJECT: 13, FAIL: 20}[kind]
        elif kind != PROGRESS:
            raise Refusal(22, f"flow_solver.py cannot answer message type {kind} for revision {revision}")


if __name__ == "__main__":
    ctypes.CDLL(None).prctl(1, 9)  # PR_SET_PDEATHSIG: do not outlive the coupler
    channel = Channel(sys.argv[sys.argv.index("--connect") + 1])
    try:
        sys.exit(serve(channel))
    except Refusal as refusal:
        exit_code, sentence = refusal.args
        channel.send(FAIL, dict(role="network", phase="work", reason=sentence, exit_code=exit_code))
        channel.socket.poll(1000)  # a command on its way must still find somebody
        sys.exit(exit_code)
