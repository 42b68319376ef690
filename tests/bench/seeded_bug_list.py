# SPDX-License-Identifier: GPL-3.0-or-later
"""Sixty mistakes that people make when they write a flow solver, each as a change of the Python solver or of its client library."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Bug:
    name: str
    file: str       # "solver" or "client"
    mistake: str
    changes: tuple  # of (text that stands there once, what stands there instead)


def bug(name, file, mistake, *changes):
    return Bug(name, file, mistake, changes)


FLOW = (
    bug("flow.sign", "solver", "fluid flows towards the higher pressure",
        ("flow = duration * self.conductance * (pressure[a] - pressure[b])", "flow = duration * self.conductance * (pressure[b] - pressure[a])"),
        ("duration * self.conductance * bend[a], duration * self.conductance * bend[b]",
         "-duration * self.conductance * bend[a], -duration * self.conductance * bend[b]")),
    bug("flow.twelve", "solver", "permeability of plates e^2 / 6", ("mean**3 / (12 *", "mean**3 / (6 *")),
    bug("flow.square", "solver", "e^2 in the place of e^3", ("mean**3 /", "1e-4 * mean**2 /")),
    bug("flow.length", "solver", "segments taken as one metre long", ("self.viscosity * self.network.segment_length)", "self.viscosity)")),
    bug("flow.viscosity", "solver", "water, whatever the fluid is", ("(12 * self.viscosity *", "(12 * 1e-3 *")),
    bug("flow.mean_of_cubes", "solver", "mean of the cubes, not cube of the mean",
        ("mean = sum(np.maximum(arm, self.case.minimum_aperture) for arm in arms) / 2",
         "mean = np.cbrt(sum(np.maximum(arm, self.case.minimum_aperture)**3 for arm in arms) / 2)")),
    bug("flow.floor", "solver", "no floor of the aperture: closed nodes let nothing through",
        ("np.maximum(arm, self.case.minimum_aperture) for arm", "np.maximum(arm, 1e-30) for arm")),
    bug("flow.arms", "solver", "apertures of arms are ignored", ("if arms[0] is None else arms", "if True else arms")),
    bug("flow.arm_ends", "client", "apertures of the arms at node_a and node_b exchanged",
        ("return CouplingInterval(begin, end, carry, **values, **arms)",
         "return CouplingInterval(begin, end, carry, **values, arm_aperture_a=arms['arm_aperture_b'], arm_aperture_b=arms['arm_aperture_b'])")),
    bug("flow.predicted", "solver", "conductance of the last pressure's aperture, not of the one measured",
        ("arms = interval.aperture[self.network.ends].T if",
         "arms = np.maximum(interval.aperture, self.predicted)[self.network.ends].T if")),
    bug("flow.first_segment", "solver", "the first segment carries half", ("# (3d)", "* np.append(0.5, np.ones(max(0, len(mean) - 1)))[:len(mean)]")),
    bug("flow.ends", "client", "segments point at nodes by id less the smallest id, not by place",
        ("(self.place[segment[\"node_a\"]], self.place[segment[\"node_b\"]])",
         "tuple(sorted(self.place).index(segment[end]) for end in (\"node_a\", \"node_b\"))")),
)

STORAGE = (
    bug("storage.compliance", "solver", "rock is taken as rigid",
        ("slope = np.where(now.closed & (pressure < now.reference_pressure), 0.0, now.compliance)", "slope = np.zeros(len(pressure))")),
    bug("storage.half", "solver", "half of the compliance", ("0.0, now.compliance)", "0.0, now.compliance / 2)")),
    bug("storage.reference", "solver", "reference pressure is forgotten",
        ("slope * (pressure - now.reference_pressure)", "slope * pressure")),
    bug("storage.closed", "solver", "closed faces yield below their reference",
        ("np.where(now.closed & (pressure < now.reference_pressure), 0.0, now.compliance)", "now.compliance")),
    bug("storage.never_opens", "solver", "closed faces stay closed, whatever the pressure",
        ("now.closed & (pressure < now.reference_pressure)", "now.closed")),
    bug("storage.fluid", "solver", "the fluid cannot be compressed", ("1 + pressure / self.stiffness, u < 0", "1.0, u < 0")),
    bug("storage.start", "solver", "the fracture begins empty",
        ("self.content, self.filled = interval.aperture.copy(), np.where(interval.aperture > 0, 1.0, 0.0)",
         "self.content, self.filled = 0 * interval.aperture, 0 * interval.aperture")),
    bug("storage.from_pressure", "solver", "content is computed from the pressure, not from the fluxes",
        ("content = self.content - leaving[:-1] / self.length", "content = self._cells(u[:-1], end)[2] + demand + 1e-9 * self.content")),
    bug("storage.remeasured", "solver", "each interval begins with the content that the new aperture has room for",
        ("self.started, self.time = 1.0, interval.begin",
         "self.started, self.time, self.content = 1.0, interval.begin, np.where(self.filled == 1, interval.aperture, self.content)")),
    bug("storage.aperture_predicted", "solver", "answers the aperture that was measured",
        ("else self._aperture(self.pressure, interval.end)[0]", "else interval.aperture")),
    bug("storage.unclipped", "solver", "an aperture below zero is answered",
        ("return np.maximum(opened, 0.0), np.where", "return opened, np.where")),
    bug("filling.full", "solver", "new nodes count as full",
        ("self.pressure, self.filled, self.predicted = (np.append(each, new) for each in (self.pressure, self.filled, self.predicted))",
         "self.pressure, self.filled, self.predicted = np.append(self.pressure, new), np.append(self.filled, new + 1), np.append(self.predicted, new)"),
        ("np.where(u[:-1] >= 0, 1.0, part)", "np.where(self.filled == 1, 1.0, part)")),
    bug("filling.told", "solver", "filled is told as its complement", ("np.where(u[:-1] >= 0, 1.0, part)", "np.where(u[:-1] >= 0, 1.0, 1 - part)")),
    bug("filling.passes", "solver", "a node that is filling has the pressure at which its rock rests",
        ("return (pressure, np.where(empty, 0.0, MEGAPASCAL)",
         "return (np.where(empty, 0.5 * self.now.reference_pressure, pressure), np.where(empty, 0.0, MEGAPASCAL)")),
)

WELL = (
    bug("well.thickness", "client", "the rate is taken per metre of thickness", ("target = each[\"rate\"] / thickness if", "target = each[\"rate\"] if")),
    bug("well.rate", "solver", "answers the rate per metre of thickness",
        ("self.well_pressure, self.rate * self.case.thickness,", "self.well_pressure, self.rate,")),
    bug("well.index", "solver", "the perforation resists nothing", ("len(self.network.wells), self.case.well_index)", "len(self.network.wells), 1e-3)")),
    bug("well.first_only", "solver", "all goes through the first perforation",
        ("len(self.network.wells), self.case.well_index)])",
         "len(self.network.wells), self.case.well_index) * (np.arange(len(self.network.wells)) == 0)])")),
    bug("well.ramp", "client", "ramps are steps", ("return self.target if elapsed >= self.ramp else", "return self.target if elapsed >= 0 else")),
    bug("well.ramp_from_zero", "solver", "ramps begin at zero, not at what the well did",
        ("self.stage_begin, self.entry_rate = self.stage.begin, self.rate", "self.stage_begin, self.entry_rate = self.stage.begin, 0.0")),
    bug("well.end", "solver", "the target at the end of the step in the place of its mean",
        ("rate = self.stage.mean_target(self.time, end, self.entry_rate)", "rate = self.stage.target_at(end, self.entry_rate)")),
    bug("well.stage", "solver", "a stage is taken up at the next interval only",
        ("self._step(min(interval.end, self.case.next_change(self.time)))", "self._step(interval.end)")),
    bug("well.shut_in", "client", "shut in, the pumps go on", ("control, target, fluid = each[\"control\"], 0.0, None",
                                                              "control, target, fluid = each[\"control\"], stages[-1].target if stages else 0.0, None")),
    bug("well.pressure", "solver", "answers the pressure of the first node for that of the well",
        ("self.well_pressure, self.time = float(pressure[-1]), end", "self.well_pressure, self.time = float(pressure[0]), end")),
)

LEAK_OFF = (
    bug("leak_off.none", "solver", "leak-off is forgotten", ("2 * self.case.spurt_volume + 4 * self.case.leak_off_coefficient", "0 * self.case.leak_off_coefficient")),
    bug("leak_off.one_face", "solver", "one face leaks", ("+ 4 * self.case.leak_off_coefficient", "+ 2 * self.case.leak_off_coefficient")),
    bug("leak_off.spurt", "solver", "spurt is forgotten", ("2 * self.case.spurt_volume + 4", "4")),
    bug("leak_off.linear", "solver", "grows with time, not with its root", ("np.sqrt(exposed) - self.leaked", "exposed - self.leaked")),
    bug("leak_off.clock", "solver", "counted from the start of the run, not from the exposure",
        ("4 / 9 * (time - self.network.exposure_time), time - self.swept)", "4 / 9 * time, np.full(len(self.swept), time))")),
    bug("leak_off.from_nothing", "solver", "takes from a node what it does not have",
        ("taken = np.clip(demand, 0.0, np.maximum(content, 0.0))", "taken = demand")),
    bug("leak_off.unbooked", "solver", "does not enter the ledger", ("self.lost += float(self.length @ taken)", "self.lost += 0.0")),
)

INSERTION = (
    bug("insertion.lost", "client", "the content of a node whose length changes stays as high as it was",
        ("            result[i] *= old_length[i] / length[i]", "            result[i] *= 1.0")),
    bug("insertion.split", "client", "what stood on the length that is split off is lost",
        ("result[beside] += (old_length[i] - length[i]) * values[i] / length[beside].sum()", "result[beside] += 0.0")),
    bug("insertion.leaked", "solver", "leaked volumes are not moved",
        ("moved(self.leaked, old, network)", "np.append(self.leaked, new)")),
    bug("insertion.wet", "client", "new nodes begin with the fluid of their neighbour's aperture",
        ("result = numpy.concatenate([values, numpy.zeros(len(length) - before)])",
         "result = numpy.concatenate([values, numpy.full(len(length) - before, values[-1] if len(values) else 0.0)])")),
    bug("insertion.updated", "client", "nodes that are updated stay as they were",
        ("self.nodes[self.place[node[\"id\"]]] = node", "pass")),
    bug("insertion.removed", "client", "segments that are removed stay",
        ("if segment[\"id\"] not in removed]", "]")),
)

STATE = (
    bug("state.ledger", "solver", "the injected volume is not saved", ("\"entry_rate\", \"injected\", ", "\"entry_rate\", ")),
    bug("state.leaked", "solver", "leaked volumes are not saved", ("(\"content\", \"pressure\", \"leaked\", \"filled\"", "(\"content\", \"pressure\", \"filled\""),
        ("        self.time = self.well_pressure = self.rate", "        self.leaked = np.zeros(0)\n        self.time = self.well_pressure = self.rate"),
        ("        self._stand_on(network)\n        with", "        self._stand_on(network)\n        self.leaked = np.zeros(len(network.nodes))\n        with")),
    bug("state.ramp", "solver", "where a ramp began is not saved", ("\"rate\", \"entry_rate\", ", "\"rate\", ")),
    bug("state.unchecked", "client", "a damaged state is taken up",
        ("magic != b\"FISPYTH1\" or zlib.crc32(rest) != checksum", "magic != b\"FISPYTH1\"")),
    bug("neutral.exposure", "solver", "taking up another's state, all faces are exposed now",
        ("self.swept = np.where(tip, np.nan, state.exposure_time)", "self.swept = np.full(len(tip), state.time)")),
)

CONVERSATION = (
    bug("message.revision", "client", "a command made for another revision is answered",
        ("if message.revision != self._network.revision:", "if False:")),
    bug("message.checksum", "client", "checksums are not compared",
        ("if zlib.crc32(b\"\".join([head, *frames[1:]])) != struct.unpack(\"<I\", frames[0][60:])[0]:", "if False:")),
    bug("message.sequence", "client", "lost and doubled messages are not noticed", ("if sequence != self._received:", "if False:")),
    bug("message.nan", "client", "values that are not finite are taken as zero",
        ("        for i in numpy.flatnonzero(~numpy.isfinite(array))[:1]:\n            raise ValueFault(f\"{self.name} interval {self.interval}: {name}[{i}] is {array[i]} (of {count} values)\")\n        return array",
         "        return numpy.nan_to_num(array)")),
    bug("message.negative", "client", "a negative aperture is taken as zero",
        ("raise ValueFault(f\"{name}[{i}] is {array[i]}, expected at least 0\")", "array = numpy.maximum(array, 0.0)")),
    bug("message.interval", "client", "an interval that does not follow the last is solved",
        ("(self._time is not None and begin != self._time)", "False")),
    bug("message.progress", "client", "no sign of life while at work", ("        if time.monotonic() - self._told < PROGRESS_INTERVAL:\n            return\n", "        return\n")),
    bug("message.order", "client", "arrays of nodes are answered in the order of ids",
        ("for name, values in arrays.items()})\n\n    def _interval_of", "for name, values in ((name, values[numpy.argsort([node[\"id\"] for node in self._network.nodes])]) for name, values in arrays.items())})\n\n    def _interval_of")),
    bug("message.hash", "client", "the hash of the first network for ever",
        ("        self._answer(\"ACKNOWLEDGE\", {\"hash\": self._network.hash()})",
         "        self._first = getattr(self, \"_first\", None) or self._network.hash()\n        self._answer(\"ACKNOWLEDGE\", {\"hash\": self._first})")),
    bug("message.late", "client", "answers the interval before: an answer too late",
        ("        self._time = interval.end\n        arrays", "        self._time = interval.end\n        answer, self._late = getattr(self, \"_late\", None) or answer, answer\n        arrays")),
    bug("message.silence", "client", "waits for ever for a coupler that is silent", ("> self._deadline:", "> 1e9:")),
)

BUGS = (*FLOW, *STORAGE, *WELL, *LEAK_OFF, *INSERTION, *STATE, *CONVERSATION)

# The short form: bug, and the checks that are tried.
SHORT = {"flow.twelve": "cubic_law", "storage.reference": "storage", "insertion.lost": "insertion", "message.nan": "values"}
