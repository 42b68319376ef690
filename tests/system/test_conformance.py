# SPDX-License-Identifier: GPL-3.0-or-later
"""The conformance kit passes the built-in solver also behind a relay that changes nothing, and fails the check that is meant where the
relay breaks a promise."""
import json
import pathlib
import subprocess
import tempfile
import unittest

from trio import COUPLER, PROGRAMS, ROOT

# What the relay breaks, and a check that must find it.
BROKEN = {
    "takes-any-version": "message.other_major_version",
    "takes-damaged": "message.damaged_array",
    "forgives-gaps": "message.lost",
    "swallows-nan": "values.nan_aperture",
    "stale-revision": "insertion.tip_growth",
    "old-hash": "insertion.junction",
    "loses-fluid": "insertion.twenty_times",
    "restores-roughly": "state.bit_identical",
    "silent-about-figures": "end.finish",
    "gives-no-reason": "order.advance_before_insert",
    "ends-with-one": "order.second_welcome",
    "deaf": "signal.stop",
    "stays": "deadline.coupler_gone",
}


def conform(*words):
    """Exit code, report and what was printed."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "report.json"
        done = subprocess.run([str(COUPLER), "conform", "--json", str(file), *words], capture_output=True, text=True,
                              timeout=300)
        return done.returncode, json.loads(file.read_text()) if file.exists() else None, done.stdout + done.stderr


def behind_relay(kind):
    return ["/usr/bin/python3", str(ROOT / "tests/fakes/deviating_relay.py"), kind, str(PROGRAMS / "network")]


class Conformance(unittest.TestCase):
    def test_a_relay_that_changes_nothing_passes(self):
        for check in BROKEN.values():
            with self.subTest(check):
                code, report, printed = conform("--only", check, *behind_relay("faithful"))
                self.assertEqual(code, 0, printed)
                self.assertEqual(report["passed"], 1)

    def test_what_a_relay_breaks_is_found(self):
        for kind, check in BROKEN.items():
            with self.subTest(kind):
                code, report, printed = conform("--only", check, *behind_relay(kind))
                self.assertEqual(code, 1, printed)
                [outcome] = report["checks"]
                self.assertEqual((outcome["name"], outcome["verdict"]), (check, "failed"))
                self.assertIn("expected  ", printed)
                self.assertTrue(outcome["obtained"] and outcome["contract"].startswith("flow_solvers.md "), outcome)

    def test_a_program_that_does_not_greet(self):
        code, report, printed = conform("/bin/true")
        self.assertEqual((code, report), (1, None))
        self.assertIn("HELLO", printed)

    def test_a_name_that_no_check_has(self):
        code, _, printed = conform("--only", "no_such_check", "/bin/true")
        self.assertEqual(code, 2)
        self.assertIn("no_such_check", printed)

    def test_nothing_is_left_behind(self):
        # A shell of its own, so that the solver is a grandchild that the kit has not started itself.
        code, _, printed = conform("--only", "handshake.hello", f"/bin/sh -c '{PROGRAMS}/network \"$@\" & sleep 299.17' sh")
        self.assertEqual(code, 0, printed)
        running = subprocess.run(["/bin/ps", "-eo", "args"], capture_output=True, text=True).stdout
        self.assertNotIn("sleep 299.17", running)


if __name__ == "__main__":
    unittest.main()
