# SPDX-License-Identifier: GPL-3.0-or-later
"""A process that dies, stops or hangs ends the run with its name, the time and the reason; nothing is left behind."""
import signal
import time
import unittest

from trio import Run

LONG = ("--set", 'time.end="1000 s"', "--set", 'output.interval="0.05 s"', "--set", "output.reports_per_segment=1")
SHORT_DEADLINE = ("--set", 'deadlines.progress="2 s"')


class DyingProcesses(unittest.TestCase):
    def check_end(self, run, code, *words):
        found = run.wait()
        self.assertEqual(found, code, run.errors)
        for word in words:
            self.assertIn(word, run.last_line)
        self.assertEqual(run.pids(), [], "orphans")

    def check_readable(self, run):
        segments = sorted((run.directory / "segments").glob("*.h5"))
        self.assertTrue(segments, "no closed segment")
        import h5py
        for segment in segments:
            with h5py.File(segment, "r") as file:
                self.assertTrue(list(file.keys()))

    def disturb(self, role, signal_number):
        run = Run(*LONG, *SHORT_DEADLINE)
        run.wait_until_running(segments=1)
        run.process_signalled = run.pids(role)
        self.assertTrue(run.process_signalled)
        import os
        os.kill(run.process_signalled[0], signal_number)
        return run

    def test_killed_structure(self):
        with self.disturb("structure", signal.SIGKILL) as run:
            self.check_end(run, 20, "PARTICIPANT-DIED structure", "killed by signal 9", "interval")
            self.check_readable(run)
            self.assertEqual(run.summary()["failure"]["participant"], "structure")

    def test_killed_network(self):
        with self.disturb("network", signal.SIGKILL) as run:
            self.check_end(run, 20, "PARTICIPANT-DIED network", "killed by signal 9", "interval")
            self.check_readable(run)

    def test_killed_worker(self):
        with self.disturb("coupler", signal.SIGKILL) as run:
            self.check_end(run, 20, "PARTICIPANT-DIED coupler", "killed by signal 9", "interval")
            self.check_readable(run)

    def test_stopped_structure(self):
        with self.disturb("structure", signal.SIGSTOP) as run:
            self.check_end(run, 21, "PARTICIPANT-UNRESPONSIVE structure", "stopped by a signal")
            self.check_readable(run)

    def test_stopped_network(self):
        with self.disturb("network", signal.SIGSTOP) as run:
            self.check_end(run, 21, "PARTICIPANT-UNRESPONSIVE network", "stopped by a signal")

    def test_stopped_worker(self):
        with self.disturb("coupler", signal.SIGSTOP) as run:
            self.check_end(run, 21, "PARTICIPANT-UNRESPONSIVE coupler", "stopped by a signal")
            self.check_readable(run)

    def test_supervisor_killed_leaves_no_orphan(self):
        with Run(*LONG) as run:
            run.wait_until_running()
            run.process.kill()
            run.wait()
            deadline = time.monotonic() + 20
            while run.pids() and time.monotonic() < deadline:
                time.sleep(0.05)
            self.assertEqual(run.pids(), [])

    def test_endless_loops(self):
        for role in ("structure", "network", "coupler"):
            with self.subTest(role), Run(*SHORT_DEADLINE, "--fault", role + "@20=spin") as run:
                self.check_end(run, 21, "PARTICIPANT-UNRESPONSIVE " + role, "made no progress for 2 s", "20")

    def test_leaving_early_with_success(self):
        with Run("--fault", "network@20=exit") as run:
            self.check_end(run, 20, "network ended early with the exit code of success")

    def test_a_solver_that_fails_says_why_itself(self):
        with Run("--fault", "structure@20=fail") as run:
            self.check_end(run, 24, "NUMERICAL-FAILURE structure", "injected failure in interval 20")

    def test_a_short_stop_is_survived(self):
        import os
        with Run() as run:
            run.wait_until_running()
            pids = run.pids("network")
            if pids:
                os.kill(pids[0], signal.SIGSTOP)
                time.sleep(0.5)
                os.kill(pids[0], signal.SIGCONT)
            self.assertEqual(run.wait(), 0, run.errors)

    def test_interrupt_ends_at_a_coupling_time_with_files_closed(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(code), Run(*LONG) as run:
                run.wait_until_running(segments=1)
                run.process.send_signal(number)
                self.assertEqual(run.wait(), code, run.errors)
                self.assertEqual(run.pids(), [])
                self.check_readable(run)
                self.assertEqual(run.summary()["verdict"], "none")


class Start(unittest.TestCase):
    def test_a_program_that_does_not_exist(self):
        with Run("--network", "/nowhere/solver") as run:
            self.assertEqual(run.wait(), 11, run.errors)
            self.assertIn("network cannot be started: /nowhere/solver: No such file or directory", run.last_line)

    def test_a_program_that_never_says_hello(self):
        with Run("--network", "sleep 100 #", "--set", 'deadlines.join="1 s"') as run:
            self.assertEqual(run.wait(), 21, run.errors)
            self.assertIn("network did not introduce itself in 1 s", run.last_line)

    def test_a_directory_in_use(self):
        with Run(*LONG) as first:
            first.wait_until_running()
            import subprocess
            from trio import CASE, COUPLER
            second = subprocess.run([COUPLER, "run", CASE, "--short", "--out", first.directory],
                                    capture_output=True, text=True, timeout=30)
            self.assertEqual(second.returncode, 12, second.stderr)
            self.assertIsNone(first.process.poll(), "the first run was disturbed")


if __name__ == "__main__":
    unittest.main()
