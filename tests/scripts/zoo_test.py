"""That `scripts/zoo.py` tells patterns, refusals and defects apart. Tools that crash, hang and lie are
made here.
"""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from conftest import ROOT

ZOO, TOOL = str(ROOT / "scripts/zoo.py"), os.environ["BRINDLE_TOOL"]

LIAR = """#!/bin/sh
case "$2" in
  *crash*) kill -SEGV $$ ;;
  *hang*) sleep 60 ;;
  *silent*) exit 0 ;;
  *usage*) echo "brindle: no such option" >&2; exit 2 ;;
  *nan*) echo '{"vertices": 3, "energy": null}' > "$5" ;;
  *torn*) printf '{"vertices": 3, "en' > "$5" ;;
  *energy*) echo '{"vertices": 3, "energy": 1.5}' > "$5" ;;
  *refused*) echo "brindle: $2:7: it has no triangles" >&2; exit 1 ;;
esac
"""


ONE_TRIANGLE = """solid one
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid
"""


class Zoo(unittest.TestCase):
    def setUp(self):
        self.kept = tempfile.TemporaryDirectory()
        self.addCleanup(self.kept.cleanup)
        self.folder = pathlib.Path(self.kept.name) / "meshes"
        self.folder.mkdir()

    def zoo(self, tool, *words):
        table = self.folder.parent / "all.csv"
        done = subprocess.run([sys.executable, ZOO, tool, str(self.folder), "--csv", str(table), *words],
                              capture_output=True, text=True)
        rows = list(csv.DictReader(table.read_text().splitlines())) if table.exists() else []
        return done, {row["file"]: row for row in rows}

    def test_real_meshes(self):
        for name in ("box.ply", "sub/tube.vtp"):
            path = self.folder / name
            path.parent.mkdir(exist_ok=True)
            subprocess.run([TOOL, "stripe", f"shape:{path.stem},resolution=12", "-q", "--output", path],
                           check=True, capture_output=True)
        (self.folder / "one.stl").write_text(ONE_TRIANGLE)
        whole = (self.folder / "box.ply").read_bytes()
        (self.folder / "cut.ply").write_bytes(whole[:len(whole) // 2])
        (self.folder / "notes.txt").write_text("no mesh")
        done, rows = self.zoo(TOOL, "--", "--stripes", "6")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("4 files: 3 striped, 1 refused, 0 defects", done.stdout)
        self.assertEqual(rows["cut.ply"]["outcome"], "refused")
        self.assertFalse(rows["cut.ply"]["why"].startswith("/"))
        self.assertGreater(int(rows["sub/tube.vtp"]["triangles"]), 0)
        self.assertGreater(float(rows["box.ply"]["energy"]), 0)

    def test_defects_are_found(self):
        tool = self.folder.parent / "liar"
        tool.write_text(LIAR)
        tool.chmod(0o755)
        defects = ("crash", "hang", "silent", "nan", "torn", "energy")
        for name in (*defects, "refused"):
            (self.folder / f"{name}.obj").write_text("v 0 0 0\n")
        done, rows = self.zoo(str(tool), "--seconds", "1", "--jobs", "4")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        for name in defects:
            self.assertEqual(rows[f"{name}.obj"]["outcome"], "defect", name)
        self.assertIn("SIGSEGV", rows["crash.obj"]["why"])
        self.assertIn("no end within 1 s", rows["hang.obj"]["why"])
        self.assertEqual(rows["refused.obj"]["why"], "7: it has no triangles")

    def test_wrong_usage(self):
        self.assertEqual(self.zoo(TOOL)[0].returncode, 2)  # the folder is empty
        (self.folder / "one.obj").write_text("v 0 0 0\n")
        done, _ = self.zoo(TOOL, "--", "--stripess", "6")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--stripes", done.stderr)
