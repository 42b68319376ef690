# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays the network of a Fissura run: derive from FlowSolver, and call main(solver, name, version).

What a solver must do is docs/flow_solvers.md; messages and bytes are docs/protocol.md; numbers in brackets are equations of the former.
Everything is SI, per metre of thickness unless said otherwise. Arrays are numpy arrays of float64 in the order of Network.nodes or Network.segments.
Needs pyzmq and numpy.
"""
import argparse
import collections
import dataclasses
import hashlib
import json
import math
import os
import pathlib
import signal
import struct
import sys
import time
import zlib

import numpy
import zmq
import zmq.utils.monitor

VIEW = "viscous_flow leak_off power_law several_fluids pressure_control natural_fractures carry_pressure"
CLAIMS = frozenset(VIEW.split())  # words that FlowSolver.physics may hold


class Refusal(Exception):
    """Ends the process with an exit code of docs/operation.md; the coupler is told the sentence."""
    code = 70

    def __init__(self, sentence, code=None):
        super().__init__(sentence)
        self.code = code or self.code


class InputFault(Refusal):
    """The case cannot be solved."""
    code = 10


class ProtocolFault(Refusal):
    """A message is damaged, out of place, incomplete, or of other lengths than the network."""
    code = 22


class ValueFault(Refusal):
    """A number is not finite, or has a sign that physics forbids."""
    code = 23


class SolverFault(Refusal):
    """The flow could not be solved."""
    code = 24


class CheckpointFault(Refusal):
    """A state is none of this program's own."""
    code = 27


class CouplerLost(Refusal):
    """The coupler is gone, silent, or wants nothing of this participant: nobody is left to be told."""


@dataclasses.dataclass(frozen=True)
class Fluid:
    """tau = K gamma^n"""
    name: str
    consistency_index: float  # K [Pa s^n]
    power_index: float        # n [-]
    bulk_modulus: float       # K_f [Pa]


@dataclasses.dataclass(frozen=True)
class Stage:
    """One stage of the pumping schedule; it lasts until the next begins. A shut-in is a rate of zero without a fluid."""
    begin: float   # [s]
    control: str   # "rate" or "pressure"
    target: float  # rate per thickness [m2/s], or well pressure [Pa]
    ramp: float    # the target is reached linearly within this time [s]
    fluid: int     # number of the fluid, or None

    def target_at(self, instant, entry):
        """What is wanted at a time [s]; `entry` is what the well did when the stage began."""
        elapsed = instant - self.begin
        return self.target if elapsed >= self.ramp else entry + (self.target - entry) * elapsed / self.ramp

    def mean_target(self, begin, end, entry):
        """Its mean over (begin, end] [s], exact for the piecewise linear target."""
        ramp_end = min(max(self.begin + self.ramp, begin), end)
        ramped = 0.5 * (self.target_at(begin, entry) + self.target_at(ramp_end, entry)) * (ramp_end - begin)
        return (ramped + self.target * (end - ramp_end)) / (end - begin)


@dataclasses.dataclass(frozen=True)
class FlowCase:
    """What a case asks of a flow solver."""
    thickness: float             # H [m]
    fluids: tuple                # of Fluid
    leak_off_coefficient: float  # C_l of one face [m/s^0.5]
    spurt_volume: float          # S_p of one face [m]
    well_index: float            # WI of one perforation [m2/(s Pa)]
    minimum_aperture: float      # e_min, in the conductance only [m]
    tolerance: float             # of an iterative solution, relative to the content moved
    maximum_iterations: int
    stages: tuple                # of Stage, begins increase
    dry: bool                    # nothing is ever pumped

    @classmethod
    def read(cls, case):
        """Of the case that WELCOME brings. Raises InputFault for a number outside its physical range."""
        def positive(value, what):
            if not (math.isfinite(value) and value > 0):
                raise InputFault(f"{what} must be positive, found {value}")
            return value

        def not_negative(value, what):
            if not (math.isfinite(value) and value >= 0):
                raise InputFault(f"{what} must not be negative, found {value}")
            return value

        try:
            injection, network, leak_off = case["injection"], case["network"], case["leak_off"]
            dry = not injection["perforations"] and not injection["stages"]
            thickness = positive(case["domain"]["thickness"], "domain.thickness")
            fluids = tuple(Fluid(each["name"], *(positive(each[key], f"{key} of fluid \"{each['name']}\"")
                                                 for key in ("consistency_index", "power_index", "bulk_modulus"))) for each in case["fluids"])
            if not fluids and not dry:
                raise InputFault("the case has no fluid, expected at least one")
            names, stages = [fluid.name for fluid in fluids], []
            for each in injection["stages"]:
                control, target, fluid = each["control"], 0.0, None
                if control != "shut_in":
                    target = each["rate"] / thickness if control == "rate" else not_negative(each["pressure"], "a well pressure")
                    if each["fluid"] not in names:
                        raise InputFault(f"a pumping stage injects \"{each['fluid']}\", which is not a fluid of the case")
                    fluid = names.index(each["fluid"])
                stages.append(Stage(each["begin"], "pressure" if control == "pressure" else "rate", target,
                                    not_negative(each["ramp"], "a ramp"), fluid))
            return cls(thickness, fluids, not_negative(leak_off["coefficient"], "leak_off.coefficient"),
                       not_negative(leak_off["spurt_volume"], "leak_off.spurt_volume"),
                       injection["well_index"] if dry else positive(injection["well_index"], "injection.well_index"),
                       positive(network["minimum_aperture"], "network.minimum_aperture"), positive(network["tolerance"], "network.tolerance"),
                       positive(network["maximum_iterations"], "network.maximum_iterations"), tuple(stages), dry)
        except (KeyError, TypeError) as fault:
            raise ProtocolFault(f"the case received is not complete: {fault}") from fault

    def stage_from(self, instant):
        """The stage in force in an interval that begins at `instant` [s], or None."""
        begun = [stage for stage in self.stages if stage.begin <= instant]
        return begun[-1] if begun else None

    def next_change(self, instant):
        """The first begin of a stage after `instant` [s], or infinity."""
        return min((stage.begin for stage in self.stages if stage.begin > instant), default=math.inf)


