# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Python client works out by itself; the conversation is tried by `coupler conform`."""
import math
import unittest

import numpy

import fissura_participant as fissura


def node(name, length, role=0, exposure_time=0.0, x=0.0):
    return {"id": name, "x": x, "y": 0.0, "lumped_length": length, "fracture": 1, "role": role, "exposure_time": exposure_time}


def segment(name, a, b, length=1.0):
    return {"id": name, "node_a": a, "node_b": b, "length": length, "fracture": 1, "kind": 0}


def insertion(revision, **changes):
    empty = {key: [] for key in ("updated_nodes", "new_nodes", "removed_segments", "new_segments", "new_perforations")}
    return {**empty, "revision": revision, **changes}


def slit():
    """Three nodes, told in another order than that of their ids."""
    return fissura.Network([insertion(0, new_nodes=[node(30, 0.5), node(20, 1.0), node(10, 0.5, role=1)],
                                      new_segments=[segment(7, 30, 20), segment(8, 10, 20)], new_perforations=[{"name": "well", "node": 30}])])


def growth():
    return insertion(1, updated_nodes=[node(10, 1.0)], new_nodes=[node(40, 0.5, role=1, exposure_time=0.1)], new_segments=[segment(9, 10, 40)])


def case(**injection):
    stages = [{"begin": 0.0, "control": "rate", "rate": 0.01, "ramp": 0.0, "pressure": 0.0, "fluid": "gel"}]
    return {"domain": {"thickness": 10.0}, "leak_off": {"coefficient": 1e-6, "spurt_volume": 0.0},
            "fluids": [{"name": "gel", "consistency_index": 0.02, "power_index": 1.0, "bulk_modulus": 2e9}],
            "injection": {"well_index": 1e-8, "perforations": [{"name": "well"}], "stages": stages, **injection},
            "network": {"minimum_aperture": 1e-5, "tolerance": 1e-10, "maximum_iterations": 100}}


class Networks(unittest.TestCase):
    def test_arrays_are_in_the_order_of_insertion(self):
        network = slit()
        self.assertEqual([each["id"] for each in network.nodes], [30, 20, 10])
        self.assertEqual(network.ends.tolist(), [[0, 1], [2, 1]])
        self.assertEqual(network.wells.tolist(), [0])
        network.apply(growth())
        self.assertEqual(network.lumped_length.tolist(), [0.5, 1.0, 1.0, 0.5])
        self.assertEqual(network.ends[-1].tolist(), [2, 3])

    def test_an_insertion_that_does_not_fit_changes_nothing(self):
        network = slit()
        before = network.hash()
        for wrong in (insertion(2), insertion(1, updated_nodes=[node(99, 1.0)]), insertion(1, new_nodes=[node(20, 1.0)]),
                      insertion(1, removed_segments=[99]), insertion(1, new_segments=[segment(7, 30, 10)]),
                      insertion(1, new_segments=[segment(9, 30, 99)]), insertion(1, updated_nodes=[node(20, -1.0)]),
                      insertion(1, new_perforations=[{"name": "well", "node": 99}]), {"revision": 1}):
            with self.subTest(wrong), self.assertRaises(fissura.ProtocolFault):
                network.apply(wrong)
            self.assertEqual(network.hash(), before)

    def test_a_segment_that_was_removed_does_not_come_back(self):
        network = slit()
        network.apply(insertion(1, removed_segments=[7]))
        with self.assertRaises(fissura.ProtocolFault):
            network.apply(insertion(2, new_segments=[segment(7, 30, 20)]))


class Insertions(unittest.TestCase):
    def moved(self, network, values, change):
        old = network.lumped_length
        network.apply(change)
        result = fissura.moved(numpy.array(values), old, network)
        self.assertAlmostEqual(float(result @ network.lumped_length), float(numpy.array(values) @ old), places=15)
        return result.tolist()

    def test_a_tip_that_grows_keeps_its_fluid_on_more_length(self):
        self.assertEqual(self.moved(slit(), [1.0, 2.0, 4.0], growth()), [1.0, 2.0, 2.0, 0.0])

    def test_a_split_segment_gives_the_new_node_what_stood_on_the_length(self):
        split = insertion(1, updated_nodes=[node(30, 0.25), node(20, 0.75)], new_nodes=[node(40, 0.5)], removed_segments=[7],
                          new_segments=[segment(9, 30, 40, 0.5), segment(11, 40, 20, 0.5)])
        self.assertEqual(self.moved(slit(), [1.0, 2.0, 4.0], split), [1.0, 2.0, 4.0, 1.5])

    def test_a_node_that_is_shortened_without_a_new_one_keeps_its_fluid(self):
        self.assertEqual(self.moved(slit(), [1.0, 2.0, 4.0], insertion(1, updated_nodes=[node(20, 0.5)])), [1.0, 4.0, 4.0])


