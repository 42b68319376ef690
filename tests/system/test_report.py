# SPDX-License-Identifier: GPL-3.0-or-later
"""`coupler report` of real runs, looked at by a real browser: Chromium without a window."""
import csv
import html
import io
import json
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import unittest

from trio import CASE, COUPLER, Run

# Runs in the page after its own scripts: what was drawn on every canvas, and where the page asked for something from outside.
PROBE = """<script>
window.addEventListener("load", () => setTimeout(() => {
  const drawn = [...document.querySelectorAll("canvas")].map((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 60, canvas.width, canvas.height - 60);
    // Text, axes and grid are greys; series, fractures and stresses are coloured, and so is the legend at the top.
    let coloured = 0;
    for (let pixel = 0; pixel < data.length; pixel += 4) {
      const [red, green, blue, opaque] = data.slice(pixel, pixel + 4);
      if (opaque > 200 && Math.max(red, green, blue) - Math.min(red, green, blue) > 60) ++coloured;
    }
    return { id: canvas.closest("figure").id, coloured };
  });
  const wide = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  const asked = performance.getEntriesByType("resource").map((entry) => entry.name);
  const figures = [...document.querySelectorAll("figure")].map((figure) => ({ id: figure.id,
    caption: figure.querySelector("figcaption").textContent, canvas: figure.querySelector("canvas") !== null, visible: figure.offsetParent !== null }));
  const result = document.createElement("pre");
  result.id = "probe";
  result.textContent = JSON.stringify({ drawn, wide, asked, figures });
  document.body.append(result);
}, 200));
</script></body>"""


def write_report(run):
    done = subprocess.run([COUPLER, "report", run.directory], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    page = pathlib.Path(done.stdout.strip())
    assert page == run.directory / "report.html"
    return page.read_text()


def data_of(page):
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S).group(1))


def visible_figures(page, query):
    """The figures that have a place on the page, at an address with this query."""
    seen, console = browse(page, query)
    assert console == [], console
    return [figure["id"] for figure in seen["figures"] if figure["visible"]]


def dumped(text, query=""):
    """The document that Chromium makes of a page, and what it and the page wrote on the console."""
    with tempfile.TemporaryDirectory(prefix="fissura-report-") as home:
        file = pathlib.Path(home) / "report.html"
        file.write_text(text)
        command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
                   f"--user-data-dir={home}/profile", "--window-size=1200,900", "--virtual-time-budget=10000",
                   "--enable-logging=stderr", "--dump-dom", file.as_uri() + query]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120)
        return done.stdout, done.stderr


def probed(document, errors):
    found = re.search(r'<pre id="probe">(.*?)</pre>', document, re.S)
    assert found, "the page did not come to its end:\n" + errors
    return json.loads(html.unescape(found.group(1)))


def browse(page, query=""):
    """What the probe saw, and what the page wrote on the console."""
    body, end = page.rsplit("</body>", 1)
    document, errors = dumped(body + PROBE + end, query)
    return probed(document, errors), [line for line in errors.splitlines() if "CONSOLE" in line]


def run_script(script, expression):
    """Value of an expression after a script of its own, as JSON brings it over."""
    page = f"""<!DOCTYPE html><body><script>{script}
const result = document.createElement("pre");
result.id = "probe";
result.textContent = JSON.stringify({expression});
document.body.append(result);</script></body>"""
    return probed(*dumped(page))


# Of the catalogue: how much of them is coloured depends on the number of events, and the dot of a single one has some ten pixels.
# test_seismic_report looks at them where that number is known.
FIGURES_OF_EVENTS = ("seismic_map", "distance_time", "magnitude_time", "frequency_magnitude", "hudson", "moment_time", "seismic_rate", "magnitude_distance",
                     "stimulated_volume")