class Network:
    """The fracture network at one revision: lists of dictionaries with the keys of docs/protocol.md, and arrays made of them."""

    def __init__(self, insertions=()):
        self.revision, self.nodes, self.segments, self.perforations = None, [], [], []
        self.place, self._known_segments = {}, set()
        for insertion in insertions:
            self.apply(insertion)

    def apply(self, insertion):
        """One change, whole. Raises ProtocolFault, leaving the network as it was, if it does not fit."""
        other = Network()
        other.revision, other.nodes, other.segments = self.revision, list(self.nodes), list(self.segments)
        other.perforations, other.place, other._known_segments = list(self.perforations), dict(self.place), set(self._known_segments)
        try:
            other._apply(insertion)
        except (KeyError, TypeError) as fault:
            raise ProtocolFault(f"insertion: {fault} is missing or unknown") from fault
        self.__dict__.update(other.__dict__)

    def _apply(self, insertion):
        def require(holds, sentence):
            if not holds:
                raise ProtocolFault("insertion: " + sentence)

        revision = insertion["revision"]
        require(revision == (0 if self.revision is None else self.revision + 1), f"revision {revision} is not the next one")
        self.revision = revision
        for node in insertion["updated_nodes"]:
            require(node["id"] in self.place, f"node {node['id']} does not exist")
            self.nodes[self.place[node["id"]]] = node
        for node in insertion["new_nodes"]:
            require(node["id"] not in self.place, f"node {node['id']} exists already")
            self.place[node["id"]] = len(self.nodes)
            self.nodes.append(node)
        removed = set(insertion["removed_segments"])
        require(removed <= {segment["id"] for segment in self.segments}, "a segment that is removed does not exist")
        self.segments = [segment for segment in self.segments if segment["id"] not in removed]
        for segment in insertion["new_segments"]:
            require(segment["id"] not in self._known_segments, f"segment {segment['id']} existed already")
            require({segment["node_a"], segment["node_b"]} <= self.place.keys(), f"segment {segment['id']} has an unknown node")
            self._known_segments.add(segment["id"])
            self.segments.append(segment)
        for perforation in insertion["new_perforations"]:
            require(perforation["node"] in self.place, f"perforation {perforation['name']} has an unknown node")
            self.perforations.append(perforation)
        self.lumped_length = numpy.array([node["lumped_length"] for node in self.nodes], float)  # l [m]
        self.segment_length = numpy.array([segment["length"] for segment in self.segments], float)  # L [m]
        lengths = numpy.concatenate([self.lumped_length, self.segment_length])
        require(bool(numpy.all(numpy.isfinite(lengths) & (lengths > 0))), "a length is not positive")
        self.exposure_time = numpy.array([node["exposure_time"] for node in self.nodes], float)  # [s]
        self.ends = numpy.array([(self.place[segment["node_a"]], self.place[segment["node_b"]]) for segment in self.segments],
                                int).reshape(-1, 2)  # places of node_a and node_b of each segment
        self.wells = numpy.array([self.place[perforation["node"]] for perforation in self.perforations], int)  # places of the perforations

    def hash(self):
        """docs/protocol.md, section 5"""
        text = [struct.pack("<Q", self.revision)]
        text += [struct.pack("<QdddQQ", *(node[key] for key in ("id", "x", "y", "lumped_length", "fracture", "role"))) for node in self.nodes]
        text += [struct.pack("<QQQd", *(segment[key] for key in ("id", "node_a", "node_b", "length"))) for segment in self.segments]
        return hashlib.sha256(b"".join(text)).hexdigest()


