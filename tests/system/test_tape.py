# SPDX-License-Identifier: GPL-3.0-or-later
"""Tapes of a run: every participant answers its tape bit for bit, alone; what differs is named."""
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import tape
from trio import COUPLER, PROGRAMS, Run


def call(*words, seconds=120):
    return subprocess.run([str(word) for word in (COUPLER, *words)], capture_output=True, text=True,
                          timeout=seconds, stdin=subprocess.DEVNULL)


class Tapes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.trio = Run("--tape", "network,structure", "--set", "checkpoint.intervals=20")
        assert cls.trio.wait(300) == 0, cls.trio.errors
        cls.directory = cls.trio.directory
        cls.home = pathlib.Path(tempfile.mkdtemp(prefix="fissura-test-"))

    @classmethod
    def tearDownClass(cls):
        cls.trio.__exit__()
        shutil.rmtree(cls.home, ignore_errors=True)

    def copy(self, name):
        target = self.home / name
        (target / "tape").mkdir(parents=True)
        for file in (self.directory / "tape").iterdir():
            shutil.copy(file, target / "tape")
        shutil.copy(self.directory / "resume.json", target)
        return target

    def test_replay_is_identical(self):
        insertions = sum(message.type == tape.INSERT
                         for message in tape.messages(self.directory / "tape/network.0.tape"))
        self.assertGreater(insertions, 1, "the run has no insertion")
        for role in ("network", "structure"):
            with self.subTest(role):
                answers = sum(message.direction == "<" and message.type != tape.PROGRESS
                              for message in tape.messages(self.directory / f"tape/{role}.0.tape"))
                result = call("replay", self.directory, "--role", role)
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
                self.assertIn(f"{answers} answers are identical", result.stdout)

    def test_replay_finds_a_solver_that_differs(self):
        plan = self.home / "plan.toml"
        plan.write_text('[[message]]\nrole = "network"\ndirection = "to_coupler"\ntype = "PRESSURE"\n'
                        'interval = 9\ndo = "poison"\nfield = "pressure"\nindex = 2\nvalue = 1.25e6\n')
        command = f"{PROGRAMS}/fault_proxy --plan {plan} --role network --command {PROGRAMS}/network"
        result = call("replay", self.directory, "--role", "network", "--command", command)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertIn("PRESSURE of interval 9", result.stdout)
        self.assertRegex(result.stdout, r"pressure\[2\], node \d+ at \(-?[\d.e-]+, -?[\d.e-]+\) m")
        self.assertRegex(result.stdout, r"replay +1250000 +\([\d.e+-]+ apart\)")

    def test_replay_until_an_interval(self):
        result = call("replay", self.directory, "--role", "network", "--until", "5")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("up to interval 5", result.stdout)

    def test_replay_of_a_solver_that_dies(self):
        result = call("replay", self.directory, "--role", "network", "--command",
                      f"env FISSURA_FAULT=network@7=segfault {PROGRAMS}/network")
        self.assertEqual(result.returncode, 20, result.stdout + result.stderr)
        self.assertIn("the tape has PRESSURE of interval 7, but here came its process was killed by signal 11",
                      result.stdout)

    def test_a_held_participant_ends_no_replay_for_a_debugger(self):
        replay = subprocess.Popen([COUPLER, "replay", self.directory, "--role", "network", "--debug-attach"],
                                  stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        line = replay.stderr.readline()
        self.assertRegex(line, r"network is process \d+: gdb -p \d+")
        pid = int(line.split("gdb -p ")[1].split(",")[0])
        os.kill(pid, signal.SIGSTOP)
        replay.stdin.write("\n")
        replay.stdin.flush()
        time.sleep(5)  # more than the transport's heartbeat allows
        os.kill(pid, signal.SIGCONT)
        output, errors = replay.communicate(timeout=60)
        self.assertEqual(replay.returncode, 0, output + errors)

    @unittest.skipUnless(shutil.which("gdb"), "no gdb")
    def test_a_debugger_that_started_the_participant_keeps_it(self):
        mark = self.home / "left to the debugger"
        debugger = f"gdb -q -batch -ex run -ex 'shell sleep 6; touch \"{mark}\"' --args {PROGRAMS}/network"
        result = call("replay", self.directory, "--role", "network", "--debug-attach", "--command", debugger)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("answers are identical", result.stdout)
        self.assertTrue(mark.exists(), "the debugger was ended with the replay")

    def test_bisect_of_the_same_run_again(self):
        with Run("--tape", "network", "--set", "checkpoint.intervals=7", threads=2) as again:
            self.assertEqual(again.wait(300), 0, again.errors)
            result = call("bisect", self.directory, again.directory)
        self.assertEqual(result.returncode, 1, result.stdout)  # the case names another interval of checkpoints
        self.assertIn("/case/checkpoint/intervals", result.stdout)

    def test_bisect_names_the_value_and_who_said_it(self):
        for role, type_, direction, verdict in (
                ("network", tape.PRESSURE, "<", "network said it first"),
                ("network", tape.ADVANCE, ">", "the coupler said it first"),
                ("structure", tape.RESPONSE, "<", "structure said it first")):
            with self.subTest(verdict):
                other = self.copy(f"flipped-{role}-{type_}")
                file = other / f"tape/{role}.0.tape"
                struck = [message for message in tape.messages(file)
                          if message.type == type_ and message.interval == 12 and message.direction == direction][0]
                name, dtype, shape, _ = struck.arrays()[0]
                tape.flip_value(file, struck, 0, 1, 0)
                result = call("bisect", self.directory, other)
                self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
                self.assertIn(f"of interval 12 by {'the coupler' if direction == '>' else role}", result.stdout)
                self.assertIn(f"{name}[1], node ", result.stdout)
                self.assertIn("(1 ulp apart)", result.stdout)
                self.assertIn(verdict, result.stdout)

    def test_a_shorter_tape_is_told_of(self):
        other = self.copy("short")
        file = other / "tape/network.0.tape"
        messages = list(tape.messages(file))
        os.truncate(file, messages[len(messages) // 2].offset + 40)
        result = call("bisect", self.directory, other, "--role", "network")
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertIn("ends in the middle of a message", result.stdout)
        self.assertIn("one tape of network ends earlier; up to there all is the same", result.stdout)
        result = call("replay", other, "--role", "network")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("the tape ends in the middle of a message", result.stdout)

    def test_a_damaged_tape_is_no_difference(self):
        other = self.copy("damaged")
        file = other / "tape/network.0.tape"
        struck = list(tape.messages(file))[40]
        with open(file, "r+b") as stream:
            stream.seek(struck.offset + 200)
            letter = stream.read(1)[0]
            stream.seek(struck.offset + 200)
            stream.write(bytes([letter ^ 4]))
        for words in (("bisect", self.directory, other), ("replay", other, "--role", "network")):
            result = call(*words)
            self.assertEqual(result.returncode, 25, result.stdout + result.stderr)
            self.assertIn(f"message {struck.number} ", result.stderr)

    def test_verify_knows_the_tapes(self):
        result = call("verify", self.directory)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("tape/network.0.tape", result.stdout)
        self.assertIn("tape/network.0.tape", (self.directory / "SHA256SUMS").read_text())


class KilledRuns(unittest.TestCase):
    def test_tape_of_a_killed_run_replays_and_resume_goes_on_taping(self):
        with Run("--tape", "network", "--set", "checkpoint.intervals=5", "--fault", "coupler@30=kill") as run:
            self.assertEqual(run.wait(), 20, run.errors)
            result = call("replay", run.directory, "--role", "network")
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertEqual(call("verify", run.directory).returncode, 0)
            resumed = call("resume", run.directory)
            self.assertEqual(resumed.returncode, 0, resumed.stderr)
            result = call("replay", run.directory, "--role", "network")
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertIn("network.1.tape", result.stdout)
            self.assertIn("earlier lives of the run are taped too: --epoch 0", result.stdout)
            self.assertEqual(call("replay", run.directory, "--role", "network", "--epoch", "0").returncode, 0)

    def test_each_life_of_a_healed_run_replays(self):
        with Run("--tape", "network", "--until", "1 s", "--set", "checkpoint.intervals=5", "--heal", "--fault",
                 "network@9=segfault") as run:
            self.assertEqual(run.wait(), 0, run.errors)
            for epoch, text in ((0, "ends with ADVANCE of interval 9, which was not answered; here came PRESSURE"),
                                (1, "are identical")):
                result = call("replay", run.directory, "--role", "network", "--epoch", epoch)
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
                self.assertIn(text, result.stdout)

    def test_a_crash_happens_again_in_the_replay(self):
        fault = f"env FISSURA_FAULT=network@9=segfault {PROGRAMS}/network"
        with Run("--tape", "network", "--network", fault) as run:
            self.assertEqual(run.wait(), 20, run.errors)
            result = call("replay", run.directory, "--role", "network")
            self.assertEqual(result.returncode, 20, result.stdout + result.stderr)
            self.assertIn("ADVANCE of interval 9, which was not answered; here came its process was killed by "
                          "signal 11", result.stdout)

    def test_nothing_is_taped_unasked(self):
        with Run("--until", "0.5 s") as run:
            self.assertEqual(run.wait(), 0, run.errors)
            self.assertFalse((run.directory / "tape").exists())
            result = call("replay", run.directory, "--role", "network")
            self.assertEqual(result.returncode, 11)
            self.assertIn("coupler run --tape network", result.stderr)


if __name__ == "__main__":
    unittest.main()
