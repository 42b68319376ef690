# SPDX-License-Identifier: GPL-3.0-or-later
"""The flow in natural fractures, as two flow solvers that share no code see it."""
import csv
import unittest

from trio import ROOT, Run

FAKES = ROOT / "tests/fakes"


def last_line(*options):
    """Of history.csv, 1 s after the hydraulic fracture has reached the natural one."""
    with Run("--until", "3.5 s", *options, case=ROOT / "cases/crossing", form=None) as run:
        if run.wait() not in (0, 1):
            raise AssertionError(run.errors)
        return list(csv.DictReader(run.history().decode().splitlines()))[-1]


class NaturalFractures(unittest.TestCase):
    def test_two_flow_solvers_find_and_press_the_same_pore_fluid(self):
        ours = last_line()
        other = last_line("--network", f"/usr/bin/python3 {FAKES}/flow_solver.py")
        self.assertGreater(float(ours["found"]), 0)
        self.assertAlmostEqual(float(other["found"]) / float(ours["found"]), 1, delta=1e-12)
        # Rounding grows to a fraction of the mismatch of one interval.
        for column in ("inlet_pressure", "junction_pressure", "in_fractures"):
            self.assertAlmostEqual(float(other[column]) / float(ours[column]), 1, delta=2e-3, msg=column)


if __name__ == "__main__":
    unittest.main()