@dataclasses.dataclass(frozen=True)
class CouplingInterval:
    """ADVANCE, checked. The node's law in it is (3b), (3c)."""
    begin: float                       # [s], end of the interval before
    end: float                         # [s]
    carry: str                         # "content" or "pressure"
    aperture: numpy.ndarray            # measured at begin [m], >= 0
    aperture_rate: numpy.ndarray       # [m/s]
    reference_pressure: numpy.ndarray  # [Pa]
    compliance: numpy.ndarray          # C_R [m/Pa], >= 0
    closed: numpy.ndarray              # True where faces touch
    arm_aperture_a: numpy.ndarray      # per segment [m], or None
    arm_aperture_b: numpy.ndarray


@dataclasses.dataclass
class Ledger:
    """Volumes of the whole thickness, cumulative [m3]."""
    injected: float = 0.0
    in_place: float = 0.0
    found: float = 0.0
    in_fractures: float = 0.0
    leaked: float = 0.0
    reset: float = 0.0

    def residual(self):
        return self.injected + self.in_place + self.found + self.reset - self.in_fractures - self.leaked


@dataclasses.dataclass
class FlowAnswer:
    """PRESSURE: the state at the end of the interval."""
    pressure: numpy.ndarray            # [Pa], >= 0
    aperture_predicted: numpy.ndarray  # e(p) [m]
    filled: numpy.ndarray              # [0, 1]
    ledger: Ledger
    well_pressure: float               # [Pa]
    rate: float                        # of the well at the end, whole thickness [m3/s]
    converged: bool = True
    iterations: int = 0
    halvings: int = 0
    residual: float = 0.0              # of an iterative solution, relative to the content moved


@dataclasses.dataclass
class NeutralState:
    """What another flow solver needs to go on from here (section 6.2)."""
    time: float                      # [s]
    started: bool                    # an interval has been solved
    content: numpy.ndarray           # m [m]
    pressure: numpy.ndarray          # [Pa]
    leaked: numpy.ndarray            # v [m]
    exposure_time: numpy.ndarray     # [s], infinite where the fluid has not been
    ledger: Ledger
    well_pressure: float
    rate: float                      # whole thickness [m3/s]
    entry_rate: float                # of the well when the stage in force began [m3/s]
    entry_pressure: float = 0.0      # [Pa]
    contact_pressure: numpy.ndarray | None = None  # p_c [Pa]; None: 0
    joining: numpy.ndarray | None = None           # True: saturated, pore fluid not yet in the content; None: nowhere
    fluid_fraction: numpy.ndarray | None = None    # [n_nodes, n_fluids]; None: all is the first fluid


def moved(values, old_length, network):
    """What an insertion makes of contents or leaked volumes per length (section 5): l_i m_i stays what it is. What stood on the length that a node
    loses to new nodes beside it goes to these.
    @param values  per node of the network before @param old_length  lumped lengths before [m] @returns values per node of `network`"""
    length, before = network.lumped_length, len(old_length)
    result = numpy.concatenate([values, numpy.zeros(len(length) - before)])
    for i in numpy.flatnonzero(old_length != length[:before]):
        beside = [j for pair in network.ends if i in pair for j in pair if j != i and j >= before]
        if beside and length[i] < old_length[i]:
            result[beside] += (old_length[i] - length[i]) * values[i] / length[beside].sum()
        else:
            result[i] *= old_length[i] / length[i]
    return result


class FlowSolver:
    """A flow solver. Calls come in this order: join; insert (revision 0), or restore or take_up in a run that resumes; then any number of
    advance, insert, report, save; finish. Any may raise: a Refusal gives the process its exit code, anything else 70. Arguments have been
    checked: lengths, finite numbers, signs, order of intervals, topology."""

    def physics(self):
        """Words of CLAIMS that this solver can do."""
        raise NotImplementedError

    def join(self, case):
        """@param case  FlowCase"""
        raise NotImplementedError

    def insert(self, insertion, network):
        """@param insertion  dictionary as in docs/protocol.md @param network  Network after it; stays until the next call"""
        raise NotImplementedError

    def advance(self, interval):
        """@param interval  CouplingInterval @returns FlowAnswer. Call note_progress in loops that may take long."""
        raise NotImplementedError

    def report(self):
        """@returns {name: (unit, array)} with one value or row per node or segment"""
        return {}

    def save(self):
        """@returns bytes on which all later answers depend, bit for bit; program, case, topology and a checksum are put around them. None: this
        solver cannot be saved."""
        return None

    def restore(self, state, network):
        """@param state  bytes of save() of the same program and case. Raises CheckpointFault, ValueError, KeyError or OSError if they cannot be its
        own."""
        raise NotImplementedError

    def neutral_state(self):
        """@returns NeutralState, or None if this solver cannot tell"""
        return None

    def take_up(self, state, network):
        """Goes on from another solver's NeutralState: content, leaked volume and ledger stay what they are."""
        raise NotImplementedError

    def finish(self):
        """@returns a dictionary of figures for summary.json"""
        return {}


