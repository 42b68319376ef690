# SPDX-License-Identifier: GPL-3.0-or-later
"""A run is watched, stopped, signalled and healed from outside; how it ended is told the same everywhere."""
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

from trio import CASE, COUPLER, PROGRAMS, Run

SMALL = pathlib.Path(__file__).resolve().parents[1] / "cases/fault_small"
LONG = ("--set", 'time.end="1000 s"', "--set", 'output.interval="0.05 s"', "--set", "output.reports_per_segment=1")
BRIEF = ("--until", "0.1 s")
PATIENT = ("--set", 'deadlines.progress="60 s"')


def coupler(*words, **options):
    return subprocess.run([str(word) for word in (COUPLER, *words)], capture_output=True, text=True, timeout=60,
                          **options)


def wait_for_interval(run, interval):
    while json.loads(coupler("status", "--json", run.directory).stdout).get("interval", 0) < interval:
        time.sleep(0.02)


def report(run):
    return json.loads((run.directory / "run.report.json").read_text())


class Ends(unittest.TestCase):
    def check_end(self, run, code, *words):
        self.assertEqual(run.wait(), code, run.errors)
        for word in words:
            self.assertIn(word, run.last_line)
        self.assertEqual(run.pids(), [], "orphans")
        found = report(run)
        self.assertEqual(found["code"], code)
        self.assertEqual(run.errors.splitlines()[-1], found["last_line"], "the last line is the last, and in the report")
        return found


class Watching(Ends):
    def status(self, run):
        answer = coupler("status", "--json", run.directory)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return json.loads(answer.stdout)

    def test_a_run_that_goes_on_tells_where_it_is(self):
        with Run(*LONG) as run:
            run.wait_until_running(segments=2)
            first = self.status(run)
            self.assertEqual(first["state"], "running")
            self.assertEqual(first["pid"], run.process.pid)
            self.assertGreater(first["interval"], 0)
            self.assertEqual(first["end"], 1000)
            self.assertGreater(first["time"], 0)
            self.assertGreater(first["ledger"]["injected"], 0)
            self.assertGreater(first["wall_seconds_left"], 0)
            text = coupler("status", run.directory).stdout
            for word in ("running", "of 1000 s", "drift", "injected", "waits for", "checkpoint"):
                self.assertIn(word, text)

    def test_while_a_participant_is_stopped_the_answer_names_it_at_once(self):
        with Run(*LONG) as run:
            run.wait_until_running(segments=1)
            os.kill(run.pids("network")[0], signal.SIGSTOP)
            time.sleep(0.2)
            seconds = []
            for _ in range(3):  # the least of three: a busy machine may hold one of them
                start = time.monotonic()
                answer = coupler("status", "--json", run.directory)
                seconds.append(time.monotonic() - start)
            found = json.loads(answer.stdout)
            os.kill(run.pids("network")[0], signal.SIGCONT)
            self.assertEqual(found["waits_for"], ["network"])
            network = found["participants"]["network"]
            self.assertEqual((network["asked"], network["process"]), ("ADVANCE", "stopped"))
            self.assertGreater(network["asked_seconds"], 0.1)
            self.assertLess(min(seconds), 0.1)

    def test_a_run_that_ended_tells_how_and_how_to_go_on(self):
        with Run("--fault", "structure@20=kill") as run:
            end = self.check_end(run, 20, "Resume: coupler resume")
            found = self.status(run)
            self.assertEqual(found["state"], "ended")
            self.assertEqual(found["report"], end)
            self.assertIn(end["last_line"], coupler("status", run.directory).stdout)

    def test_a_run_without_a_report_was_killed_and_can_be_resumed(self):
        with Run(*LONG) as run:
            run.wait_until_running()
            run.process.kill()
            run.wait()
            while run.pids():
                time.sleep(0.01)
            found = self.status(run)
            self.assertEqual(found["state"], "killed")
            self.assertEqual(found["resume"], f"coupler resume {run.directory}")
            self.assertIn("left no report", coupler("status", run.directory).stdout)

    def test_what_is_no_run_is_refused(self):
        for command in ("status", "stop"):
            for place in ("/nowhere", tempfile.gettempdir()):
                answer = coupler(command, place)
                self.assertEqual(answer.returncode, 11)
                self.assertIn("is not a run directory", answer.stderr)


