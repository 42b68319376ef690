# SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of a plan end the run with the right code and name, or leave no trace; an independent checker judges what is left."""
import concurrent.futures
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from fault_checker import check, report_of, transcript_hash, transcript_of
from trio import COUPLER, ROOT

CASE = ROOT / "tests/cases/fault_small"
SETTINGS = ("--set", 'deadlines.progress="2 s"', "--set", "checkpoint.intervals=5")


def message(role, kind, do, interval=30, **more):
    direction = "to_participant" if kind in ("WELCOME", "INSERT", "ADVANCE", "REPORT", "SAVE", "FINISH") else "to_coupler"
    keys = {"role": role, "direction": direction, "type": kind, "interval": interval, "do": do, **more}
    return "[[message]]\n" + "".join(f"{key} = {written(value)}\n" for key, value in keys.items() if value is not None)


def process(role, phase, do, interval=30, **more):
    keys = {"role": role, "phase": phase, "interval": interval, "do": do, **more}
    return "[[fault]]\n" + "".join(f"{key} = {written(value)}\n" for key, value in keys.items() if value is not None)


def written(value):
    return f'"{value}"' if isinstance(value, str) else str(value)


NOT_A_NUMBER = float("nan")
# plan, exit code, who, words of the last line
ENDING = (
    (message("network", "PRESSURE", "drop"), 21, "network", "made no progress for 2 s"),
    (message("structure", "RESPONSE", "duplicate"), 22, "structure", "RESPONSE of interval 30 came twice"),
    (message("network", "PRESSURE", "truncate"), 22, "network", "damaged"),
    (message("network", "ADVANCE", "truncate", frame=0, bytes=7), 22, "network", "envelope must have 64 bytes, found 7"),
    (message("structure", "RESPONSE", "flip", bit=12345), 22, "structure", "checksum does not fit"),
    (message("network", "PRESSURE", "restamp", stamp="epoch", shift=1), 22, "network", "belongs to epoch 1"),
    (message("structure", "RESPONSE", "restamp", stamp="interval", shift=-1), 22, "structure", "of interval 29"),
    (message("network", "PRESSURE", "poison", field="pressure", index=1, value=NOT_A_NUMBER), 23, "network", "pressure[1] is nan"),
    (message("structure", "ADVANCE", "poison", field="pressure_end", index=0, value=1e12), 23, "structure", "pressure_end of node"),
    (message("network", "PRESSURE", "poison", entry="/ledger/leaked", value=1.0), 24, "coupler", "lost fluid"),
    # All but the numbers in it is right: the stale answer must be known by its interval.
    (message("structure", "RESPONSE", "replay", **{"as": "current"}), 22, "structure", "of interval 29"),
    (message("network", "ADVANCE", "replay", **{"as": "current"}), 22, "network", "begins at"),
    (message("structure", "RESPONSE", "cut"), 21, "structure", "lost its connection to the coupler"),
    (message("network", "ADVANCE", "half_open"), 21, "network", ""),
    (message("structure", "RESPONSE", "nonsense", bytes=100), 22, "structure", "at least 2 frames"),
    (message("network", "INSERT", "drop", None, occurrence=2), 22, "network", "were lost"),
    (process("network", "answer", "kill"), 20, "network", "killed by signal 9"),
    (process("structure", "advance", "segfault"), 20, "structure", "signal 11"),
    (process("network", "advance", "throw"), 70, "network", "injected exception in interval 30"),
    (process("structure", "advance", "exhaust"), 26, "structure", "out of memory"),
    (process("structure", "answer", "nan", field="aperture_rate", index=2), 23, "structure", "aperture_rate[2] is nan"),
    (process("coupler", "checkpoint-commit", "kill", None, occurrence=3), 20, "coupler", "killed by signal 9"),
    (process("coupler", "segment", "kill", None, occurrence=3), 20, "coupler", "killed by signal 9"),
    (process("coupler", "segment", "disk_full", None), 25, "coupler", "No space left on device"),
    (process("coupler", "checkpoint-commit", "rename_error", None), 25, "coupler", "rename"),
)
HARMLESS = (
    message("network", "PRESSURE", "delay", seconds=0.3),
    message("structure", "ADVANCE", "clog", seconds=0.3),
    message("structure", "RESPONSE", "restamp", stamp="minor", value=7),
    process("network", "advance", "stop_for", seconds=0.3),
    process("structure", "advance", "sleep", seconds=0.3),
    "transcript = true\n",
)


