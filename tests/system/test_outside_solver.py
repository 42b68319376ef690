# SPDX-License-Identifier: GPL-3.0-or-later
"""The installed package: a project that knows nothing else builds a flow solver with it, which keeps the contract and runs."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from trio import COUPLER, PROGRAMS, ROOT

BUILD = PROGRAMS.parent


def called(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout[-4000:]}\n{done.stderr[-4000:]}")
    return done.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = pathlib.Path(tempfile.mkdtemp(prefix="fissura-package-"))
        cls.addClassCleanup(shutil.rmtree, cls.home)
        called("cmake", "--install", BUILD, "--prefix", cls.home / "prefix")
        called("cmake", "-S", ROOT / "tests/system/outside_solver", "-B", cls.home / "build", f"-DCMAKE_PREFIX_PATH={cls.home / 'prefix'}")
        called("cmake", "--build", cls.home / "build")
        cls.solver = cls.home / "build/outside_solver"
        cls.coupler = cls.home / "prefix/bin/coupler"

    def test_a_solver_of_another_project_keeps_the_contract(self):
        self.assertIn(" 0 failed", called(self.coupler, "conform", self.solver).splitlines()[-1])

    def test_it_runs_with_the_installed_programs(self):
        run = self.home / "run"
        called(self.coupler, "run", ROOT / "cases/fixed_crack", "--short", "--until", "0.2 s", "--network", self.solver, "--out", run)
        self.assertIn("one pressure", (run / "run.json").read_text())

    def test_the_python_module_is_found_where_it_was_installed(self):
        shipped = self.home / "prefix/bin/network_python"
        self.assertIn("network of a Fissura run", called(shipped, "--help", env={**os.environ, "PYTHONPATH": ""}))
        self.assertIn(" 0 failed", called(self.coupler, "conform", "--only", "handshake", "python").splitlines()[-1])

    def test_headers_and_programs_name_no_place_of_the_build(self):
        for file in (self.home / "prefix").rglob("*"):
            if file.suffix in (".hpp", ".cmake", ".py"):
                self.assertNotIn(str(BUILD), file.read_text(), file)


if __name__ == "__main__":
    unittest.main()