class Stopping(Ends):
    def test_stop_from_another_terminal(self):
        with Run(*LONG) as run:
            run.wait_until_running(segments=1)
            answer = coupler("stop", run.directory)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.assertIn("TERMINATED coupler", answer.stdout)
            end = self.check_end(run, 143, "ended at a coupling time, as asked. Resume: coupler resume")
            self.assertEqual(answer.stdout.strip(), end["last_line"])
            again = coupler("stop", run.directory)
            self.assertEqual(again.returncode, 11)
            self.assertIn("is not going on", again.stderr)

    def test_stop_now_ends_a_run_that_comes_to_no_coupling_time(self):
        with Run(*PATIENT, "--fault", "network@20=spin") as run:
            run.wait_until_running()
            wait_for_interval(run, 20)
            late = coupler("stop", "--wait", "0.5", run.directory)
            self.assertEqual(late.returncode, 21)
            self.assertIn("coupler stop --now", late.stderr)
            answer = coupler("stop", "--now", run.directory)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.check_end(run, 143, "ended at once by signal 15")

    def test_a_second_interrupt_ends_at_once(self):
        with Run(*PATIENT, "--fault", "network@20=spin") as run:
            run.wait_until_running()
            wait_for_interval(run, 20)
            run.process.send_signal(signal.SIGINT)
            time.sleep(0.5)
            run.process.send_signal(signal.SIGINT)
            start = time.monotonic()
            self.check_end(run, 130, "INTERRUPTED coupler", "ended at once by signal 2")
            self.assertLess(time.monotonic() - start, 1.5)
            self.assertIn("coupler: stopping at the next coupling time", run.errors)

    def test_a_storm_of_interrupts_is_one(self):
        with Run(*LONG) as run:
            run.wait_until_running(segments=1)
            # Held for the time of the storm, so that no coupling time comes in the middle of it.
            os.kill(run.pids("network")[0], signal.SIGSTOP)
            for _ in range(1000):
                run.process.send_signal(signal.SIGINT)
            os.kill(run.pids("network")[0], signal.SIGCONT)
            self.check_end(run, 130, "ended at a coupling time, as asked")

    def test_the_end_of_the_terminal(self):
        with Run(*LONG) as run:
            run.wait_until_running(segments=1)
            run.process.send_signal(signal.SIGHUP)
            self.check_end(run, 129, "HANGUP", "ended at a coupling time, as asked")

    def test_any_process_that_is_asked_to_end_ends_the_run_cleanly(self):
        for role in ("structure", "network", "coupler"):
            with self.subTest(role), Run(*LONG) as run:
                run.wait_until_running(segments=1)
                os.kill(run.pids(role)[0], signal.SIGTERM)
                self.check_end(run, 143, "ended at a coupling time, as asked")

    def test_every_process_asked_at_once_as_service_managers_do(self):
        with Run(*LONG) as run:
            run.wait_until_running(segments=1)
            for pid in [*run.pids(), run.process.pid]:
                os.kill(pid, signal.SIGTERM)
            self.check_end(run, 143, "ended at a coupling time, as asked")


class Healing(Ends):
    """A small case that is cut by a natural fracture, with a checkpoint every five intervals."""

    def healed(self, *options, **others):
        return Run("--heal", "--set", "checkpoint.intervals=5", *options, case=SMALL, form=None, **others)

    def bytes_of(self, run):
        files = [*sorted((run.directory / "segments").glob("*.h5")), run.directory / "history.csv", run.directory / "ledger.csv"]
        return {file.name: file.read_bytes() for file in files}

    @classmethod
    def setUpClass(cls):
        with Run(case=SMALL, form=None) as run:
            assert run.wait() == 0, run.errors
            cls.undisturbed = cls.bytes_of(cls, run)

    def check_same(self, run, deaths):
        self.assertEqual(run.wait(), 0, run.errors)
        self.assertEqual(run.pids(), [], "orphans")
        found = report(run)
        self.assertEqual((found["code"], found["epoch"], len(found["deaths"])), (0, deaths, deaths))
        self.assertEqual(run.errors.count("coupler: healing: "), deaths)
        self.assertEqual(self.bytes_of(run), self.undisturbed)
        return found

    def test_whoever_dies_the_run_goes_on_to_the_same_bytes(self):
        for role in ("structure", "network", "coupler"):
            with self.subTest(role), self.healed("--fault", f"{role}@23=kill") as run:
                death, = self.check_same(run, 1)["deaths"]
                self.assertEqual((death["participant"], death["interval"], death["checkpoint"]), (role, 23, 20))
                self.assertIn("The run goes on from interval 20 (epoch 1)", run.errors)

    def test_what_hangs_or_sends_nonsense_is_healed_too(self):
        for fault, code in (("network@23=spin", 21), ("structure@23=nan", 23), ("coupler@23=exit", 20)):
            with self.subTest(fault), self.healed("--set", 'deadlines.progress="2 s"', "--fault", fault) as run:
                self.assertEqual(self.check_same(run, 1)["deaths"][0]["code"], code)

    def test_before_the_first_checkpoint_it_begins_again(self):
        with self.healed("--fault", "structure@3=kill") as run:
            self.assertIsNone(self.check_same(run, 1)["deaths"][0]["checkpoint"])
            self.assertIn("The run goes on from the beginning (epoch 1)", run.errors)

    def test_numbers_that_do_not_converge_are_not_healed(self):
        with self.healed("--fault", "structure@23=fail") as run:
            self.assertEqual(len(self.check_end(run, 24, "(from interval 20)")["deaths"]), 1)

    def test_deaths_at_one_place_end_it(self):
        with tempfile.TemporaryDirectory() as home:
            network = pathlib.Path(home) / "network"
            network.write_text("#!/bin/sh\nexit 3\n")
            network.chmod(0o755)
            with self.healed("--network", network) as run:
                found = self.check_end(run, 20, "network ended with exit code 3", "healing ends after 3 deaths")
                self.assertEqual(len(found["deaths"]), 3)

    def test_a_stop_while_it_heals_ends_it_with_a_checkpoint(self):
        with self.healed("--set", 'time.end="100 s"', "--fault", "network@23=kill") as run:
            run.wait_until_running()
            while json.loads(coupler("status", "--json", run.directory).stdout).get("epoch", 0) < 1:
                time.sleep(0.01)
            run.process.send_signal(signal.SIGTERM)
            self.check_end(run, 143, "ended at a coupling time, as asked", "(from interval")


