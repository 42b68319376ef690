# SPDX-License-Identifier: GPL-3.0-or-later
"""The catalogue of a run: the same for any number of threads, made again byte by byte, and completed after a death."""
import csv
import pathlib
import subprocess
import unittest

from trio import COUPLER, Run

PLACE = [word for key, value in (("latitude", "56.7 degree"), ("longitude", "-120.5 degree"), ("depth", "2500 m"),
                                 ("start", "2026-01-31T12:00:00Z")) for word in ("--set", f'georeference.{key}="{value}"')]
FILES = ("catalogue.csv", "catalogue.h5", "catalogue.vtp", "catalogue.xml", "summary.json")


def rebuild(run, *words):
    return subprocess.run([COUPLER, "seismicity", run.directory, *words], capture_output=True, text=True)


def rows(folder):
    with open(pathlib.Path(folder) / "catalogue.csv", newline="", encoding="utf-8") as text:
        return list(csv.DictReader(text))


class Catalogue(unittest.TestCase):
    def test_threads_and_rebuilding(self):
        found = []
        for threads in (1, 2):
            with Run(*PLACE, threads=threads) as run:
                self.assertEqual(run.wait(120), 0, run.errors)
                own = run.directory / "seismicity"
                found.append((own / "catalogue.csv").read_bytes())
                result = rebuild(run)
                self.assertEqual(result.returncode, 0, result.stderr)
                for name in FILES:
                    self.assertEqual((run.directory / "seismicity_rebuilt" / name).read_bytes(), (own / name).read_bytes(), name)
        self.assertEqual(found[0], found[1], "1 and 2 threads differ")
        self.assertGreater(found[0].count(b"\n"), 10)

    def test_a_run_that_died(self):
        with Run(*PLACE) as whole, Run(*PLACE, "--set", "output.reports_per_segment=1", "--fault", "coupler@350=kill") as died:
            self.assertEqual(whole.wait(120), 0, whole.errors)
            self.assertNotEqual(died.wait(120), 0)
            self.assertFalse((died.directory / "seismicity/catalogue.xml").exists())
            result = rebuild(died, "--out", died.directory / "seismicity")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertTrue((died.directory / "seismicity/catalogue.xml").exists())
            everything, some = rows(whole.directory / "seismicity"), rows(died.directory / "seismicity")
            self.assertGreater(len(some), 5)
            self.assertLess(len(some), len(everything))
            # What was still open when the last segment closed ends early; all that had closed is as in the whole run.
            same = [ours == theirs for ours, theirs in zip(some, everything)]
            self.assertGreater(sum(same), 5)
            self.assertEqual(same, sorted(same, reverse=True))

    def test_a_run_that_failed_keeps_the_events_so_far(self):
        with Run("--fault", "structure@350=fail") as run:
            self.assertNotEqual(run.wait(120), 0)
            told = run.summary()["seismicity"]
            self.assertGreater(told["events"], 5)
            self.assertEqual(len(rows(run.directory / "seismicity")), told["events"])
            self.assertLess(told["conservation_error"], 1e-12)


if __name__ == "__main__":
    unittest.main()
