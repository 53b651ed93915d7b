"""Frames of ParaView's Surface LIC, from the view of Brindle's pictures. Run by pvpython:

    pvpython --force-offscreen-rendering peers/surface_lic.py MESH.vtp ARRAY REPORT.json
             [--size 1280x720] [--frames 5] [--camera 30,20,1] [--up y|z] [--output FILE.png]

A frame is drawn and read back; before each the camera moves, so that nothing can be kept from the last.
"""

import argparse
import json
import sys
import time

import numpy as np
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

# Of Brindle's pictures: the angle of the longer side, and the share of half a side that stays free.
FIELD_OF_VIEW, MARGIN = np.radians(28), 0.05
UPRIGHT = {"y": np.eye(3), "z": np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])}


def framed(points, camera, up, width, height):
    """Eye, axes (rows: right, up, backwards) and the angle of the picture's height: the closest view
    from which no point is cut off, divided by the zoom."""
    azimuth, elevation, zoom = np.radians(camera[0]), np.radians(camera[1]), camera[2]
    right = np.array([np.cos(azimuth), 0, -np.sin(azimuth)])
    back = np.array([np.sin(azimuth) * np.cos(elevation), np.sin(elevation),
                     np.cos(azimuth) * np.cos(elevation)])
    axes = np.array([right, np.cross(back, right), back]) @ UPRIGHT[up]
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    x, y, z = axes @ (points - middle).T
    half = np.tan(FIELD_OF_VIEW / 2) / max(width, height)
    t, u = half * width * (1 - MARGIN), half * height * (1 - MARGIN)
    most_x, least_x = (x + t * z).max(), (t * z - x).max()
    most_y, least_y = (y + u * z).max(), (u * z - y).max()
    eye = np.array([(most_x - least_x) / 2, (most_y - least_y) / 2,
                    max((most_x + least_x) / (2 * t), (most_y + least_y) / (2 * u))])
    return middle + axes.T @ eye, axes, 2 * np.degrees(np.arctan(half * height / zoom))


def place(camera, eye, axes, angle):
    camera.SetPosition(eye)
    camera.SetFocalPoint(eye - axes[2])
    camera.SetViewUp(axes[1])
    camera.SetViewAngle(angle)


def view_of(path, array, width, height):
    reader = simple.XMLPolyDataReader(FileName=[path])
    reader.UpdatePipeline()
    if array not in reader.PointData.keys():
        sys.exit(f"peer: {path} has no array '{array}' of points")
    view = simple.CreateView("RenderView")
    view.ViewSize = [width, height]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    shown = simple.Show(reader, view)
    shown.Representation = "Surface LIC"
    shown.SelectInputVectors = ["POINTS", array]
    points = vtk_to_numpy(simple.servermanager.Fetch(reader).GetPoints().GetData())
    return view, points.astype(float)


def renderer_of(view):
    said = view.GetRenderWindow().ReportCapabilities().splitlines()
    return next((line.split(":", 1)[1].strip() for line in said if "renderer string" in line), "unknown")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("mesh")
    parser.add_argument("array")
    parser.add_argument("report")
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--frames", type=int, default=5)
    parser.add_argument("--camera", default="30,20,1", help="azimuth and elevation in degrees, zoom")
    parser.add_argument("--up", default="y", choices=UPRIGHT)
    parser.add_argument("--output")
    arguments = parser.parse_args()
    width, height = map(int, arguments.size.split("x"))
    view, points = view_of(arguments.mesh, arguments.array, width, height)
    eye, axes, angle = framed(points, list(map(float, arguments.camera.split(","))), arguments.up, width, height)
    camera = view.GetActiveCamera()
    step = 0.001 * np.linalg.norm(points.max(axis=0) - points.min(axis=0))
    milliseconds = []
    for i in range(arguments.frames + 1):
        # The last is the view of the picture.
        place(camera, eye + (arguments.frames - i) * step * axes[0], axes, angle)
        began = time.perf_counter()
        image = view.CaptureWindow(1)
        milliseconds.append(1000 * (time.perf_counter() - began))
    drawn = image.GetDimensions()
    if arguments.output:
        simple.SaveScreenshot(arguments.output, view, ImageResolution=[width, height])
    with open(arguments.report, "w") as out:
        json.dump({"picture_ms": min(milliseconds[1:]), "frames_ms": milliseconds,
                   "vertices": len(points), "width": drawn[0], "height": drawn[1],
                   "renderer": renderer_of(view), "version": str(simple.GetParaViewVersion())}, out)


main()
