"""That `scripts/peers.py` prints what it could measure, and says what is missing, crashed or hung. The
sources of a peer are made here: a header that does as it is told.
"""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from conftest import ROOT

PEERS, TOOL = str(ROOT / "scripts/peers.py"), os.environ["BRINDLE_TOOL"]
SHAPE = "shape:torus,resolution=40"

# In the place of libigl's principal directions.
HEADER = """#pragma once
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <unistd.h>
namespace igl {
template <typename V, typename F, typename D, typename S>
void principal_curvature(const V& points, const F&, D& larger, D& smaller, S& most, S& least) {
  const char* told = std::getenv("FAKE_PEER");
  const std::string what = told ? told : "";
  if (what == "crash") raise(SIGSEGV);
  if (what == "hang") sleep(600);
  if (what == "refuse") throw std::runtime_error("it is no manifold");
  if (what == "silent") std::_Exit(0);
  if (what == "exit") std::_Exit(7);
  larger = points;
  for (long i = 0; i < points.rows(); ++i) larger.row(i) << -points(i, 1), points(i, 0), 0;
  smaller = larger;
  most = least = points.col(0);
}
}  // namespace igl
"""


class Peers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # Built once, by the first who needs it.
        kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(kept.cleanup)
        cls.shared = pathlib.Path(kept.name)

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        self.sources = self.folder / "sources"
        self.sources.mkdir()
        self.build = self.folder / "build"

    def peers(self, *words, **environment):
        return subprocess.run([sys.executable, PEERS, TOOL, "--build", str(self.build),
                               "--bench-seconds", "0.02", *map(str, words)], capture_output=True, text=True,
                              env={**os.environ, **environment})

    def fake(self, text=HEADER):
        if text == HEADER:
            self.sources, self.build = self.shared / "sources", self.shared / "build"
        path = self.sources / "libigl/include/igl/principal_curvature.h"
        if not path.exists() or path.read_text() != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)

    def refused(self, *words, says):
        done = self.peers(*words)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn(says, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_without_sources(self):
        table, figures = self.folder / "all.csv", self.folder / "all.json"
        # Nowhere is ParaView found.
        done = self.peers(SHAPE, "--repeat", 2, "--threads", 1, "--csv", table, "--json", figures,
                          PATH=str(self.folder))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("| torus,resolution=40 |", done.stdout)
        for name in ("geometry-central", "instant-meshes", "libigl"):
            self.assertIn(f"{name} is missing: without --sources FOLDER", done.stdout)
        self.assertIn("paraview is missing: pvpython and xvfb-run not found", done.stdout)
        rows = list(csv.DictReader(table.read_text().splitlines()))
        self.assertTrue(all(row["by"].startswith("Brindle") for row in rows), rows)
        smooth = next(row for row in rows if row["task"] == "stripes, smooth field")
        self.assertEqual(smooth["outcome"], "measured")
        self.assertGreater(float(smooth["pattern_ms"]), 0)
        self.assertGreater(float(smooth["processor_s"]), 0)
        read = json.loads(figures.read_text())
        self.assertEqual([read["threads"], read["repeat"], len(read["rows"])], [1, 2, len(rows)])
        self.assertEqual(len(read["rows"][0]["runs"]), 2)
        self.assertEqual(read["rows"][0]["pattern_ms"],
                         min(run["pattern_ms"] for run in read["rows"][0]["runs"]))

    def test_figures_are_those_of_the_tool(self):
        table, report = self.folder / "all.csv", self.folder / "cross.json"
        self.peers(SHAPE, "--repeat", 1, "--stripes", 25, "--peer", "libigl", "--task", "crosses",
                   "--csv", table)
        subprocess.run([TOOL, "stripe", SHAPE, "--cross", "--stripes", "25", "-q", "--report", report],
                       check=True)
        wanted = json.loads(report.read_text())
        row = next(row for row in csv.DictReader(table.read_text().splitlines())
                   if row["by"] == "Brindle, `--cross`")
        self.assertEqual(int(row["field_singularities"]), wanted["field_singularities"])
        self.assertEqual(int(row["branches_beyond"]),
                         wanted["branches"] - 2 * wanted["field_singularities"])

    def test_wrong_usage(self):
        self.refused("--sources", self.folder / "nowhere", says="is no folder")
        self.refused("--sources", self.sources, says=f"no folder {self.sources}/geometry-central")
        self.refused("--sources", self.sources, "--peer", "paraview", says="no effect")
        self.refused("--peer", "blender", says="blender")
        self.refused("--repeat", 0, SHAPE, says="--repeat")
        self.refused("--task", "paint", SHAPE, says="stripes, a frame")
        self.refused("--threads", 1000, SHAPE, says="--threads 1000: there are")
        self.refused("--stripes", "many", says="--stripes")
        self.refused("--csv", self.folder / "no" / "all.csv", says="no folder")
        mesh = self.folder / "mesh.obj"
        mesh.write_text("v 0 0 0\n")
        self.refused(mesh, "--csv", mesh, says="would overwrite")
        self.refused("--csv", self.folder / "a", "--json", self.folder / "a", says="would overwrite")
        self.refused("horse-that-is-not-there.ply", says="is no file")
        self.refused("--faster", says="--faster")

    def test_help(self):
        done = self.peers("--help")
        self.assertEqual(done.returncode, 0)
        for word in ("--sources", "--task", "--repeat", "--csv", "--json", "--threads", "--peer"):
            self.assertIn(word, done.stdout)

    def test_what_is_missing_is_named(self):
        self.fake()
        home = self.sources / "instant-meshes"
        for name in ("src/field.cpp", "src/hierarchy.cpp", "src/subdivide.cpp", "ext/rply/rply.c",
                     "ext/dset/dset.h"):
            (home / name).parent.mkdir(parents=True, exist_ok=True)
            (home / name).write_text("")
        (home / ".gitmodules").write_text('[submodule "ext/pcg32"]\n\tpath = ext/pcg32\n')
        done = self.peers(SHAPE, "--repeat", 1, "--sources", self.sources, "--peer", "instant-meshes",
                          "--peer", "geometry-central", "--peer", "libigl", "--task", "stripes, curvature")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn(f"geometry-central is missing: no folder {self.sources}/geometry-central",
                      done.stdout)
        self.assertIn(f"instant-meshes is missing: {home} lacks ext/pcg32/pcg32.h; try: git -C {home} "
                      "submodule update --init ext/pcg32", done.stdout)
        self.assertIn("libigl, then Brindle", done.stdout)

    def peer_that(self, does, outcome, why, code, seconds=300):
        self.fake()
        table = self.folder / f"{does}.csv"
        done = self.peers(SHAPE, "--repeat", 1, "--seconds", seconds, "--sources", self.sources, "--peer",
                          "libigl", "--task", "stripes, curvature", "--csv", table, FAKE_PEER=does)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        rows = {row["by"]: row for row in csv.DictReader(table.read_text().splitlines())}
        self.assertEqual(rows["libigl, then Brindle"]["outcome"], outcome)
        self.assertIn(why, rows["libigl, then Brindle"]["why"])
        self.assertIn(f"{outcome}: ", done.stdout)
        self.assertEqual(rows["Brindle, `curvature`"]["outcome"], "measured")

    def test_peers_that_end_badly(self):
        self.peer_that("crash", "crashed", "SIGSEGV", 1)
        self.peer_that("hang", "hung", "no end within 3 s", 1, seconds=3)
        self.peer_that("refuse", "refused", "it is no manifold", 0)
        self.peer_that("silent", "crashed", "without a report", 1)
        self.peer_that("exit", "crashed", "exit code 7", 1)

    def test_a_paraview_that_crashes(self):
        for name, text in (("xvfb-run", 'shift 3; "$@"; exit $?'), ("pvpython", "kill -SEGV $$")):
            path = self.folder / name
            path.write_text(f"#!/bin/sh\n{text}\n")
            path.chmod(0o755)
        done = self.peers(SHAPE, "--repeat", 1, "--peer", "paraview", "--task", "a picture",
                          PATH=f"{self.folder}:{os.environ['PATH']}")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("ParaView, Surface LIC | crashed: signal SIGSEGV", done.stdout)

    def test_sources_that_do_not_compile(self):
        self.fake("#error this is no source\n")
        done = self.peers(SHAPE, "--repeat", 1, "--sources", self.sources, "--peer", "libigl",
                          "--task", "stripes, curvature")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("libigl is not built: ", done.stdout)
        self.assertIn("this is no source", done.stdout)
        self.assertIn(str(self.folder / "build" / "libigl.log"), done.stdout)
        self.assertIn("Brindle, `curvature`", done.stdout)

    def test_a_mesh_that_cannot_be_read(self):
        torn = self.folder / "torn|\x1b[31m.obj"
        torn.write_text("v 0 0 0\nf 1 2 3\n")
        done = self.peers(torn, SHAPE, "--repeat", 1, "--task", "stripes, smooth field")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("refused: ", done.stdout)
        self.assertNotIn("\x1b", done.stdout)
        self.assertIn("torus,resolution=40", done.stdout)