# ---- messages ---------------------------------------------------------------------------------------

TYPES = {"HELLO": 1, "WELCOME": 2, "REJECT": 3, "INSERT": 11, "ACKNOWLEDGE": 12, "ADVANCE": 20, "PRESSURE": 21, "RESPONSE": 22, "TOPOLOGY": 10,
         "REPORT": 30, "FIELDS": 31, "SAVE": 40, "STATE": 41, "RESTORE": 42, "RESTORED": 43, "FINISH": 50, "BYE": 51, "FAIL": 60, "PROGRESS": 61}
NAMES = {number: name for name, number in TYPES.items()}
UNITS = {"aperture": "m", "aperture_rate": "m/s", "reference_pressure": "Pa", "compliance": "m/Pa", "closed": "1", "arm_aperture_a": "m",
         "arm_aperture_b": "m", "pressure": "Pa", "aperture_predicted": "m", "filled": "1", "neutral_content": "m", "neutral_pressure": "Pa",
         "neutral_leaked": "m", "neutral_exposure_time": "s", "neutral_contact_pressure": "Pa", "neutral_joining": "1",
         "neutral_fluid_fraction": "1"}
DTYPES = {"float64": "<f8", "int64": "<i8", "uint64": "<u8", "uint8": "u1"}
ENVELOPE = struct.Struct("<4sBBH16sIIQQQI")
MAJOR, MINOR = 1, 1
ROUNDING = 1e-12  # of a content that should be 0 [m]
NEVER = -1.0  # an exposure time that has not come


class Message:
    def __init__(self, name, body=None, arrays=None, interval=0, revision=0):
        """@param arrays  {name: (unit, array)}"""
        self.name, self.body, self.arrays, self.interval, self.revision = name, body or {}, arrays or {}, interval, revision

    def value(self, key, kind):
        """Entry of the body. Raises ProtocolFault unless it is there and of that kind."""
        value = self.body.get(key)
        if not isinstance(value, kind) or (isinstance(value, bool) and kind is not bool):
            raise ProtocolFault(f"{self.name} interval {self.interval}: body entry {key} is missing or of another type")
        return value

    def numbers(self, name, count):
        """`count` finite numbers of a one-dimensional array."""
        if name not in self.arrays:
            raise ProtocolFault(f"{self.name} interval {self.interval}: array {name} is missing")
        array = self.arrays[name][1]
        if array.dtype != "<f8" or array.ndim != 1 or len(array) != count:
            raise ProtocolFault(f"{self.name} interval {self.interval}: {name} is {array.dtype} {array.shape}, expected {count} float64")
        for i in numpy.flatnonzero(~numpy.isfinite(array))[:1]:
            raise ValueFault(f"{self.name} interval {self.interval}: {name}[{i}] is {array[i]} (of {count} values)")
        return array