class Faults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = pathlib.Path(tempfile.mkdtemp(prefix="fissura-faults-"))
        cls.clean, ended = cls.play(0, "transcript = false\n")
        if ended.returncode != 0:
            raise AssertionError(ended.stderr)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.home, ignore_errors=True)

    @classmethod
    def play(cls, number, plan, *options):
        """The directory of a run with that plan, and how it ended."""
        home = cls.home / str(number)
        home.mkdir()
        (home / "plan.toml").write_text(plan)
        command = [COUPLER, "run", CASE, "--out", home / "run", "--threads", "1", *SETTINGS, *options, "--fault-plan", home / "plan.toml"]
        return home / "run", subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=60)

    def play_all(self, plans):
        """The same of each plan, two at a time."""
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            first = len(list(self.home.iterdir()))
            return list(pool.map(lambda numbered: self.play(*numbered), enumerate(plans, first)))

    def test_a_fault_ends_the_run_with_its_code_and_the_name_of_who_failed(self):
        played = self.play_all([plan for plan, *_ in ENDING])
        for (plan, code, who, words), (run, ended) in zip(ENDING, played):
            with self.subTest(plan):
                last = [line for line in ended.stderr.splitlines() if line.startswith("coupler: ")][-1:]
                self.assertEqual((ended.returncode, report_of(run)["participant"]), (code, who), ended.stderr[-600:])
                self.assertEqual(last, [report_of(run)["last_line"]])
                self.assertIn(words, last[0])
                self.assertEqual(check(run, self.clean, code), [])

    def test_what_is_harmless_leaves_no_trace(self):
        for plan, (run, ended) in zip(HARMLESS, self.play_all(HARMLESS)):
            with self.subTest(plan):
                self.assertEqual(ended.returncode, 0, ended.stderr[-600:])
                self.assertEqual(check(run, self.clean, 0), [])

    def test_the_run_goes_on_from_a_fault_to_the_same_bytes(self):
        plans = (message("network", "PRESSURE", "replay", **{"as": "current"}), process("coupler", "segment", "kill", None, occurrence=3),
                 process("coupler", "checkpoint-commit", "kill", None, occurrence=4))
        for plan, (run, _) in zip(plans, self.play_all(plans)):
            with self.subTest(plan):
                resumed = subprocess.run([COUPLER, "resume", run], capture_output=True, text=True, timeout=60)
                self.assertEqual(resumed.returncode, 0, resumed.stderr[-600:])
                self.assertEqual(check(run, self.clean, 0), [])

    def test_the_same_plan_gives_the_same_transcript(self):
        plan = message("structure", "RESPONSE", "flip", bit=1) + message("network", "ADVANCE", "delay", 12, seconds=0.1)
        hashes = {tuple(transcript_hash(run, role) for role in ("structure", "network")) for run, _ in self.play_all([plan] * 3)}
        self.assertEqual(len(hashes), 1)
        done = [line["did"] for line in transcript_of(self.play("transcript", plan)[0], "structure") if "did" in line]
        self.assertEqual(done, ["flip"])

    def test_a_plan_with_faults_is_told_at_once_and_nothing_starts(self):
        plan = '[[message]]\nrole = "rock"\ndirection = "up"\ntype = "PRESURE"\ndo = "explode"\n[[fault]]\nrole = "network"\nphase = "segment"\n' \
               'do = "nan"\n[[faul]]\n'
        run, ended = self.play("wrong", plan)
        self.assertEqual(ended.returncode, 10)
        for words in (":2:", "structure, network", ":3:", "to_participant, to_coupler", ":4:", 'did you mean "PRESSURE"', ":5:", "drop, duplicate",
                      ":8:", "hello, join, insert", ":9:", "faul", 'did you mean "fault"'):
            self.assertIn(words, ended.stderr)
        self.assertFalse(run.exists())

    def test_the_checker_finds_what_it_looks_for(self):
        run, _ = self.play("forged", process("network", "answer", "kill", 60))
        self.assertEqual(check(run, self.clean, 20), [])
        segment = sorted((run / "segments").glob("*.h5"))[0]
        content = segment.read_bytes()
        segment.write_bytes(content[:-1] + bytes([content[-1] ^ 1]))
        (run / "segments" / "000009.h5.part").write_bytes(b"")
        (run / "run.report.json").write_text((run / "run.report.json").read_text().replace("PARTICIPANT-DIED network", "network died"))
        found = "\n".join(check(run, self.clean, 21))
        for words in ("instead of 21", "is not what the index says", "part of a file", "another form"):
            self.assertIn(words, found)


if __name__ == "__main__":
    unittest.main()
