# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of the catalogue of events: the geometry of beach balls, evaluated by a real browser, and every figure of a real run."""
import json
import math
import pathlib
import re
import unittest

from test_report import FIGURES_OF_EVENTS as FIGURES, browse, data_of, run_script, visible_figures, write_report
from trio import CASE, Run

PAGE = pathlib.Path(__file__).resolve().parents[2] / "coupler/report/page"
LAMBDA, MU = 2.0, 3.0  # Poisson's ratio 0.2


def evaluate(expression):
    """Value of an expression over the pure functions of focal_sphere.js."""
    return run_script((PAGE / "focal_sphere.js").read_text(), expression)


def shear(strike):
    """Left-lateral slip on a vertical plane, strike clockwise from north [degree]."""
    along = math.sin(math.radians(strike)), math.cos(math.radians(strike))
    normal = along[1], -along[0]
    return dict(xx=2 * normal[0] * along[0], yy=2 * normal[1] * along[1], zz=0, xy=normal[0] * along[1] + normal[1] * along[0])


def slope(sine):
    """Slip out of a plane with normal x: sine of the angle between slip and plane."""
    cosine = math.sqrt(1 - sine * sine)
    return dict(xx=(LAMBDA + 2 * MU) * sine, yy=LAMBDA * sine, zz=LAMBDA * sine, xy=MU * cosine)


def diagonal(xx, yy, zz):
    return dict(xx=xx, yy=yy, zz=zz, xy=0)


class BeachBalls(unittest.TestCase):
    CELLS = 200

    def shares(self, *moments):
        return evaluate(f"{json.dumps(moments)}.map((moment) => filledShare(moment, {self.CELLS}))")

    def test_rays_are_unit_vectors_downwards_and_the_projection_keeps_areas(self):
        places = [(0, 0), (0.3, -0.4), (0, 1), (-0.6, 0.7)]
        for (x, y), ray in zip(places, evaluate(f"{json.dumps(places)}.map(([x, y]) => rayOf(x, y))")):
            self.assertAlmostEqual(math.hypot(*ray), 1, places=12)
            self.assertLessEqual(ray[2], 0)
            # A cap down to the ray has the share 1 - cos(inclination) of the half sphere: the square of the radius in the disc.
            self.assertAlmostEqual(1 + ray[2], x * x + y * y, places=12)

    def test_a_strike_slip_ball_is_filled_in_two_of_four_quadrants(self):
        for strike in (0, 45, 330):
            moment = shear(strike)
            self.assertAlmostEqual(self.shares(moment)[0], 0.5, delta=2 / self.CELLS)
            # Tension axis 45 degrees clockwise from the strike of a left-lateral fault, pressure axis as far counter-clockwise.
            azimuths = [strike + turn for turn in (10, 45, 80, 100, 135, 170, 190, 225, 260, 280, 315, 350)]
            places = [(0.7 * math.sin(math.radians(a)), 0.7 * math.cos(math.radians(a))) for a in azimuths]
            signs = evaluate(f"{json.dumps(places)}.map(([x, y]) => Math.sign(radiation({json.dumps(moment)}, rayOf(x, y))))")
            self.assertEqual(signs, [1] * 3 + [-1] * 3 + [1] * 3 + [-1] * 3, strike)

    def test_explosions_and_open_cracks_fill_the_disc_and_implosions_none_of_it(self):
        explosion, implosion, crack, dipole, closing = self.shares(diagonal(1, 1, 1), diagonal(-1, -1, -1), slope(1), diagonal(1, 0, 0), {k: -v for k, v in slope(1).items()})
        self.assertEqual((explosion, implosion, crack, dipole, closing), (1, 0, 1, 1, 0))

    def test_a_slip_out_of_its_plane_has_a_nodal_line_below_the_sine_mu_over_lambda_plus_mu(self):
        limit = MU / (LAMBDA + MU)
        above, at_45, below, less = self.shares(slope(limit + 0.01), slope(math.sqrt(0.5)), slope(limit - 0.05), slope(0.2))
        self.assertEqual((above, at_45), (1, 1))
        self.assertLess(below, 1)
        self.assertLess(less, below)
        self.assertGreater(less, 0.5)

    def test_a_clvd_is_filled_in_a_cap_and_its_opposite_in_the_rest(self):
        # 2 n^2 > 1 - n^2, n > 1/sqrt(3): a double cap of the share 1 - 1/sqrt(3), wherever its axis points.
        cap = 1 - 1 / math.sqrt(3)
        east, up, opposite = self.shares(diagonal(2, -1, -1), diagonal(-1, -1, 2), diagonal(-2, 1, 1))
        for share in (east, up, 1 - opposite):
            self.assertAlmostEqual(share, cap, delta=2 / self.CELLS)

    def test_the_pixels_of_a_ball_have_north_on_top_and_the_pattern_its_axes(self):
        # Uniaxial tension along the axis 30 degrees north of east, less than the compression around it.
        angle = math.radians(30)
        c, s = math.cos(angle), math.sin(angle)
        moment = dict(xx=2 * c * c - s * s, yy=2 * s * s - c * c, zz=-1, xy=3 * c * s)
        pattern, pixels = evaluate(f"(() => {{ const moment = {json.dumps(moment)}; return [principalPattern(moment), [...ballPixels(moment, 64, [0, 114, 178])]]; }})()")
        self.assertAlmostEqual(pattern["angle"], angle, places=12)
        for name, value in (("major", 1), ("minor", -0.5), ("normal", -0.5)):
            self.assertAlmostEqual(pattern[name], value, places=12)

        def pixel(x, y):
            start = 4 * (64 * int((1 - y) * 32) + int((1 + x) * 32))
            return pixels[start:start + 4]

        self.assertEqual(pixel(0.8 * c, 0.8 * s), [0, 114, 178, 255])
        self.assertEqual(pixel(-0.8 * c, -0.8 * s), [0, 114, 178, 255])
        self.assertEqual(pixel(-0.8 * c, 0.8 * s), [255, 255, 255, 255])
        self.assertEqual(pixel(0, 0), [255, 255, 255, 255])
        self.assertEqual(pixel(0.95, 0.95)[3], 0)

    def test_a_tensor_that_is_zero_has_no_pattern(self):
        self.assertIsNone(evaluate("principalPattern({ xx: 0, yy: 0, zz: 0, xy: 0 })"))