class Channel:
    """Envelopes, checksums and sequence numbers on one DEALER; notices when the coupler is silent or gone."""

    def __init__(self, endpoint, keys=None):
        context = zmq.Context.instance()
        self._socket = context.socket(zmq.DEALER)
        self._socket.setsockopt(zmq.RECONNECT_IVL, -1)
        self._socket.setsockopt(zmq.LINGER, 1000)
        if keys:
            self._socket.curve_secretkey, self._socket.curve_publickey, self._socket.curve_serverkey = keys
        self._monitor = self._socket.get_monitor_socket(zmq.EVENT_DISCONNECTED | zmq.EVENT_CLOSED)
        self._poller = zmq.Poller()
        self._poller.register(self._socket, zmq.POLLIN)
        self._poller.register(self._monitor, zmq.POLLIN)
        self._socket.connect(endpoint)
        self.run, self.epoch, self._sent, self._received = bytes(16), 0, 0, 0

    def send(self, message):
        """Arrays as float64, or uint8 for bytes."""
        declared, frames = [], []
        for name, (unit, values) in message.arrays.items():
            array = numpy.frombuffer(values, "u1") if isinstance(values, bytes) else numpy.ascontiguousarray(values, "<f8")
            declared.append({"name": name, "dtype": "uint8" if array.dtype == "u1" else "float64", "shape": list(array.shape), "unit": unit})
            frames.append(array.tobytes())
        body = json.dumps(dict(message.body, arrays=declared), allow_nan=False).encode()
        head = ENVELOPE.pack(b"FIS1", MAJOR, MINOR, TYPES[message.name], self.run, self.epoch, len(frames), self._sent, message.interval,
                             message.revision, len(body))
        self._socket.send_multipart([head + struct.pack("<I", zlib.crc32(b"".join([head, body, *frames]))), body, *frames])
        self._sent += 1

    def receive(self, patience):
        """The next message within that many seconds, or None. Raises CouplerLost when the connection has ended."""
        ready = dict(self._poller.poll(1000 * patience))
        if self._socket in ready:
            return self._decode(self._socket.recv_multipart())
        if self._monitor in ready:
            raise CouplerLost("the coupler is gone: its connection broke", 20)
        return None

    def _decode(self, frames):
        if len(frames) < 2 or len(frames[0]) != 64:
            raise ProtocolFault(f"a message of {len(frames)} frames, the first of {len(frames[0])} bytes: the envelope must have 64 bytes")
        head, body, data = frames[0][:60], frames[1], frames[2:]
        magic, major, _, kind, run, epoch, count, sequence, interval, revision, length = ENVELOPE.unpack(head)
        if magic != b"FIS1":
            raise ProtocolFault("the envelope does not begin with FIS1")
        if major != MAJOR:
            raise ProtocolFault(f"the coupler speaks protocol {major}, this is {MAJOR}", 13)
        if zlib.crc32(b"".join([head, *frames[1:]])) != struct.unpack("<I", frames[0][60:])[0]:
            raise ProtocolFault(f"message {sequence}: the checksum does not fit")
        name = NAMES.get(kind)
        if name is None or count != len(data) or length != len(body):
            raise ProtocolFault(f"message {sequence} is of type {kind} with {len(data)} arrays: not what its envelope can mean")
        if self._received == 0:
            self.run, self.epoch = run, epoch
        if run != self.run or epoch != self.epoch:
            raise ProtocolFault(f"{name} of interval {interval} belongs to another run or epoch")
        if sequence != self._received:
            raise ProtocolFault(f"{name} of interval {interval} is message {sequence}, expected {self._received}: lost or doubled")
        self._received += 1
        return self._message(name, body, data, interval, revision)

    @staticmethod
    def _message(name, body, data, interval, revision):
        try:
            body = json.loads(body)
            arrays = {}
            for entry, frame in zip(body.get("arrays", []), data, strict=True):
                array = numpy.frombuffer(frame, DTYPES[entry["dtype"]]).reshape(entry["shape"])
                expected = UNITS.get(entry["name"], entry["unit"])
                if entry["unit"] != expected:
                    raise ProtocolFault(f"{name} interval {interval}: {entry['name']} must be in \"{expected}\", found \"{entry['unit']}\"", 13)
                arrays[entry["name"]] = (entry["unit"], array)
        except (ValueError, KeyError, TypeError, AttributeError) as fault:
            raise ProtocolFault(f"{name} interval {interval}: the body or a length does not fit: {fault}") from fault
        return Message(name, body, arrays, interval, revision)


# ---- the participant --------------------------------------------------------------------------------

# State, command -> state after it. What is not there is a fault.
ORDER = {("greeting", "WELCOME"): None, ("greeting", "REJECT"): "ended", ("empty", "INSERT"): "ready", ("resuming", "RESTORE"): "ready",
         **{("ready", name): "ready" for name in ("INSERT", "ADVANCE", "REPORT", "SAVE")}, ("ready", "FINISH"): "leaving",
         ("leaving", "BYE"): "ended"}
PROGRESS_INTERVAL, LAST_WORDS = 0.2, 2.0  # s
STATE_HEAD = struct.Struct("<8sII")       # magic, length of the JSON behind, CRC-32 of all that follows


