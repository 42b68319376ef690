# SPDX-License-Identifier: GPL-3.0-or-later
"""Hot swap: `coupler stop`, then `coupler resume --network OTHER` goes on with another flow solver from content and topology."""
import json
import pathlib
import subprocess
import tempfile
import unittest

from swapped_run import LEDGER, SwappedRun, pressure_jumps
from trio import CASE, COUPLER, PROGRAMS, ROOT, Run

OWN_STATE_ONLY = f"/usr/bin/python3 {ROOT / 'tests/fakes/deviating_relay.py'} keeps-neutral-state {PROGRAMS / 'network'}"


def called(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300)


class HotSwap(unittest.TestCase):
    def test_goes_on_with_another_solver_and_back(self):
        with SwappedRun("kgd_mixed", ("implicit", "explicit", "implicit"), (150, 320)) as run:
            self.assertEqual(run.code, 0, run.errors[-1])
            history = run.history()
            self.assertEqual([int(k) for k in history["interval"]], list(range(1, len(history["interval"]) + 1)))
            self.assertLess(max(history["relative_residual"]), LEDGER)
            # Both place the fluid in the same cells; an interval moves the pressure more than the change of solver may.
            for jump, before in pressure_jumps(history, run.stopped_after()):
                self.assertLess(jump, max(2 * before, 0.01))

            first, second = run.changes()
            self.assertEqual((first["from"], first["to"]), (second["to"], second["from"]))
            self.assertEqual(run.description()["participants"]["network"], first["from"])
            self.assertEqual([epoch.get("network") for epoch in run.epochs()],
                             [None, *({"from": change["from"], "to": change["to"]} for change in (first, second))])
            told = [event["text"] for event in run.events() if event["event"] == "another solver"]
            self.assertEqual(len(told), 2)
            self.assertIn(told[0], run.errors[1])
            self.assertEqual(json.loads((run.directory / "run.report.json").read_text())["network_changes"], run.changes())
            verified = called(COUPLER, "verify", run.directory)
            self.assertEqual(verified.returncode, 0, verified.stdout)
            self.assertIn("any flow solver can go on", verified.stdout)
            page = run.home / "report.html"
            self.assertEqual(called(COUPLER, "report", run.directory, "--out", page).returncode, 0)
            self.assertIn(first["to"], page.read_text())

    def test_the_same_solver_goes_on_with_its_own_state(self):
        with SwappedRun("kgd_mixed", ("implicit", "implicit"), (200,)) as run, Run("--network", "implicit") as clean:
            self.assertEqual((run.code, clean.wait()), (0, 0))
            self.assertEqual((run.directory / "history.csv").read_bytes(), clean.history())
            self.assertEqual(run.changes(), [])

    def test_later_lives_are_those_of_the_new_solver(self):
        """Killed after the swap, before a checkpoint of the new solver, and healed; then resumed without a word."""
        with tempfile.TemporaryDirectory(prefix="fissura-test-") as folder:
            run = pathlib.Path(folder) / "run"
            called(COUPLER, "run", CASE, "--short", "--out", run, "--set", "checkpoint.intervals=100", "--fault", "structure@250=kill")
            plan = pathlib.Path(folder) / "plan.toml"
            plan.write_text("".join(f'[[fault]]\nrole = "structure"\nphase = "advance"\ninterval = {interval}\nepoch = {epoch}\ndo = "kill"\n'
                                    for epoch, interval in ((1, 260), (2, 450))))
            healed = called(COUPLER, "resume", run, "--network", "uniform", "--heal", "--fault-plan", plan)
            self.assertIn(healed.returncode, (0, 1), healed.stderr)
            changes = json.loads((run / "run.json").read_text())["network_changes"]
            self.assertEqual([(change["interval"], change["epoch"]) for change in changes], [(200, 2)])
            self.assertIn("uniform", changes[0]["to"])

    def test_a_solver_that_cannot_is_refused_and_the_old_one_goes_on(self):
        with tempfile.TemporaryDirectory(prefix="fissura-test-") as folder, Run(case=ROOT / "cases/kgd_power_law") as clean:
            run = pathlib.Path(folder) / "run"
            called(COUPLER, "run", ROOT / "cases/kgd_power_law", "--short", "--out", run, "--set", "checkpoint.intervals=100",
                   "--fault", "structure@250=kill")
            refused = called(COUPLER, "resume", run, "--network", "uniform")
            self.assertEqual(refused.returncode, 13, refused.stderr)
            self.assertIn("power_law", refused.stderr)
            self.assertEqual(called(COUPLER, "resume", run).returncode, 0)
            self.assertEqual(clean.wait(), 0)
            self.assertNotIn("network_changes", json.loads((run / "run.json").read_text()))

    def test_without_a_neutral_state_only_the_solver_itself_goes_on(self):
        with tempfile.TemporaryDirectory(prefix="fissura-test-") as folder:
            run = pathlib.Path(folder) / "run"
            called(COUPLER, "run", CASE, "--short", "--out", run, "--network", OWN_STATE_ONLY, "--set", "checkpoint.intervals=100",
                   "--fault", "structure@250=kill")
            refused = called(COUPLER, "resume", run, "--network", "explicit")
            self.assertEqual(refused.returncode, 27, refused.stderr)
            self.assertIn("no neutral state", refused.stderr)
            self.assertEqual(called(COUPLER, "resume", run).returncode, 0)

    def test_a_solver_without_neutral_state_does_not_take_over(self):
        with tempfile.TemporaryDirectory(prefix="fissura-test-") as folder:
            run = pathlib.Path(folder) / "run"
            called(COUPLER, "run", CASE, "--short", "--out", run, "--set", "checkpoint.intervals=100", "--fault", "structure@250=kill")
            refused = called(COUPLER, "resume", run, "--network", OWN_STATE_ONLY)
            self.assertEqual(refused.returncode, 13, refused.stderr)
            self.assertIn("neutral_state", refused.stderr)
            self.assertEqual(called(COUPLER, "resume", run).returncode, 0)


if __name__ == "__main__":
    unittest.main()
