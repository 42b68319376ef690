# SPDX-License-Identifier: GPL-3.0-or-later
"""A participant that sends nonsense ends the run at that message, with a sentence that names it and what is wrong."""
import unittest

from trio import ROOT, Run

FAKE = "/usr/bin/python3 " + str(ROOT / "tests/fakes/misbehaving_network.py") + " "

EXPECTED = {
    "garbage": (22, "envelope must have 64 bytes"),
    "damaged": (22, "checksum does not fit"),
    "lost": (22, "1 message(s) before PRESSURE of interval 1 were lost"),
    "doubled": (22, "came twice"),
    "foreign": (22, "belongs to another run"),
    "stale": (22, "came twice"),
    "wrong-type": (22, "unknown message type 999"),
    "wrong-length": (22, "pressure has 4"),
    "wrong-revision": (22, "is made for topology revision 1, the network has 0"),
    "wrong-hash": (22, "has another fracture network after revision 0"),
    "negative-aperture": (23, "aperture_predicted of node"),
    "absurd-pressure": (23, "pressure of node"),
    "unconverged": (24, "have not converged"),
    "leaking": (24, "the network lost fluid"),
    "silent": (21, "made no progress for 2 s"),
    "other-version": (22, "peer speaks protocol 2.0"),
}


class Nonsense(unittest.TestCase):
    def test_each_kind(self):
        for kind, (code, sentence) in EXPECTED.items():
            with self.subTest(kind), Run("--network", FAKE + kind, "--set", 'deadlines.progress="2 s"') as run:
                self.assertEqual(run.wait(), code, run.errors)
                self.assertIn(sentence, run.last_line)
                self.assertEqual(run.pids(), [])

    def test_a_case_that_the_solver_does_not_claim_to_solve(self):
        with Run("--network", FAKE + "unclaimed", case=ROOT / "cases/kgd_leak_off") as run:
            self.assertEqual(run.wait(), 13, run.errors)
            self.assertIn("this case needs leak_off, which misbehaving does not claim", run.last_line)

    def test_values_that_are_not_finite(self):
        for role in ("structure", "network"):
            with self.subTest(role), Run("--fault", role + "@20=nan") as run:
                self.assertEqual(run.wait(), 23, run.errors)
                self.assertIn("[0] is nan", run.last_line)
                self.assertIn("interval 20", run.last_line)


if __name__ == "__main__":
    unittest.main()
