#!/usr/bin/env pvpython
"""Stripes over colours, curves as tubes and samples with glyphs, all along one field of vectors.

    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython filters.py [--plugin Brindle.so]
        [--output PICTURE.png] [--session FILE.pvsm]

ParaView opens the session; without arguments, load the plugin and run this in its Python shell.
"""

import argparse
import os

from paraview import simple as pv

PLAIN = [0.93, 0.9, 0.83]


def vectors_on_a_torus():
    torus = pv.Superquadric(Toroidal=1, ThetaResolution=256, PhiResolution=128)
    flow = pv.Calculator(Input=torus, ResultArrayName="flow",
                         Function="coordsY*iHat - coordsX*jHat + 0.3*kHat")
    height = pv.Calculator(Input=flow, ResultArrayName="height", Function="coordsZ")
    height.UpdatePipeline()
    return height


def show_stripes(surface, view):
    stripes = BrindleStripes(Input=surface, Field="Array", Vectors=["POINTS", "flow"], Stripes=30)
    stripes.StripesRun = "Along the Field"
    stripes.Slack = 0.25
    shown = pv.Show(stripes, view, "GeometryRepresentation")
    shown.Representation = "Brindle Stripes"
    shown.StripeColor, shown.StripeWidth = [1, 1, 1], 0.35
    pv.ColorBy(shown, ("POINTS", "height"))


def show_curves(surface, view, place):
    curves = BrindleCurves(Input=surface, Field="Array", Vectors=["POINTS", "flow"], Stripes=30)
    curves.StripesRun = "Along the Field"
    curves.Slack, curves.Join = 0.25, 1
    shown = pv.Show(pv.Tube(Input=curves, Radius=0.008), view, "GeometryRepresentation")
    shown.Position = place
    pv.ColorBy(shown, ("POINTS", None))
    shown.DiffuseColor = shown.AmbientColor = PLAIN


def show_samples(surface, view, place):
    samples = BrindleSamples(Input=surface, Field="Array", Vectors=["POINTS", "flow"], Stripes=30)
    samples.UpdatePipeline()
    glyphs = pv.Glyph(Input=samples, GlyphType="Arrow", GlyphMode="All Points", ScaleFactor=0.07,
                      OrientationArray=["POINTS", "flow"], ScaleArray=["POINTS", "No scale array"])
    shown = pv.Show(glyphs, view, "GeometryRepresentation")
    shown.Position = place
    pv.ColorBy(shown, ("POINTS", "height"))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", help="load this; otherwise it is loaded already")
    parser.add_argument("--output", help="a picture")
    parser.add_argument("--session", help="a session for ParaView")
    options = parser.parse_args()
    if options.plugin:
        pv.LoadPlugin(os.path.abspath(options.plugin), remote=False, ns=globals())
    surface = vectors_on_a_torus()
    view = pv.CreateView("RenderView")
    view.ViewSize = [1000, 300]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    show_stripes(surface, view)
    show_curves(surface, view, [1.2, 0, 0])
    show_samples(surface, view, [2.4, 0, 0])
    view.CameraFocalPoint = [1.2, 0, 0]
    view.CameraPosition = [1.2, -1.7, 2.6]
    view.CameraViewUp = [0, 1, 0]
    view.CameraViewAngle = 20
    view.StillRender()
    if options.output:
        pv.SaveScreenshot(options.output, view, ImageResolution=[1000, 300])
    if options.session:
        pv.SaveState(options.session)
    if options.output or options.session:
        pv.Delete(view)  # while its display is there


if __name__ == "__main__":
    main()