class Cases(unittest.TestCase):
    def test_rates_are_per_thickness(self):
        read = fissura.FlowCase.read(case())
        self.assertEqual((read.stages[0].target, read.stages[0].control, read.dry), (0.001, "rate", False))

    def test_numbers_outside_their_range_are_named(self):
        for path, value, words in ((("domain", "thickness"), 0.0, "thickness"), (("network", "minimum_aperture"), -1.0, "minimum_aperture"),
                                   (("leak_off", "coefficient"), math.nan, "coefficient"), (("injection", "well_index"), math.inf, "well_index")):
            wrong = case()
            wrong[path[0]][path[1]] = value
            with self.subTest(path), self.assertRaisesRegex(fissura.InputFault, words):
                fissura.FlowCase.read(wrong)

    def test_a_case_that_lacks_a_key_is_no_case(self):
        wrong = case()
        del wrong["network"]["tolerance"]
        with self.assertRaises(fissura.ProtocolFault):
            fissura.FlowCase.read(wrong)

    def test_without_perforations_and_stages_it_is_dry(self):
        self.assertTrue(fissura.FlowCase.read(case(perforations=[], stages=[])).dry)


class Schedule(unittest.TestCase):
    stage = fissura.Stage(begin=10.0, control="rate", target=3.0, ramp=4.0, fluid=0)

    def test_a_ramp_begins_at_what_the_well_did(self):
        self.assertEqual([self.stage.target_at(time, 1.0) for time in (10.0, 12.0, 14.0, 99.0)], [1.0, 2.0, 3.0, 3.0])

    def test_the_mean_over_the_end_of_a_ramp_is_exact(self):
        self.assertAlmostEqual(self.stage.mean_target(12.0, 16.0, 1.0), (2 * 2.5 + 2 * 3.0) / 4, places=14)
        self.assertAlmostEqual(self.stage.mean_target(20.0, 21.0, 1.0), 3.0, places=14)

    def test_a_stage_is_in_force_from_its_begin(self):
        stages = [{"begin": 1.0, "control": "rate", "rate": 1.0, "ramp": 0.0, "pressure": 0.0, "fluid": "gel"},
                  {"begin": 2.0, "control": "shut_in", "rate": 0.0, "ramp": 0.0, "pressure": 0.0, "fluid": ""}]
        read = fissura.FlowCase.read(case(stages=stages))
        self.assertIsNone(read.stage_from(0.5))
        self.assertEqual([read.stage_from(time).begin for time in (1.0, 1.9, 2.0, 9.0)], [1.0, 1.0, 2.0, 2.0])
        self.assertEqual([read.next_change(time) for time in (0.0, 1.0, 2.0)], [1.0, 2.0, math.inf])


class Neutral(unittest.TestCase):
    def state(self):
        return fissura.NeutralState(time=2.0, started=True, content=numpy.array([1e-3, 0.0]), pressure=numpy.array([1e6, 0.0]),
                                    leaked=numpy.array([1e-6, 0.0]), exposure_time=numpy.array([0.5, math.inf]),
                                    ledger=fissura.Ledger(1.0, 2.0, 3.0, 4.0, 5.0, 6.0), well_pressure=7.0, rate=8.0, entry_rate=9.0)

    def message(self):
        body, arrays = fissura.neutral_entries(self.state(), 2)
        return fissura.Message("RESTORE", body, {name: (unit, numpy.asarray(array, "<f8")) for name, (unit, array) in arrays.items()})

    def test_it_comes_back_as_it_was_told(self):
        told, back = self.state(), fissura.neutral_state_of(self.message(), 2, 2)
        for name in ("content", "pressure", "leaked", "exposure_time"):
            self.assertEqual(getattr(back, name).tolist(), getattr(told, name).tolist())
        self.assertEqual((back.time, back.started, back.ledger, back.entry_rate), (told.time, told.started, told.ledger, told.entry_rate))
        self.assertEqual(back.fluid_fraction.tolist(), [[1.0, 0.0], [1.0, 0.0]])
        self.assertEqual(back.joining.tolist(), [False, False])

    def test_what_cannot_be_is_refused(self):
        for name in ("content", "leaked", "pressure"):
            message = self.message()
            message.arrays["neutral_" + name][1][0] = -1.0
            with self.subTest(name), self.assertRaises(fissura.ValueFault):
                fissura.neutral_state_of(message, 2, 2)
        with self.assertRaises(fissura.ProtocolFault):
            fissura.neutral_state_of(self.message(), 3, 2)


if __name__ == "__main__":
    unittest.main()