class Room(unittest.TestCase):
    def test_of_discs_along_a_line_those_are_kept_that_touch_none_before_them(self):
        # Ten of reach 3, one apart: every sixth has room; then one of reach 20 that reaches far over the cells, and a small one beyond it.
        asked = [(x, 0, 3) for x in range(10)] + [(25, 0, 20), (29.6, 0, 20.5), (0, 90, 20), (0, 69, 0.9), (0, 69, 1.1)]
        kept = run_script((PAGE / "seismic_balls.js").read_text(), f"(() => {{ const claim = claims(4); return {json.dumps(asked)}.map((disc) => claim(...disc)); }})()")
        self.assertEqual(kept, [x in (0, 6) for x in range(10)] + [False, True, True, True, False])


class Pictures(unittest.TestCase):
    def test_a_run_that_keeps_no_catalogue_has_no_figure_of_it(self):
        with Run("--until", "1 s", "--set", "seismicity.active=false") as run:
            self.assertEqual(run.wait(120), 0, run.errors)
            page = write_report(run)
            self.assertIsNone(data_of(page)["seismicity"])
            shown = set(visible_figures(page, ""))
            self.assertEqual(shown & (set(FIGURES) | {"seismic_slip"}), set())
            self.assertIn("half_length", shown)

    def test_every_figure_of_the_catalogue_is_drawn_and_none_without_one(self):
        with Run("--until", "3 s", case=CASE.parent / "crossing", form=None) as run:
            self.assertEqual(run.wait(120), 0, run.errors)
            page = write_report(run)
            data = data_of(page)
            self.assertGreater(data["seismicity"]["totals"]["events"], 0)
            seen, console = browse(page)
            self.assertEqual(console, [])
            self.assertEqual(seen["wide"], 0)
            expected = set(FIGURES)
            if data["joints"] and any(slip for report in data["joints"]["reports"] for slip in report["slip"]):
                expected.add("seismic_slip")
            coloured = {}
            for canvas in seen["drawn"]:
                coloured[canvas["id"]] = coloured.get(canvas["id"], 0) + canvas["coloured"]
            for name in expected:
                self.assertGreater(coloured.get(name, 0), 100, name + " is blank or absent")
            for figure in seen["figures"]:
                if figure["id"] in expected:
                    self.assertIn(data["seismicity"]["caption"], figure["caption"], figure["id"])
            for name in ("seismic_map", "moment_time"):
                self.assertEqual(visible_figures(page, f"?figure={name}&time=1"), [name])

            data["seismicity"] = None
            block = json.dumps(data).replace("</", "<\\/")
            bare = re.sub(r'(<script type="application/json" id="data">).*?(</script>)', lambda found: found[1] + block + found[2], page, flags=re.S)
            seen, console = browse(bare)
            self.assertEqual(console, [])
            self.assertEqual({figure["id"] for figure in seen["figures"]} & (set(FIGURES) | {"seismic_slip"}), set())
            self.assertIn("half_length", {figure["id"] for figure in seen["figures"]})


if __name__ == "__main__":
    unittest.main()