class Participant:
    """One solver in one run, from HELLO to the end of the connection."""

    def __init__(self, solver, name, version, channel):
        self._solver, self._name, self._version, self._channel = solver, name, version, channel
        self._state, self._network, self._insertions, self._case, self._hash = "greeting", Network(), [], None, ""
        self._time, self._interval, self._phase, self._deadline, self._work = None, 0, "hello", 60.0, 0.0
        self._heard = self._told = time.monotonic()
        self._signal, self._count, self._kept = None, 0, collections.deque()

    def run(self):
        """@returns the exit code of the process"""
        try:
            self._greet()
            while self._state != "ended":
                message = self._kept.popleft() if self._kept else self._hear(0.5)
                if message:
                    self._take(message)
            return self._exit_code
        except CouplerLost as loss:
            print(f"network: {loss} (interval {self._interval}, phase {self._phase})", file=sys.stderr)
            return loss.code
        except Refusal as refusal:
            return self._fail(refusal.code, str(refusal))
        except MemoryError:
            return self._fail(26, "out of memory")
        except Exception as fault:  # noqa: BLE001: whatever it is, the coupler is told
            return self._fail(70, f"{type(fault).__name__}: {fault}")

    def ask_to_stop(self, number, _frame):
        """Of SIGTERM and SIGHUP: the run ends at its next coupling time."""
        self._signal = number

    def note_progress(self, phase):
        self._count += 1
        self._phase = phase
        if time.monotonic() - self._told < PROGRESS_INTERVAL:
            return
        self._tell_progress()
        while message := self._hear(0):
            raise ProtocolFault(f"{message.name} came, but the solver is at work")

    _exit_code = 0

    def _tell_progress(self):
        self._told = time.monotonic()
        body = {"phase": self._phase, "count": self._count}
        if self._signal:
            body["stop_signal"], self._signal = int(self._signal), None
        self._channel.send(Message("PROGRESS", body, interval=self._interval))

    def _greet(self):
        capabilities = ["insert", "report"]
        if type(self._solver).save is not FlowSolver.save:
            capabilities += ["save", "restore"]
            if type(self._solver).neutral_state is not FlowSolver.neutral_state:
                capabilities.append("neutral_state")
        physics = sorted(self._solver.physics())
        if not CLAIMS.issuperset(physics):
            raise Refusal(f"the solver claims {physics}, expected words of {sorted(CLAIMS)}")
        self._channel.send(Message("HELLO", {"role": "network", "solver": self._name, "version": self._version, "pid": os.getpid(),
                                             "capabilities": capabilities, "physics": physics}))

    def _hear(self, patience):
        """The next command, or None; PROGRESS is only a sign of life."""
        message = self._channel.receive(patience)
        if self._signal:
            self._tell_progress()
        if message is None:
            if time.monotonic() - self._heard > self._deadline:
                raise CouplerLost(f"the coupler has said nothing for {self._deadline} s", 21)
            return None
        self._heard = time.monotonic()
        if message.name == "FAIL" and self._state != "greeting":
            raise CouplerLost(f"the coupler ended the run: {message.body.get('reason')}", 20)
        return None if message.name == "PROGRESS" and self._state != "greeting" else message

    def _take(self, message):
        if (self._state, message.name) not in ORDER:
            raise ProtocolFault(f"{message.name} came in the state {self._state}")
        begun, self._interval, self._phase = time.monotonic(), message.interval, message.name.lower()
        following = ORDER[self._state, message.name]
        following = getattr(self, "_" + message.name.lower())(message) or following
        self._state, self._phase = following, "waiting"
        self._work += time.monotonic() - begun

    def _answer(self, name, body=None, arrays=None):
        self._phase = "answer"
        self._channel.send(Message(name, body, arrays, self._interval, self._network.revision or 0))

    def _reject(self, message):
        raise CouplerLost(f"the coupler refused this participant: {message.body.get('reason')}", message.value("exit_code", int))

    def _bye(self, _message):
        self._exit_code = 0

    def _welcome(self, message):
        self._deadline = message.value("coupler_deadline", (int, float))
        case = message.value("case", dict)
        relevant = {key: case.get(key) for key in ("domain", "fluids", "leak_off", "injection", "network")}
        self._hash = hashlib.sha256(json.dumps(relevant, sort_keys=True).encode()).hexdigest()
        self._case = FlowCase.read(case)
        self._solver.join(self._case)
        return "resuming" if message.value("resumes", bool) else "empty"

    def _insert(self, message):
        insertion = message.value("insertion", dict)
        self._network.apply(insertion)
        self._insertions.append(insertion)
        self._solver.insert(insertion, self._network)
        self._answer("ACKNOWLEDGE", {"hash": self._network.hash()})

    def _advance(self, message):
        self._require_revision(message)
        interval = self._interval_of(message)
        answer = self._solver.advance(interval)
        self._time = interval.end
        arrays = {"pressure": answer.pressure, "aperture_predicted": answer.aperture_predicted, "filled": answer.filled}
        for name, values in arrays.items():
            if numpy.shape(values) != (len(self._network.nodes),):
                raise Refusal(f"the solver gave {name} of shape {numpy.shape(values)} for {len(self._network.nodes)} nodes")
            if not numpy.all(numpy.isfinite(values)):
                raise SolverFault(f"the solver gave a {name} that is not finite")
        self._answer("PRESSURE", {"ledger": ledger_entries(answer.ledger), "well_pressure": float(answer.well_pressure), "rate": float(answer.rate),
                                  "newton": {"converged": bool(answer.converged), "iterations": int(answer.iterations),
                                             "residual": float(answer.residual), "halvings": int(answer.halvings)}},
                     {name: (UNITS[name], values) for name, values in arrays.items()})

    def _interval_of(self, message):
        count, segments = len(self._network.nodes), len(self._network.segments)
        begin, end = (float(message.value(key, (int, float))) for key in ("begin", "end"))
        carry = message.value("carry", str)
        if not end > begin or (self._time is not None and begin != self._time):
            raise ProtocolFault(f"the interval from {begin} s to {end} s has no length, or does not begin at {self._time} s")
        if carry not in ("content", "pressure"):
            raise ProtocolFault(f"carry is \"{carry}\", expected \"content\" or \"pressure\"")
        names = ("aperture", "aperture_rate", "reference_pressure", "compliance", "closed")
        values = {name: message.numbers(name, count) for name in names}
        arms = {name: message.numbers(name, segments) for name in ("arm_aperture_a", "arm_aperture_b")} if {
            "arm_aperture_a", "arm_aperture_b"} & message.arrays.keys() else dict(arm_aperture_a=None, arm_aperture_b=None)
        for name, array in {**values, **arms}.items():
            if name not in ("aperture_rate", "reference_pressure") and array is not None:
                for i in numpy.flatnonzero(array < 0)[:1]:
                    raise ValueFault(f"{name}[{i}] is {array[i]}, expected at least 0")
        values["closed"] = values["closed"] != 0
        return CouplingInterval(begin, end, carry, **values, **arms)

    def _report(self, message):
        self._require_revision(message)
        self._answer("FIELDS", {"geometry": self._network.revision}, self._solver.report())

    def _save(self, _message):
        body, arrays = {}, {"state": ("1", self._own_state())}
        neutral = self._solver.neutral_state()
        if neutral is not None:
            body, more = neutral_entries(neutral, len(self._case.fluids))
            arrays.update(more)
        self._answer("STATE", body, arrays)

    def _own_state(self):
        head = json.dumps({"program": [self._name, self._version], "case": self._hash, "topology": self._network.hash(), "time": self._time}).encode()
        rest = head + self._solver.save()
        return STATE_HEAD.pack(b"FISPYTH1", len(head), zlib.crc32(rest)) + rest

    def _restore(self, message):
        insertions = message.value("insertions", list)
        network = Network(insertions)
        if network.revision is None:
            raise ProtocolFault("RESTORE brings no topology")
        if "state" in message.arrays:
            self._restore_own(message.arrays["state"][1].tobytes(), network)
        else:
            state = neutral_state_of(message, len(network.nodes), len(self._case.fluids))
            self._solver.take_up(state, network)
            self._time = state.time if state.started else None
        self._insertions, self._network = insertions, network
        self._answer("RESTORED", {"hash": network.hash()})

    def _restore_own(self, blob, network):
        if len(blob) < STATE_HEAD.size:
            raise CheckpointFault(f"a state of {len(blob)} bytes is too short")
        magic, length, checksum = STATE_HEAD.unpack(blob[:STATE_HEAD.size])
        rest = blob[STATE_HEAD.size:]
        if magic != b"FISPYTH1" or zlib.crc32(rest) != checksum:
            raise CheckpointFault("the saved state is damaged, or of another program")
        head = json.loads(rest[:length])
        if head["program"] != [self._name, self._version] or head["case"] != self._hash or head["topology"] != network.hash():
            raise CheckpointFault("the saved state is of another program, case or topology")
        try:
            self._solver.restore(rest[length:], network)
        except (ValueError, KeyError, OSError) as fault:
            raise CheckpointFault(f"the solver cannot read its state: {fault}") from fault
        self._time = head["time"]

    def _finish(self, _message):
        self._answer("BYE", {"figures": dict(self._solver.finish(), work_seconds=self._work)})
        self._heard, self._deadline = time.monotonic(), LAST_WORDS

    def _require_revision(self, message):
        if message.revision != self._network.revision:
            raise ProtocolFault(f"{message.name} is made for topology revision {message.revision}, this participant has {self._network.revision}")

    def _fail(self, code, reason):
        """Says why, and waits for the coupler to have heard it."""
        print(f"network: interval {self._interval}, phase {self._phase}: {reason}", file=sys.stderr)
        try:
            self._channel.send(Message("FAIL", {"role": "network", "phase": self._phase, "reason": reason, "exit_code": code}, interval=self._interval))
            end = time.monotonic() + LAST_WORDS
            while time.monotonic() < end:
                try:
                    message = self._channel.receive(0.1)
                except ProtocolFault:
                    continue
                if message and message.name in ("BYE", "FAIL"):
                    break
        except (CouplerLost, zmq.ZMQError):
            pass
        return code


