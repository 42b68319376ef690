# SPDX-License-Identifier: GPL-3.0-or-later
"""An independent reader finds in QuakeML, points and HDF5 what the CSV file says, and geometry confirms it."""
import datetime
import decimal
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

import h5py
import numpy

import catalogue_reader as reader

SAMPLE = os.environ["SAMPLE_CATALOGUE"]
COUPLER = pathlib.Path(os.environ["FISSURA_PROGRAMS"]) / "coupler"
EVENTS = 400
START = datetime.datetime(2026, 1, 31, 23, 59, 0, 250000)
AZIMUTH = math.radians(30)  # of the y axis


def sample(directory, *words):
    return json.loads(subprocess.run([SAMPLE, directory, str(EVENTS), *words], check=True, capture_output=True, text=True).stdout)


def coupler(*words):
    return subprocess.run([COUPLER, "seismicity", *words], capture_output=True, text=True)


def direction(azimuth, plunge):
    """East, north, up of an axis that points below the horizontal."""
    return numpy.array([math.sin(azimuth) * math.cos(plunge), math.cos(azimuth) * math.cos(plunge), -math.sin(plunge)])


def normal_and_slip(strike, dip, rake):
    """East, north, up of the hanging wall's outward normal and slip (Aki & Richards 2002, eq. 4.88, 4.89)."""
    s, d, r = (math.radians(angle) for angle in (strike, dip, rake))
    slip_north = math.cos(r) * math.cos(s) + math.cos(d) * math.sin(r) * math.sin(s)
    slip_east = math.cos(r) * math.sin(s) - math.cos(d) * math.sin(r) * math.cos(s)
    normal = numpy.array([math.sin(d) * math.cos(s), -math.sin(d) * math.sin(s), math.cos(d)])
    return normal, numpy.array([slip_east, slip_north, math.sin(r) * math.sin(d)])


