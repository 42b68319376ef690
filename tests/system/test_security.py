# SPDX-License-Identifier: GPL-3.0-or-later
"""Strangers, thieves and liars at the coupler's door: nothing of theirs is heard, and the run gives the same bytes as without them."""
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest

from trio import CASE, COUPLER, PROGRAMS, Run

SMALL = ("--set", 'output.interval="0.1 s"', "--until", "0.4 s")
LONGER = ("--set", 'output.interval="0.1 s"', "--until", "4 s")  # some seconds of wall time
ENDLESS = ("--set", 'time.end="1000 s"')
ZMTP_GREETING = b"\xff" + bytes(8) + b"\x7f\x03\x00" + b"NULL".ljust(20, b"\0") + bytes(32)


def wait_for_history(run, seconds=20):
    """Until the participants are at work; over TCP their command lines do not name the run."""
    end = time.monotonic() + seconds
    while not (run.directory / "history.csv").exists():
        if time.monotonic() > end or run.process.poll() is not None:
            raise AssertionError("the trio did not start")
        time.sleep(0.01)


def wait_for_structure(run, seconds=60):
    """Until the structure has been made welcome: a flood before that may keep it out, as any stranger."""
    end = time.monotonic() + seconds
    while True:
        told = subprocess.run([COUPLER, "status", run.directory, "--json"], capture_output=True, text=True)
        if told.returncode == 0 and json.loads(told.stdout)["participants"]["structure"]["asked"] == "WELCOME":
            return
        if time.monotonic() > end or run.process.poll() is not None:
            raise AssertionError("the structure did not join")
        time.sleep(0.05)


def process_at(port, role):
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            words = (entry / "cmdline").read_bytes().decode().split("\0")
        except OSError:
            continue
        if pathlib.Path(words[0]).name == role and f"tcp://127.0.0.1:{port}" in words:
            return int(entry.name)
    raise AssertionError("there is no " + role)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def at(endpoint, length=SMALL):
    return ("--set", f'exchange.endpoint="{endpoint}"', *length)


def segments(run):
    return {file.name: file.read_bytes() for file in sorted((run.directory / "segments").glob("*.h5"))}


def connection(port, seconds=10):
    end = time.monotonic() + seconds
    while True:
        try:
            return socket.create_connection(("127.0.0.1", port), timeout=5)
        except OSError:
            if time.monotonic() > end:
                raise
            time.sleep(0.02)


def zmtp_frame(content, more=False):
    if len(content) < 256:
        return bytes([int(more), len(content)]) + content
    return bytes([int(more) | 2]) + len(content).to_bytes(8, "big") + content


def ready(identity=b"network"):
    """The READY command of a DEALER that calls itself `identity`."""
    def entry(name, value):
        return bytes([len(name)]) + name + len(value).to_bytes(4, "big") + value
    body = b"\x05READY" + entry(b"Socket-Type", b"DEALER") + entry(b"Identity", identity)
    return bytes([4, len(body)]) + body


class Keys:
    def __init__(self):
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="fissura-keys-"))
        self.path = self.home / "keys"
        made = subprocess.run([COUPLER, "keys", "new", self.path], capture_output=True, text=True, check=True)
        self.told = made.stdout

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.home)

    def copy(self, *files, renamed=None):
        target = pathlib.Path(tempfile.mkdtemp(dir=self.home))
        for file in files:
            shutil.copy(self.path / file, target / (renamed or {}).get(file, file))
        return target