def ledger_entries(ledger):
    return {**{key: float(value) for key, value in dataclasses.asdict(ledger).items()}, "residual": float(ledger.residual())}


def neutral_entries(state, fluids):
    """@returns body and arrays of STATE"""
    nothing, first = numpy.zeros(len(state.content)), numpy.tile(numpy.eye(1, fluids), (len(state.content), 1))
    scalars = {key: float(getattr(state, key)) for key in ("time", "well_pressure", "rate", "entry_rate", "entry_pressure")}
    body = {"neutral": {**scalars, "started": bool(state.started), "ledger": ledger_entries(state.ledger)}}
    exposure = numpy.where(numpy.isfinite(state.exposure_time), state.exposure_time, NEVER)
    values = {"content": state.content, "pressure": state.pressure, "leaked": state.leaked, "exposure_time": exposure}
    for name, absent in (("contact_pressure", nothing), ("joining", nothing), ("fluid_fraction", first)):
        values[name] = absent if getattr(state, name) is None else getattr(state, name)
    return body, {"neutral_" + name: (UNITS["neutral_" + name], array) for name, array in values.items()}


def neutral_state_of(message, nodes, fluids):
    """NeutralState in RESTORE."""
    try:
        body = message.value("neutral", dict)
        ledger = Ledger(**{field.name: float(body["ledger"][field.name]) for field in dataclasses.fields(Ledger)})
        scalars = {key: float(body[key]) for key in ("time", "well_pressure", "rate", "entry_rate", "entry_pressure")}
        fraction = message.arrays["neutral_fluid_fraction"][1]
    except (KeyError, TypeError) as fault:
        raise ProtocolFault(f"the neutral state lacks {fault}") from fault
    if fraction.size != nodes * fluids or not numpy.all(numpy.isfinite(fraction)):
        raise ProtocolFault(f"neutral_fluid_fraction has {fraction.size} values, expected {nodes} x {fluids} finite ones")
    names = ("content", "pressure", "leaked", "exposure_time", "contact_pressure", "joining")
    arrays = {name: message.numbers("neutral_" + name, nodes) for name in names}
    for name, least in (("content", -ROUNDING), ("pressure", 0), ("leaked", 0)):
        if numpy.any(arrays[name] < least):
            raise ValueFault(f"neutral_{name} is below 0")
    arrays["exposure_time"] = numpy.where(arrays["exposure_time"] < 0, math.inf, arrays["exposure_time"])
    arrays["joining"] = arrays["joining"] != 0
    return NeutralState(started=bool(body.get("started")), fluid_fraction=fraction.reshape(nodes, fluids), ledger=ledger, **scalars, **arrays)