class Leftovers(Ends):
    def test_a_participants_children_go_with_the_run_wherever_they_moved(self):
        with tempfile.TemporaryDirectory() as home:
            mark = pathlib.Path(home) / "pids"
            network = pathlib.Path(home) / "network"
            network.write_text("#!/bin/sh\n"
                               f"(setsid sleep 1000 & echo $! >> {mark})\n"
                               f"setsid sleep 1000 & echo $! >> {mark}\n"
                               f'exec {PROGRAMS}/network "$@"\n')
            network.chmod(0o755)
            for ending in (BRIEF, ("--fault", "structure@20=kill"), ("--fault", "coupler@20=kill")):
                mark.unlink(missing_ok=True)
                with self.subTest(ending[-1]), Run(*ending, "--network", network) as run:
                    run.wait()
                    pids = [int(word) for word in mark.read_text().split()]
                    self.assertEqual(len(pids), 2)
                    self.assertEqual([pid for pid in pids if pathlib.Path(f"/proc/{pid}").exists()], [])


class Surroundings(unittest.TestCase):
    def test_a_log_that_nobody_reads_does_not_end_the_run(self):
        with tempfile.TemporaryDirectory() as home:
            run = pathlib.Path(home) / "run"
            shell = f"set -o pipefail; {COUPLER} run {CASE} --short --until '0.1 s' --out {run} 2>&1 | head -c 1"
            answer = subprocess.run(["bash", "-c", shell], capture_output=True, timeout=60)
            self.assertEqual(answer.returncode, 0)
            self.assertEqual(json.loads((run / "run.report.json").read_text())["code"], 0)

    def test_language_time_zone_mask_home_and_a_lost_folder_change_nothing(self):
        with Run(*BRIEF) as plain, tempfile.TemporaryDirectory() as home:
            self.assertEqual(plain.wait(), 0, plain.errors)
            lost = pathlib.Path(home) / "lost"
            lost.mkdir()
            run = pathlib.Path(home) / "run"
            environment = {"PATH": os.environ["PATH"], "TZ": "Asia/Kathmandu", "LC_ALL": "de_DE.UTF-8"}
            shell = (f"umask 077; cd {lost}; rmdir {lost}; exec {COUPLER} run {CASE} --short --until '0.1 s' "
                     f"--threads 1 --out {run}")
            answer = subprocess.run(["sh", "-c", shell], capture_output=True, text=True, timeout=60, env=environment)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.assertEqual((run / "history.csv").read_bytes(), plain.history())

    def test_under_nohup_the_end_of_the_terminal_is_none(self):
        with tempfile.TemporaryDirectory() as home:
            run = pathlib.Path(home) / "run"
            shell = f"trap '' HUP; exec {COUPLER} run {CASE} --short --until '0.2 s' --out {run}"
            process = subprocess.Popen(["sh", "-c", shell], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            while not (run / "history.csv").exists() and process.poll() is None:
                time.sleep(0.01)
            process.send_signal(signal.SIGHUP)
            self.assertEqual(process.wait(timeout=60), 0)

    def test_a_report_without_room_leaves_the_code_as_it_is(self):
        with Run(*LONG) as run:
            run.wait_until_running(segments=1)
            (run.directory / "run.report.json.part").mkdir()
            os.kill(run.pids("network")[0], signal.SIGKILL)
            self.assertEqual(run.wait(), 20, run.errors)
            self.assertIn("warning: run.report.json is missing", run.errors)
            self.assertIn("PARTICIPANT-DIED network", run.errors.splitlines()[-1])


class Report(Ends):
    def test_a_complete_run_reports_itself(self):
        with Run(*BRIEF) as run:
            self.assertEqual(run.wait(), 0, run.errors)
            found = report(run)
            self.assertEqual((found["code"], found["name"], found["deaths"]), (0, "DONE", []))
            self.assertEqual(found["run_id"], json.loads((run.directory / "run.json").read_text())["run_id"])

    def test_a_failed_run_reports_who_when_where_and_how_to_go_on(self):
        with Run("--fault", "network@20=kill") as run:
            found = self.check_end(run, 20)
            self.assertEqual((found["participant"], found["interval"]), ("network", 20))
            self.assertIn("killed by signal 9", found["cause"])
            self.assertEqual(found["resume"]["command"], f"coupler resume {run.directory}")


if __name__ == "__main__":
    unittest.main()