class CommandLine(unittest.TestCase):
    def test_new_keys_say_where_they_go_and_are_never_overwritten(self):
        with Keys() as keys:
            self.assertIn("structure  structure.secret coupler.public", keys.told)
            secrets = [(keys.path / f"{holder}.secret").read_text().strip() for holder in ("coupler", "structure", "network")]
            for secret in secrets:
                self.assertNotIn(secret, keys.told)
            again = subprocess.run([COUPLER, "keys", "new", keys.path], capture_output=True, text=True)
            self.assertEqual(again.returncode, 11)
            self.assertIn("keys are never overwritten", again.stderr)

    def test_an_address_that_others_can_reach_demands_keys_before_anything_exists(self):
        with Run(*at("tcp://0.0.0.0:5599")) as run:
            self.assertEqual(run.wait(), 14, run.errors)
            self.assertIn("coupler keys new", run.errors)
            self.assertFalse(run.directory.exists())

    def test_a_secret_that_others_can_read_is_refused(self):
        with Keys() as keys:
            (keys.path / "coupler.secret").chmod(0o644)
            with Run(*at("tcp://127.0.0.1:*"), "--keys", keys.path) as run:
                self.assertEqual(run.wait(), 14, run.errors)
                self.assertIn("coupler.secret: its mode is 644", run.errors)
                self.assertFalse(run.directory.exists())

    def test_a_port_in_use_is_named_and_no_solver_is_started(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            with Run(*at(f"tcp://127.0.0.1:{port}"), "--structure", "touch started #") as run:
                self.assertEqual(run.wait(), 12, run.errors)
                self.assertIn(f"port {port}", run.last_line)
                self.assertFalse(pathlib.Path("started").exists())


class Hostile(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.clean = {}
        for length in (SMALL, LONGER):
            with Run(*length) as run:
                assert run.wait() == 0, run.errors
                cls.clean[length] = segments(run)
            assert cls.clean[length]

    def check_undisturbed(self, run, *told, length=SMALL):
        self.assertEqual(run.wait(), 0, run.errors)
        self.assertTrue(segments(run) == self.clean[length], "other segments than those of a run without strangers")
        for words in told:
            self.assertEqual(run.errors.count(words), 1, run.errors)

    def participant(self, role, port, keys=None):
        command = [PROGRAMS / role, "--connect", f"tcp://127.0.0.1:{port}"]
        if keys:
            command += ["--keys", keys]
        return subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def refused(self, process, code, words):
        _, errors = process.communicate(timeout=20)
        self.assertEqual(process.returncode, code, errors)
        self.assertIn(words, errors)

    def guarded(self, action, *told):
        """The trio over TCP with keys, the network awaited: `action(port, keys)` comes first, the real network then."""
        port = free_port()
        with Keys() as keys, Run(*at(f"tcp://127.0.0.1:{port}"), "--keys", keys.path, "--await", "network") as run:
            connection(port).close()
            action(port, keys)
            network = self.participant("network", port, keys.copy("network.secret", "coupler.public"))
            self.check_undisturbed(run, *told)
            self.assertEqual(network.wait(10), 0, network.stderr.read())
            network.stderr.close()
            everything = run.errors + "".join(
                file.read_text(errors="replace") for file in run.directory.rglob("*") if file.is_file())
            for secret in keys.path.glob("*.*"):
                self.assertNotIn(secret.read_text().strip(), everything)

    def open(self, action, *told):
        """The trio over loopback without keys; `action(port)` comes when it runs."""
        port = free_port()
        with Run(*at(f"tcp://127.0.0.1:{port}", LONGER)) as run:
            wait_for_history(run)
            action(port)
            self.assertIsNone(run.process.poll(), "the run was over before the stranger was")
            self.check_undisturbed(run, *told, length=LONGER)

    def test_h1_without_keys(self):
        self.guarded(lambda port, _: self.refused(self.participant("network", port), 14, "handshake"))

    def test_h2_wrong_key_of_the_coupler(self):
        with Keys() as others:
            def come(port, keys):
                mixed = keys.copy("network.secret")
                shutil.copy(others.path / "coupler.public", mixed)
                self.refused(self.participant("network", port, mixed), 14, "another coupler")
            self.guarded(come)

    def test_h3_unknown_key(self):
        with Keys() as others:
            def come(port, keys):
                mixed = keys.copy("coupler.public")
                shutil.copy(others.path / "network.secret", mixed)
                self.refused(self.participant("network", port, mixed), 14, "does not accept the key")
            self.guarded(come, "its key is not among those of this run")

    def test_h4_right_keys(self):
        self.guarded(lambda *_: None)

    def test_key_of_the_wrong_role(self):
        def come(port, keys):
            thief = keys.copy("structure.secret", "coupler.public", renamed={"structure.secret": "network.secret"})
            self.refused(self.participant("network", port, thief), 14, "claims the role network with the key of the role structure")
        self.guarded(come)

    def test_h5_noise_and_silence(self):
        def come(port):
            for noise in (os.urandom(2000), b"GET / HTTP/1.1\r\n\r\n", b""):
                peer = connection(port)
                peer.sendall(noise)
        self.open(come)

    def test_h6_a_forged_identity_without_keys_gets_nowhere_but_to_the_door(self):
        def come(port):
            for content in (b"x" * 64, b"FIS1" + bytes(60)):
                peer = connection(port)
                peer.sendall(ZMTP_GREETING + ready() + zmtp_frame(content, True) + zmtp_frame(b"{}"))
        self.open(come)

    def test_h6_a_forged_identity_against_keys(self):
        def come(port, _):
            peer = connection(port)
            peer.sendall(ZMTP_GREETING + ready() + zmtp_frame(bytes(64), True) + zmtp_frame(b"{}"))
            self.addCleanup(peer.close)
        self.guarded(come)

    def test_h7_ten_thousand_idle_connections(self):
        port = free_port()
        # Opening them takes a busy machine longer than the run would wait for its network.
        patience = ("--set", 'deadlines.join="120 s"')
        with Run(*at(f"tcp://127.0.0.1:{port}"), *patience, "--await", "network") as run:
            wait_for_structure(run)
            peers = [connection(port)]
            worker = next(pid for pid in run.pids() if pathlib.Path(f"/proc/{pid}/exe").resolve() == COUPLER.resolve())

            def memory():
                return int(pathlib.Path(f"/proc/{worker}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

            before = most = memory()
            for number in range(10000):
                peers.append(connection(port))
                if len(peers) > 500:
                    peers.pop(0).close()
                if number % 100 == 0:
                    most = max(most, memory())
            print(f"10000 idle connections: memory +{(most - before) / 2**20:.1f} MiB")
            self.assertLess(most - before, 50 * 2**20)
            network = self.participant("network", port)
            self.check_undisturbed(run, "there are more than 64 connections")
            self.assertEqual(network.wait(10), 0)
            network.stderr.close()
            for peer in peers:
                peer.close()

    def test_h8_an_announced_giant_is_not_believed(self):
        def come(port):
            peer = connection(port)
            peer.sendall(ZMTP_GREETING + ready() + b"\x02" + (1 << 33).to_bytes(8, "big") + b"x" * 1000)
        self.open(come)

    def test_h10_another_user_cannot_reach_the_local_socket(self):
        if os.geteuid() != 0:
            self.skipTest("NOT TESTED: needs root to become another user")
        with Run(*LONGER) as run:
            run.wait_until_running(20)
            run.home.chmod(0o755)
            child = os.fork()
            if child == 0:
                try:
                    os.setuid(65534)
                    peer = socket.socket(socket.AF_UNIX)
                    peer.connect(str(run.directory / "coupler.ipc"))
                    os._exit(1)
                except PermissionError:
                    os._exit(0)
                except OSError:
                    os._exit(2)
            _, status = os.waitpid(child, 0)
            self.assertEqual(os.waitstatus_to_exitcode(status), 0)
            self.check_undisturbed(run, length=LONGER)

    def test_r1_a_second_claim_is_refused_and_names_who_holds_the_role(self):
        port = free_port()
        with Run(*at(f"tcp://127.0.0.1:{port}", LONGER)) as run:
            wait_for_history(run)
            holder = process_at(port, "network")
            self.refused(self.participant("network", port), 12, f"the role network is held by process {holder} since")
            self.check_undisturbed(run, length=LONGER)

    def test_r7_a_participant_may_be_there_first(self):
        port = free_port()
        network = self.participant("network", port)
        time.sleep(1)
        with Run(*at(f"tcp://127.0.0.1:{port}"), "--await", "network") as run:
            self.check_undisturbed(run)
            self.assertEqual(network.wait(10), 0)
            network.stderr.close()

    def test_a_run_whose_awaited_participant_died_goes_on_with_another(self):
        port = free_port()
        with Keys() as keys, Run(*at(f"tcp://127.0.0.1:{port}", LONGER), "--keys", keys.path, "--await", "structure",
                                 "--set", "checkpoint.intervals=5") as run:
            mine = keys.copy("structure.secret", "coupler.public")
            first = self.participant("structure", port, mine)
            while not list((run.directory / "checkpoints").glob("*/MANIFEST.json")):
                self.assertIsNone(run.process.poll())
                time.sleep(0.01)
            first.kill()
            first.communicate()
            self.assertEqual(run.wait(), 20, run.errors)
            self.assertIn("structure is gone: its connection broke", run.last_line)
            second = self.participant("structure", port, mine)
            resumed = subprocess.run([COUPLER, "resume", run.directory], capture_output=True, text=True, timeout=60)
            self.assertEqual(resumed.returncode, 0, resumed.stderr)
            second.communicate(timeout=10)
            self.assertEqual(second.returncode, 0)
            self.assertTrue(segments(run) == self.clean[LONGER])

    def test_a_socket_left_behind_is_removed(self):
        with Run(*ENDLESS) as run:
            run.wait_until_running()
            os.kill(run.pids("coupler")[0], signal.SIGKILL)
            run.wait()
            self.assertEqual([path for path in run.directory.rglob("*") if path.is_socket()], [])


def in_namespace(name, *words):
    return ["ip", "netns", "exec", name, *[str(word) for word in words]]


class Namespaces(unittest.TestCase):
    """Two hosts: namespaces joined by a cable."""
    NAMES = ("fissura-a", "fissura-b")
    ADDRESS = "10.99.0.1"

    def setUp(self):
        steps = [["netns", "add", name] for name in self.NAMES]
        steps += [["link", "add", "fissura-va", "netns", self.NAMES[0], "type", "veth", "peer", "name", "fissura-vb",
                   "netns", self.NAMES[1]]]
        for name, end, address in ((self.NAMES[0], "fissura-va", "10.99.0.1/24"), (self.NAMES[1], "fissura-vb", "10.99.0.2/24")):
            steps += [["-n", name, "addr", "add", address, "dev", end], ["-n", name, "link", "set", end, "up"],
                      ["-n", name, "link", "set", "lo", "up"]]
        self.addCleanup(self.remove)
        for step in steps:
            try:
                made = subprocess.run(["ip", *step], capture_output=True, text=True)
            except FileNotFoundError:
                self.skipTest("NOT TESTED: there is no program `ip`")
            if made.returncode != 0:
                self.skipTest("NOT TESTED: no network namespaces here: " + made.stderr.strip())

    def remove(self):
        for name in self.NAMES:
            subprocess.run(["ip", "netns", "del", name], capture_output=True)

    def play(self, awaited, strangers=False):
        home = pathlib.Path(tempfile.mkdtemp(prefix="fissura-test-"))
        self.addCleanup(shutil.rmtree, home)
        with Keys() as keys, Keys() as others:
            words = [COUPLER, "run", CASE, "--short", "--threads", "1", "--out", home / "run", "--keys", keys.path,
                     *at("tcp://0.0.0.0:5599")]
            for role in awaited:
                words += ["--await", role]
            run = subprocess.Popen(in_namespace(self.NAMES[0], *words), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

            def come(role, *more):
                return subprocess.Popen(in_namespace(self.NAMES[1], PROGRAMS / role, "--connect", f"tcp://{self.ADDRESS}:5599", *more),
                                        stderr=subprocess.PIPE, text=True)

            if strangers:
                thief = keys.copy("structure.secret", "coupler.public", renamed={"structure.secret": "network.secret"})
                wrong = keys.copy("coupler.public")
                shutil.copy(others.path / "network.secret", wrong)
                for more in ((), ("--keys", wrong), ("--keys", thief)):
                    stranger = come("network", *more)
                    _, errors = stranger.communicate(timeout=30)
                    self.assertEqual(stranger.returncode, 14, errors)
            participants = [come(role, "--keys", keys.copy(f"{role}.secret", "coupler.public")) for role in awaited]
            _, errors = run.communicate(timeout=120)
            self.assertEqual(run.returncode, 0, errors)
            for each in participants:
                _, said = each.communicate(timeout=10)
                self.assertEqual(each.returncode, 0, said)
        return {file.name: file.read_bytes() for file in sorted((home / "run/segments").glob("*.h5"))}

    def test_two_hosts_give_the_same_bits_as_one(self):
        with Run(*SMALL) as run:
            self.assertEqual(run.wait(), 0, run.errors)
            local = segments(run)
        self.assertTrue(local)
        for awaited in (("structure",), ("network",), ("structure", "network")):
            with self.subTest(awaited):
                self.assertEqual(self.play(awaited), local)
        with self.subTest("strangers"):
            self.assertEqual(self.play(("network",), strangers=True), local)


if __name__ == "__main__":
    unittest.main()
