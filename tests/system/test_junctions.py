# SPDX-License-Identifier: GPL-3.0-or-later
"""Fractures that meet: two tips, a tip and another fracture, and several that grow at once; with any number of threads."""
import collections
import csv
import pathlib
import tempfile
import unittest

import h5py

from test_results import field_hash
from trio import Run

ROCK = """
schema = 1
title = "fractures that meet"
[time]
end = "{end} s"
[domain]
width = "120 m"
height = "120 m"
thickness = "1 m"
[mesh]
fracture_size = "0.5 m"
far_size = "8 m"
corridor = "1.5 m"
gradation = 0.25
[growth]
path = "free"
[rock]
density = "2500 kg/m^3"
youngs_modulus = "32 GPa"
poissons_ratio = 0.2
tensile_strength = "1 MPa"
fracture_energy = "50 N/m"
[in_situ]
sign = "compression_positive"
maximum_horizontal_stress = "{stress} MPa"
minimum_horizontal_stress = "5 MPa"
vertical_stress = "5 MPa"
maximum_horizontal_azimuth = "90 degree"
pore_pressure = "0 MPa"
[boundary]
west = {{ kind = "fixed" }}
east = {{ kind = "fixed" }}
south = {{ kind = "fixed" }}
north = {{ kind = "fixed" }}
[[fluid]]
name = "slickwater"
viscosity = "1.67e-3 Pa s"
bulk_modulus = "2 GPa"
[[injection.stage]]
begin = "0 s"
rate = "1e-3 m^3/s"
fluid = "slickwater"
[output]
interval = "0.5 s"
"""


def line(kind, name, begin, end):
    friction = "friction_coefficient = 0.6\n" if kind == "natural" else ""
    return f"""
[[fracture]]
name = "{name}"
kind = "{kind}"
{friction}points = [["{begin[0]} m", "{begin[1]} m"], ["{end[0]} m", "{end[1]} m"]]
"""


def slit(name, begin, end):
    """An open line with a perforation in its middle."""
    return line("open", name, begin, end) + f"""
[[injection.perforation]]
name = "perforation of {name}"
position = ["{(begin[0] + end[0]) / 2} m", "{(begin[1] + end[1]) / 2} m"]
aperture = "10 um"
"""


TIP_TO_TIP = ROCK.format(end=4, stress=7) + slit("west", (-5, 0), (-3, 0)) + slit("east", (3, 0.1), (5, 0.1))
ONTO_A_FAULT = ROCK.format(end=6, stress=5) + slit("slit", (-1, 0), (1, 0)) + line("natural", "fault", (3.6, -2.9), (3.6, 3.1))
SEVERAL = ROCK.format(end=3, stress=7) + "".join(slit(f"at {y} m", (-1, y), (1, y)) for y in (-12, 0, 12)) + """
[coupling]
minimum_steps = 60
maximum_steps = 80
"""  # long intervals, so that several tips are due at once


class Network:
    """The last network of a run."""

    def __init__(self, directory):
        with h5py.File(max((directory / "segments").glob("*.h5"))) as segment:
            network = segment["networks"][max(segment["networks"])]
            report = segment["reports"][max(segment["reports"])]
            self.nodes = range(len(network["id"]))
            self.segments = [tuple(pair) for pair in network["segments"]]  # positions in the arrays over the nodes
            self.natural = [kind == 1 for kind in network["segment_kind"]]
            self.content = report["network/content"][:]
        self.degree = collections.Counter(node for pair in self.segments for node in pair)

    def pieces(self):
        """Number of connected parts."""
        neighbours = collections.defaultdict(set)
        for a, b in self.segments:
            neighbours[a].add(b)
            neighbours[b].add(a)
        left, count = set(self.nodes), 0
        while left:
            front, count = [left.pop()], count + 1
            while front:
                for node in neighbours[front.pop()] & left:
                    left.remove(node)
                    front.append(node)
        return count


class Meeting(unittest.TestCase):
    def run_twice(self, text, check):
        """With one and two threads; `check` looks at the run directory and the summary."""
        found = []
        with tempfile.TemporaryDirectory() as home:
            folder = pathlib.Path(home) / "case"
            folder.mkdir()
            (folder / "case.toml").write_text(text)
            for threads in (1, 2):
                with Run(case=folder, form=None, threads=threads) as run:
                    # Had a participant another network after an insertion, its hash would have ended the run.
                    self.assertEqual(run.wait(120), 0, run.errors)
                    summary = run.summary()
                    self.assertLess(summary["ledger"]["max_relative_residual"], 1e-12)
                    remeshing = summary["remeshing"]
                    self.assertTrue(remeshing["untouched_identical"])
                    self.assertGreaterEqual(remeshing["smallest_step_ratio"], 0.5)
                    self.assertLess(remeshing["largest_mass_error"], 1e-14)
                    self.assertLess(remeshing["largest_momentum_error"], 1e-13)
                    self.assertGreater(remeshing["smallest_angle"], 0.25)
                    check(run, summary)
                    found.append((run.history(), field_hash(run.directory)))
        self.assertEqual(found[0], found[1], "1 and 2 threads differ")

    def test_two_tips_become_one_fracture(self):
        def check(run, _):
            network = Network(run.directory)
            self.assertEqual(network.pieces(), 1)
            ends = [node for node in network.nodes if network.degree[node] == 1]
            self.assertEqual(len(ends), 2)
            self.assertEqual(max(network.degree.values()), 2)

        self.run_twice(TIP_TO_TIP, check)

    def test_fluid_enters_the_fracture_that_was_met(self):
        def check(run, _):
            network = Network(run.directory)
            self.assertEqual(network.pieces(), 1)
            meetings = list(csv.DictReader((run.directory / "meetings.csv").read_text().splitlines()))
            self.assertEqual([entry["natural"] for entry in meetings], ["fault"])
            self.assertEqual(meetings[0]["crosses"], "1")
            # Four arms once the fracture goes on beyond.
            self.assertEqual([degree for degree in network.degree.values() if degree > 2], [4])
            on_fault = [pair for pair, natural in zip(network.segments, network.natural) if natural]
            self.assertGreaterEqual(len(on_fault), 4)
            junction = max(network.degree, key=network.degree.get)
            for node in {node for pair in on_fault for node in pair if junction in pair}:
                self.assertGreater(network.content[node], 0)

        self.run_twice(ONTO_A_FAULT, check)

    def test_several_fractures_grow_at_once(self):
        def check(run, summary):
            rows = list(csv.DictReader((run.directory / "remeshing.csv").read_text().splitlines()))
            self.assertEqual(len(rows), summary["remeshing"]["insertions"])
            self.assertEqual({row["fracture"] for row in rows}, {f"growth of at {y} m" for y in (-12, 0, 12)})
            at_once = collections.Counter(row["revision"] for row in rows)
            self.assertGreaterEqual(max(at_once.values()), 2)
            self.assertEqual(Network(run.directory).pieces(), 3)

        self.run_twice(SEVERAL, check)


if __name__ == "__main__":
    unittest.main()