def east_north_up(row):
    """The tensor of a CSV row, from axes x, y, z with y at AZIMUTH from north, clockwise."""
    xx, yy, zz, xy = (float(row[name]) for name in ("Mxx", "Myy", "Mzz", "Mxy"))
    c, s = math.cos(AZIMUTH), math.sin(AZIMUTH)
    axes = numpy.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    return axes @ numpy.array([[xx, xy, 0], [xy, yy, 0], [0, 0, zz]]) @ axes.T


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.run_directory = pathlib.Path(cls.folder.name) / "run"
        cls.told = sample(cls.run_directory)
        cls.catalogue = cls.run_directory / "seismicity"
        cls.rows = reader.rows(cls.catalogue / "catalogue.csv")
        cls.parameters, cls.events = reader.quakeml(cls.catalogue / "catalogue.xml")

    def pairs(self):
        self.assertGreater(len(self.rows), 0.9 * EVENTS)
        self.assertEqual(len(self.events), len(self.rows))
        return zip(self.rows, self.events)

    def test_every_number_in_quakeml_is_printed_as_in_csv(self):
        for row, event in self.pairs():
            for name in ("lat", "lon", "depth_m", "M0_Nm", "Mw"):
                self.assertEqual(event[name], row[name], name)
            self.assertEqual(event["planes"], [[row["strike"], row["dip"], row["rake"]], [row["strike2"], row["dip2"], row["rake2"]]])
            self.assertEqual(event["duration"], row["duration_s"])
            self.assertEqual(event["doubleCouple"], row["C_dc"])
            self.assertEqual(event["iso"], row["C_iso"].removeprefix("-"))
            self.assertEqual(event["clvd"], row["C_clvd"].removeprefix("-"))
            with_place = {"event_id", "utc", "lat", "lon", "depth_m", "M0_Nm", "Mw", "strike", "dip", "rake", "strike2", "dip2", "rake2"}
            self.assertEqual(event["own"], {name: cell for name, cell in row.items() if name not in with_place})

    def test_no_digit_is_lost(self):
        """The shortest text of the double that was read is the text that stands there."""
        for _, event in self.pairs():
            numbers = event["tensor"] + [axis[2] for axis in event["axes"]]
            for printed in numbers + [event[name] for name in ("M0_Nm", "Mw", "lat", "lon", "depth_m", "iso", "clvd", "doubleCouple")]:
                self.assertEqual(decimal.Decimal(printed), decimal.Decimal(repr(float(printed))))

    def test_tensor_in_up_south_east(self):
        for row, event in self.pairs():
            m = east_north_up(row)
            expected = [m[2, 2], m[1, 1], m[0, 0], -m[1, 2], m[0, 2], -m[0, 1]]
            for found, wanted in zip(map(float, event["tensor"]), expected):
                self.assertAlmostEqual(found, wanted, delta=1e-13 * float(row["M0_Nm"]))

    def test_scalar_moment_and_magnitude(self):
        for row, event in self.pairs():
            rr, tt, pp, rt, rp, tp = map(float, event["tensor"])
            scalar = math.sqrt((rr * rr + tt * tt + pp * pp) / 2 + rt * rt + rp * rp + tp * tp)
            self.assertAlmostEqual(float(event["M0_Nm"]) / scalar, 1, delta=1e-13)
            self.assertAlmostEqual(float(event["Mw"]), (math.log10(scalar) - 9.1) / 1.5, delta=1e-12)

    def test_axes_rebuild_the_tensor(self):
        for row, event in self.pairs():
            rebuilt = numpy.zeros((3, 3))
            for azimuth, plunge, length in event["axes"]:
                axis = direction(math.radians(float(azimuth)), math.radians(float(plunge)))
                rebuilt += float(length) * numpy.outer(axis, axis)
            numpy.testing.assert_allclose(rebuilt, east_north_up(row), atol=1e-12 * float(row["M0_Nm"]))
            lengths = [float(axis[2]) for axis in event["axes"]]
            self.assertGreaterEqual(lengths[0], lengths[2])
            self.assertGreaterEqual(lengths[2], lengths[1])

    def test_preferred_plane_is_the_one_that_failed(self):
        for row, event in self.pairs():
            self.assertEqual(event["preferredPlane"], "1")
            normal, _ = normal_and_slip(*map(float, event["planes"][0]))
            nx, ny = float(row["nx"]), float(row["ny"])
            c, s = math.cos(AZIMUTH), math.sin(AZIMUTH)
            true_normal = numpy.array([nx * c + ny * s, ny * c - nx * s, 0])
            _, event_slip = normal_and_slip(*map(float, event["planes"][0]))
            self.assertAlmostEqual(abs(normal @ normal_and_slip(*map(float, event["planes"][1]))[1]), 1, delta=1e-9,
                                   msg="the planes are not those of one double couple")
            # Of the two planes of the double couple no other one is nearer to the plane that failed.
            other = normal_and_slip(*map(float, event["planes"][1]))[0]
            self.assertGreaterEqual(abs(normal @ true_normal), abs(other @ true_normal) - 1e-9)
            self.assertAlmostEqual(normal @ event_slip, 0, delta=1e-12)

    def test_time_is_that_of_the_centroid(self):
        for row, event in self.pairs():
            self.assertEqual(event["originType"], "centroid")
            found = datetime.datetime.strptime(event["time"], "%Y-%m-%dT%H:%M:%S.%fZ")
            expected = START + datetime.timedelta(microseconds=round(1e6 * float(row["tc_s"])))
            self.assertLessEqual(abs(found - expected), datetime.timedelta(microseconds=1))
            begin = datetime.datetime.strptime(row["utc"], "%Y-%m-%dT%H:%M:%S.%fZ")
            expected = START + datetime.timedelta(microseconds=round(1e6 * float(row["t0_s"])))
            self.assertLessEqual(abs(begin - expected), datetime.timedelta(microseconds=1))

    def test_place_by_radii_of_curvature(self):
        a, e2 = 6378137.0, 0.00669437999014
        phi = math.radians(56.7)
        root = math.sqrt(1 - e2 * math.sin(phi) ** 2)
        meridian, across = a * (1 - e2) / root ** 3 - 2500, a / root - 2500
        for row in self.rows:
            x, y = float(row["x_m"]), float(row["y_m"])
            east, north = x * math.cos(AZIMUTH) + y * math.sin(AZIMUTH), y * math.cos(AZIMUTH) - x * math.sin(AZIMUTH)
            # First order: at 360 m from the origin it is 2 cm off.
            self.assertAlmostEqual(math.radians(float(row["lat"]) - 56.7) * meridian, north, delta=0.04)
            self.assertAlmostEqual(math.radians(float(row["lon"]) + 120.5) * across * math.cos(phi), east, delta=0.04)

    def test_references_and_words_are_legal(self):
        self.assertEqual(len({event["publicID"] for event in self.events}), len(self.events))
        for _, event in self.pairs():
            self.assertRegex(event["publicID"], r"^smi:local/fissura/0123456789abcdef/[0-9a-f]{12}/event/[0-9]+$")
            self.assertEqual(event["preferredOriginID"], event["origin"])
            self.assertEqual(event["derivedOriginID"], event["origin"])
            self.assertEqual(event["magnitudeOrigin"], event["origin"])
            self.assertEqual(event["preferredMagnitudeID"], event["magnitude"])
            self.assertEqual(event["momentMagnitudeID"], event["magnitude"])
            self.assertEqual(event["preferredFocalMechanismID"], event["mechanism"])
            self.assertEqual([event[key] for key in ("type", "typeCertainty", "depthType", "evaluationMode", "inversionType",
                                                     "functionType", "magnitudeType")],
                             ["fluid injection", "known", "operator assigned", "automatic", "general", "unknown", "Mw"])
        self.assertEqual(reader.text(self.parameters, "creationInfo", "creationTime"), "2026-02-01T10:20:30Z")
        self.assertIn("sample of a <catalogue> & more", reader.text(self.parameters, "description"))

    def test_every_column_is_documented(self):
        page = (pathlib.Path(__file__).resolve().parents[4] / "docs/results.md").read_text(encoding="utf-8")
        section = page.split("## seismicity/")[1].split("\n## ")[0]
        for column in self.rows[0]:
            self.assertIn(f"`{column}`", section)

    def test_points(self):
        count, vertices, arrays = reader.points(self.catalogue / "catalogue.vtp")
        self.assertEqual((count, vertices), (len(self.rows), len(self.rows)))
        for name, values in arrays.items():
            self.assertEqual(len(values), count, name)
        self.assertEqual(arrays["connectivity"], list(range(count)))
        self.assertEqual(arrays["offsets"], list(range(1, count + 1)))
        types = {"shear": 1, "tensile": 2, "closing": 3, "mixed": 4}
        for i, row in enumerate(self.rows):
            self.assertEqual(arrays["Points"][i], (float(row["x_m"]), float(row["y_m"]), 0))
            self.assertEqual(arrays["Mw"][i], float(row["Mw"]))
            self.assertEqual(arrays["t0"][i], float(row["t0_s"]))
            self.assertEqual(arrays["type"][i], types[row["type"]])
            xx, yy, zz, xy = (float(row[name]) for name in ("Mxx", "Myy", "Mzz", "Mxy"))
            self.assertEqual(arrays["moment_tensor"][i], (xx, xy, 0, xy, yy, 0, 0, 0, zz))

    def test_hdf5(self):
        with h5py.File(self.catalogue / "catalogue.h5") as file:
            self.assertEqual(file.attrs["schema"], 1)
            for name in ("t0", "M0", "Mw", "Mxy", "opening", "p_fluid", "lat"):
                column = [c for c in self.rows[0] if c == name or c.startswith(name + "_")][0]
                self.assertEqual(file["events"][name][:].tolist(), [float(row[column]) for row in self.rows])
            self.assertEqual(file["events/M0"].attrs["unit"], b"N m")
            numpy.testing.assert_allclose(numpy.degrees(file["events/strike"][:]), [float(r["strike"]) for r in self.rows], rtol=1e-14)
            self.assertIn(b"2 tensile", file["events/type"].attrs["words"])

    def test_rebuilt_is_byte_identical(self):
        result = coupler(str(self.run_directory))
        self.assertEqual(result.returncode, 0, result.stderr)
        for name in ("catalogue.csv", "catalogue.h5", "catalogue.vtp", "catalogue.xml", "summary.json"):
            self.assertEqual((self.run_directory / "seismicity_rebuilt" / name).read_bytes(), (self.catalogue / name).read_bytes(), name)

    def test_other_thresholds_give_other_events(self):
        out = pathlib.Path(self.folder.name) / "wide"
        result = coupler(str(self.run_directory), "--cluster-radius", "50 m", "--cluster-time", "2 s", "--formats", "csv", "--out", str(out))
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = reader.rows(out / "catalogue.csv")
        self.assertLess(len(rows), len(self.rows) / 2)
        self.assertEqual({row["r_c_m"] for row in rows}, {"50"})
        self.assertEqual(sum(int(row["n_rec"]) for row in rows), sum(int(row["n_rec"]) for row in self.rows))
        self.assertFalse((out / "catalogue.xml").exists())
        # Every slip is slower than that; what cracks stays.
        result = coupler(str(self.run_directory), "--slip-rate", "1 m/s", "--formats", "csv", "--out", str(out))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual({row["fracture"] for row in reader.rows(out / "catalogue.csv")}, {"grown"})

    def test_thickness_of_events(self):
        out = pathlib.Path(self.folder.name) / "thin"
        result = coupler(str(self.run_directory), "--thickness", "equidimensional", "--formats", "csv", "--out", str(out))
        self.assertEqual(result.returncode, 0, result.stderr)
        for row, thin in zip(self.rows, reader.rows(out / "catalogue.csv")):
            ratio = float(thin["thickness_m"]) / float(row["thickness_m"])
            self.assertAlmostEqual(float(thin["Mxx"]), ratio * float(row["Mxx"]), delta=1e-12 * float(row["M0_Nm"]))
            self.assertAlmostEqual(float(thin["Mw"]) - float(row["Mw"]), math.log10(ratio) / 1.5, delta=1e-9)

    def test_wrong_words(self):
        for words, code, said in ((("--cluster-radius", "3 s"), 2, "--cluster-radius"), (("--slip-rate=-1 m/s",), 2, "--slip-rate"),
                                  (("--formats", "segy"), 2, "segy"), (("--thickness", "2 m"), 2, "--thickness")):
            result = coupler(str(self.run_directory), *words)
            self.assertEqual(result.returncode, code, words)
            self.assertIn(said, result.stderr)
        result = coupler(self.folder.name)
        self.assertEqual(result.returncode, 11)


class WithoutPlace(unittest.TestCase):
    def test_all_but_quakeml(self):
        with tempfile.TemporaryDirectory() as folder:
            sample(folder, "unplaced")
            run = pathlib.Path(folder)
            self.assertEqual(sorted(file.name for file in (run / "seismicity").iterdir()),
                             ["catalogue.csv", "catalogue.h5", "catalogue.vtp", "summary.json"])
            row = reader.rows(run / "seismicity/catalogue.csv")[0]
            self.assertEqual({row[name] for name in ("utc", "lat", "lon", "depth_m")}, {""})
            result = coupler(folder, "--formats", "quakeml")
            self.assertEqual(result.returncode, 11)
            for key in ("latitude", "longitude", "depth", "start"):
                self.assertIn(key, result.stderr)
            self.assertFalse((run / "seismicity_rebuilt").exists())


if __name__ == "__main__":
    unittest.main()