_participant = None


def note_progress(phase):
    """Tells the coupler, a few times a second at most, that the solver is getting on; cheap enough for every iteration."""
    if _participant is not None:
        _participant.note_progress(phase)


def read_keys(directory):
    """Secret and public key of the network, and public key of the coupler, as `coupler keys new` writes them."""
    secret = pathlib.Path(directory, "network.secret")
    if secret.stat().st_mode & 0o077:
        raise Refusal(f"{secret}: others could read this secret key", 14)
    own, coupler = secret.read_text().strip().encode(), pathlib.Path(directory, "coupler.public").read_text().strip().encode()
    return own, zmq.curve_public(own), coupler


def main(solver, name, version, words=None):
    """The whole program of a flow solver: reads --connect and --keys, plays the network, and ends the process."""
    global _participant
    parser = argparse.ArgumentParser(description=f"{name} {version}: the network of a Fissura run, started by the coupler")
    parser.add_argument("--connect", required=True, help="endpoint of the coupler")
    parser.add_argument("--keys", help="directory with network.secret and coupler.public")
    parser.add_argument("--version", action="version", version=version)
    options = parser.parse_args(words)
    try:
        channel = Channel(options.connect, read_keys(options.keys) if options.keys else None)
    except (Refusal, OSError, zmq.ZMQError) as fault:
        print(f"network: {fault}", file=sys.stderr)
        sys.exit(getattr(fault, "code", 14))
    _participant = Participant(solver, name, version, channel)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, _participant.ask_to_stop)
    sys.exit(_participant.run())