class Report(unittest.TestCase):
    def look_at(self, run, pictures):
        page = write_report(run)
        seen, console = browse(page)
        self.assertEqual(console, [])
        self.assertEqual(seen["asked"], [], "the page asked for something outside itself")
        self.assertEqual(seen["wide"], 0, "the page is wider than a window of 1200 px")
        drawn = {canvas["id"]: canvas for canvas in seen["drawn"]}
        self.assertLessEqual(set(pictures), set(drawn))
        for name, canvas in drawn.items():
            least = 10 if name in FIGURES_OF_EVENTS + ("seismic_slip",) else 100
            self.assertGreater(canvas["coloured"], least, name + " is blank")
        for figure in seen["figures"]:
            self.assertTrue(figure["canvas"], figure["id"] + " shows nothing")
            self.assertRegex(figure["caption"], r"From (history|ledger|remeshing|segments|seismicity)", figure["id"])
        return data_of(page)

    ALWAYS = ("map", "half_length", "inlet_aperture", "inlet_net_pressure", "pumping", "ledger", "residual", "mismatch", "energies",
              "least_stress", "relative_stress", "stress", "interval", "steps", "mass_scale")

    def test_a_run_with_a_reference_is_drawn_whole(self):
        with Run() as run:
            self.assertEqual(run.wait(120), 0, run.errors)
            data = self.look_at(run, self.ALWAYS)
            rows = list(csv.DictReader(io.StringIO(run.history().decode())))
            self.assertEqual(len(rows), data["history"]["rows"])
            for column, values in data["history"]["columns"].items():
                self.assertEqual(values, [float(row[column]) for row in rows], column)
            self.assertEqual(data["summary"]["verdict"], "pass")
            for column in ("half_length", "inlet_aperture", "inlet_net_pressure"):
                self.assertIn(column, data["comparison"]["curves"])
                self.assertTrue(data["classical"][column])

    def test_a_fracture_on_its_own_path_shows_its_remeshing(self):
        with Run("--set", "growth.path=free", "--until", "1 s") as run:
            self.assertEqual(run.wait(120), 0, run.errors)
            data = self.look_at(run, self.ALWAYS + ("touched", "altitude", "energy_jump", "remeshing_wall", "path"))
            columns = data["remeshing"]["columns"]
            self.assertGreater(data["remeshing"]["rows"], 0)
            self.assertEqual(columns["hash_before"], columns["hash_after"])

    def test_a_natural_fracture_shows_where_it_was_met_and_what_it_did(self):
        with Run("--until", "3 s", case=CASE.parent / "crossing", form=None) as run:
            self.assertEqual(run.wait(120), 0, run.errors)
            data = self.look_at(run, self.ALWAYS + ("natural_map", "slip", "natural_length", "junction_pressure"))
            columns = data["meetings"]["columns"]
            self.assertEqual(columns["natural"], ["natural fracture"])
            self.assertEqual(len(columns["time"]), data["history"]["columns"]["meetings"][-1])
            self.assertTrue(data["joints"]["reports"][-1]["unit"], "nothing happened on the natural fracture")
            summary = data["summary"]["natural_fractures"]
            self.assertEqual(summary["met"], summary["crossed"] + summary["arrested"])
            self.assertGreater(summary["wetted_length"], 0)

    def test_a_single_figure_is_shown_when_its_name_stands_in_the_address(self):
        with Run("--until", "1 s") as run:
            self.assertEqual(run.wait(120), 0, run.errors)
            page = write_report(run)
            self.assertEqual(visible_figures(page, "?figure=least_stress"), ["least_stress"])
            self.assertGreater(len(visible_figures(page, "")), 10)

    def test_a_run_that_is_killed_on_its_way_is_drawn_as_far_as_it_went(self):
        with Run("--set", "output.reports_per_segment=1", "--set", 'time.end="400 s"', form=None) as run:
            run.wait_until_running(segments=2)
            page = write_report(run)
            self.assertGreaterEqual(len(data_of(page)["map"]["reports"]), 2)
            for worker in run.pids("coupler"):
                os.kill(worker, signal.SIGKILL)
            run.wait()
            self.assertIsNone(self.look_at(run, self.ALWAYS)["summary"])

    def test_another_directory_is_refused(self):
        with tempfile.TemporaryDirectory() as home:
            done = subprocess.run([COUPLER, "report", home], capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 11, done.stderr)
            self.assertIn("is not a run directory", done.stderr)
            self.assertEqual(list(pathlib.Path(home).iterdir()), [])


if __name__ == "__main__":
    unittest.main()
