# SPDX-License-Identifier: GPL-3.0-or-later
"""A fracture that grows is one message to every participant: what is lost, doubled or late is found at the next message."""
import csv
import json
import unittest

from trio import PROGRAMS, ROOT, Run

FAKES = ROOT / "tests/fakes"
GROWING = ("--variant", "free", "--until", "1 s", "--set", 'output.interval="0.5 s"')


def relay(kind, role):
    return f"/usr/bin/python3 {FAKES}/insertion_relay.py {kind} {PROGRAMS}/{role}"


class Broadcast(unittest.TestCase):
    def check(self, kind, role, sentence):
        with self.subTest(f"{kind} for the {role}"), Run(f"--{role}", relay(kind, role), *GROWING) as run:
            self.assertEqual(run.wait(), 22, run.errors)
            self.assertIn(sentence, run.last_line)
            self.assertIn(f"PROTOCOL-VIOLATION {role}", run.last_line)
            self.assertEqual(run.pids(), [])

    def test_lost(self):
        for role in ("structure", "network"):
            self.check("lost", role, "1 message(s) before PROGRESS")

    def test_doubled(self):
        for role in ("structure", "network"):
            self.check("doubled", role, "came twice")

    def test_late(self):
        for role in ("structure", "network"):
            self.check("late", role, "1 message(s) before PROGRESS")

    def test_acknowledged_but_not_taken_over(self):
        with Run("--network", f"/usr/bin/python3 {FAKES}/forgetful_flow_solver.py", *GROWING) as run:
            self.assertEqual(run.wait(), 22, run.errors)
            self.assertIn("network sent ACKNOWLEDGE, which is made for topology revision 2, the network has 3", run.last_line)

    def test_a_relay_that_changes_nothing_changes_no_bit(self):
        histories = []
        for options in ((), ("--network", relay("faithful", "network"))):
            with Run(*options, *GROWING) as run:
                self.assertIn(run.wait(), (0, 1), run.errors)
                histories.append(run.history())
        self.assertEqual(*histories)


class Insertions(unittest.TestCase):
    def test_same_bits_for_one_and_two_threads(self):
        histories = []
        for threads in (1, 2, 2):
            with Run(*GROWING, threads=threads) as run:
                self.assertIn(run.wait(), (0, 1), run.errors)
                self.assertGreater(run.summary()["remeshing"]["insertions"], 4)
                histories.append(run.history())
        self.assertEqual(histories[0], histories[1])
        self.assertEqual(histories[1], histories[2])

    def test_another_flow_solver_grows_the_same_fracture(self):
        lengths = []
        for options in ((), ("--network", f"/usr/bin/python3 {FAKES}/flow_solver.py")):
            with Run(*options, *GROWING) as run:
                self.assertIn(run.wait(), (0, 1), run.errors)
                lengths.append(list(csv.DictReader(run.history().decode().splitlines()))[-1]["half_length"])
        # The fake rounds otherwise, so a wing may be one edge of 0.5 m ahead for a moment: a quarter of it in the half-length.
        self.assertAlmostEqual(float(lengths[0]), float(lengths[1]), delta=0.25)

    def test_the_remesh_ledger_has_a_line_for_each_segment(self):
        with Run(*GROWING) as run:
            self.assertIn(run.wait(), (0, 1), run.errors)
            lines = list(csv.DictReader((run.directory / "remeshing.csv").read_text().splitlines()))
            totals = run.summary()["remeshing"]
            self.assertEqual(len(lines), totals["insertions"])
            self.assertTrue(totals["untouched_identical"])
            for line in lines:
                self.assertEqual(line["hash_before"], line["hash_after"])
                self.assertEqual(len(line["hash_before"]), len(lines[0]["hash_before"]))
                self.assertTrue(line["hash_before"])

    def test_every_report_is_on_the_mesh_it_was_made_with(self):
        import h5py
        with Run(*GROWING) as run:
            self.assertIn(run.wait(), (0, 1), run.errors)
            meshes, reports = {}, []
            for entry in map(json.loads, (run.directory / "segments/index.jsonl").read_text().splitlines()):
                with h5py.File(run.directory / "segments" / entry["file"]) as segment:
                    for name, mesh in segment.get("meshes", {}).items():
                        meshes[int(name)] = (mesh["position"].shape[0], mesh["elements"][:])
                    for report in segment["reports"].values():
                        fields = report["structure"]
                        reports.append((int(report.attrs["geometry"]), fields["displacement"].shape[0],
                                        fields["effective_stress_xx"].shape[0]))
            self.assertGreater(len(meshes), 1)
            for geometry, nodes, elements in reports:
                position, corners = meshes[geometry]
                self.assertEqual((nodes, elements), (position, len(corners)))
                self.assertLess(corners.max(), position)


class DryCases(unittest.TestCase):
    def test_nothing_is_pumped_and_nothing_is_held(self):
        for case in ("softening_bar", "notched_plate"):
            with self.subTest(case), Run("--set", 'output.interval="1 ms"', "--until",
                                         "1 ms", case=ROOT / "cases" / case, form=None) as run:
                self.assertEqual(run.wait(), 0, run.errors)
                for line in csv.DictReader(run.history().decode().splitlines()):
                    for column in ("injected", "in_place", "in_fractures", "inlet_pressure", "well_pressure", "mismatch"):
                        self.assertEqual(float(line[column]), 0, column)


if __name__ == "__main__":
    unittest.main()
