"""Reads Brindle's mesh files back with other programs, renders them there and compares pictures.

    BRINDLE_TOOL=build/release/apps/brindle/brindle /usr/bin/python3 -m pytest tests/scripts/files_test.py [--mesh MESH]

VTK (python3-vtk9) reads and draws .obj with its material, .ply, .vtp, .gltf and .glb; Assimp's
command line (assimp-utils) turns .obj, .ply, .gltf and .glb into OBJ files, which VTK then draws.
Each picture is taken from where Brindle takes its own, and every pixel away from borders must show
metric or ground as Brindle's does. So must the sine of the phase, which VTK draws between vertices
(docs/paraview.md). All arrays of .vtp and .ply files must arrive bit for bit.

And the other way round: VTK writes .vtp, .vtu and .vtk files with arrays of all types, in all
encodings and compressions; Brindle reads them and writes them as .vtp, where VTK must find every
number as it was, bit for bit, at its point and in the triangles of its cell.

Needs a display, or Xvfb. Skipped without numpy and VTK.
"""

import itertools
import os
import re
import shutil
import subprocess

import pytest

from window_driver import Display

np = pytest.importorskip("numpy")
vtk = pytest.importorskip("vtk")
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402

WIDTH, HEIGHT = 800, 600
AZIMUTH_DEG, ELEVATION_DEG = 30, 20
FIELD_OF_VIEW_DEG, MARGIN = 28, 0.05  # of render/camera.cpp
FORMATS = ("obj", "ply", "vtp", "gltf", "glb")
ASSIMP_FORMATS = ("obj", "ply", "gltf", "glb")
WANTED_AGREEMENT = 0.99


@pytest.fixture(scope="module", autouse=True)
def display():
    """VTK draws on one, even without a window."""
    if os.environ.get("DISPLAY"):
        yield
        return
    if not shutil.which("Xvfb"):
        pytest.skip("no display; install xvfb")
    own = Display()
    os.environ["DISPLAY"] = own.name
    yield
    del os.environ["DISPLAY"]
    own.close()


@pytest.fixture
def mesh(pytestconfig):
    return pytestconfig.getoption("--mesh")


def camera_over(points, up_axis):
    """The camera with which render/camera.cpp frames the points."""
    azimuth, elevation = np.radians([AZIMUTH_DEG, ELEVATION_DEG])
    right = np.array([np.cos(azimuth), 0, -np.sin(azimuth)])
    back = np.array([np.sin(azimuth) * np.cos(elevation), np.sin(elevation),
                     np.cos(azimuth) * np.cos(elevation)])
    axes = np.array([right, np.cross(back, right), back])
    if up_axis == "z":
        axes = axes @ np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    origin = (points.min(axis=0) + points.max(axis=0)) / 2
    x, y, z = axes @ (points - origin).T
    t = np.tan(np.radians(FIELD_OF_VIEW_DEG / 2))
    u = t * HEIGHT / WIDTH
    inner_t, inner_u = t * (1 - MARGIN), u * (1 - MARGIN)
    extent_right, extent_left = (x + inner_t * z).max(), (-x + inner_t * z).max()
    extent_top, extent_bottom = (y + inner_u * z).max(), (-y + inner_u * z).max()
    eye = np.array([(extent_right - extent_left) / 2, (extent_top - extent_bottom) / 2,
                    max((extent_right + extent_left) / (2 * inner_t),
                        (extent_top + extent_bottom) / (2 * inner_u))])
    camera = vtk.vtkCamera()
    camera.SetPosition(*(origin + axes.T @ eye))
    camera.SetFocalPoint(*(origin + axes.T @ (eye - [0, 0, 1])))
    camera.SetViewUp(*axes[1])
    camera.SetViewAngle(np.degrees(2 * np.arctan(u)))
    return camera


def textured_actor(reader, picture):
    """What a reader gives, with a picture that repeats."""
    reader.Update()
    data = reader.GetOutput()
    if data.GetPointData().GetTCoords() is None:
        raise RuntimeError("the reader finds no texture coordinates")
    png = vtk.vtkPNGReader()
    png.SetFileName(picture)
    texture = vtk.vtkTexture()
    texture.SetInputConnection(png.GetOutputPort())
    texture.InterpolateOn()
    texture.MipmapOn()
    texture.RepeatOn()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.SetTexture(texture)
    return actor


def add_file(path, picture, window, renderer):
    """Reads the file into the renderer."""
    kind = os.path.splitext(path)[1]
    if kind in (".gltf", ".glb"):
        importer = vtk.vtkGLTFImporter()
        importer.SetFileName(path)
        importer.SetRenderWindow(window)
        importer.Update()
    elif kind == ".obj" and os.path.exists(path[:-4] + ".mtl"):
        importer = vtk.vtkOBJImporter()
        importer.SetFileName(path)
        importer.SetFileNameMTL(path[:-4] + ".mtl")
        importer.SetTexturePath(os.path.dirname(path))
        importer.SetRenderWindow(window)
        importer.Update()
    else:
        reader = {".obj": vtk.vtkOBJReader, ".ply": vtk.vtkPLYReader,
                  ".vtp": vtk.vtkXMLPolyDataReader}[kind]()
        reader.SetFileName(path)
        renderer.AddActor(textured_actor(reader, picture))


def unlit(renderer):
    """Shows every actor's own picture, also of the materials of glTF, which ask for light."""
    actors = renderer.GetActors()
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        actor = actors.GetNextActor()
        picture = actor.GetProperty().GetTexture("albedoTex")
        if picture:
            actor.SetTexture(picture)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetInterpolationToFlat()


def picture_of(window, renderer, camera, path):
    unlit(renderer)
    renderer.SetActiveCamera(camera)
    renderer.SetBackground(0, 1, 0)
    renderer.ResetCameraClippingRange()
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.SetInputBufferTypeToRGB()
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


def off_screen():
    """A window without samples, and its renderer."""
    renderer = vtk.vtkRenderer()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(WIDTH, HEIGHT)
    window.AddRenderer(renderer)
    return window, renderer


def rendered(path, picture, camera, out):
    """The file as VTK draws it, without light."""
    window, renderer = off_screen()
    add_file(path, picture, window, renderer)
    picture_of(window, renderer, camera, out)
    return pixels_of(out)


def pixels_of(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(HEIGHT, WIDTH, -1)[..., :3].astype(float)


def metric(pixels):
    """Whether a pixel has the dark blue of the metric: light changes its level, not its hue."""
    return pixels[..., 0] < 0.7 * pixels[..., 2]


def grown(mask, pixels):
    for _ in range(pixels):
        wide = mask.copy()
        wide[1:] |= mask[:-1]
        wide[:-1] |= mask[1:]
        wide[:, 1:] |= mask[:, :-1]
        wide[:, :-1] |= mask[:, 1:]
        mask = wide
    return mask


def away_from_borders(mask):
    return ~(grown(mask, 2) & grown(~mask, 2))


def agreement(ours, theirs):
    """The share of pixels that show the same, of all that show the surface away from borders."""
    green = (theirs[..., 1] > 200) & (theirs[..., 0] < 60) & (theirs[..., 2] < 60)
    a, b = metric(ours), metric(theirs)
    counted = ~grown(green, 3) & away_from_borders(a) & away_from_borders(b)
    if counted.sum() < 0.05 * WIDTH * HEIGHT:
        return 0.0
    both = [(a & counted).sum(), (~a & counted).sum()]
    if min(both) < 0.01 * counted.sum():
        return 0.0  # one of metric and ground is missing: nothing would be compared
    return ((a == b) & counted).sum() / counted.sum()


def write_all(brindle, mesh, tile, folder):
    names = [f"{tile}.{kind}" for kind in FORMATS]
    # Files have all tiles, and say which are broken.
    command = [brindle, "stripe", mesh, "--texture", f"{tile},cut", "--stripes", "16", "--quiet",
               "--size", f"{WIDTH}x{HEIGHT}", "--output", f"{tile}.png"]
    for name in names:
        command += ["--output", name]
    subprocess.run(command, cwd=folder, check=True, stderr=subprocess.DEVNULL)


def vtp_of(path):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def check_attributes(data):
    """Phases, directions and frequencies of both waves must have arrived as they are defined."""
    for suffix in ("", "_v"):
        values = {name: vtk_to_numpy(data.GetPointData().GetArray(name + suffix))
                  for name in ("phase", "direction", "frequency", "branch", "sin_phase", "valid")}
        wave = values["valid"] == 1
        assert wave.mean() > 0.99 and np.isnan(values["phase"][~wave]).all()
        assert np.isnan(values["sin_phase"][~wave]).all()
        assert np.abs(values["phase"][wave]).max() <= np.pi + 1e-6
        assert np.abs(values["sin_phase"] - np.sin(values["phase"]))[wave].max() < 1e-6
        lengths = np.linalg.norm(values["direction"], axis=1)
        # None in the middle of a singularity.
        assert (np.minimum(lengths, np.abs(lengths - 1)) < 1e-3).all() and lengths.mean() > 0.99
        assert values["frequency"].min() > 0
        assert set(np.unique(values["branch"])) <= {0, 1}
        # Where the mesh shows U and V, they are phases over a turn, plus a quarter.
        coordinates = vtk_to_numpy(data.GetPointData().GetTCoords())[:, 1 if suffix else 0][wave]
        turns = values["phase"][wave] / (2 * np.pi) + 0.25
        off = np.minimum(np.abs(coordinates - turns - np.round(coordinates - turns)),
                         np.abs(coordinates + turns - np.round(coordinates + turns)))
        assert np.median(off) < 1e-5 and (off > 1e-3).mean() < 0.01


def through_assimp(folder, name):
    """The file as Assimp understands it, written as OBJ; without material, the picture stays ours."""
    converted = os.path.join(folder, "assimp_" + name.replace(".", "_") + ".obj")
    subprocess.run(["assimp", "export", name, converted], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    if os.path.exists(converted[:-4] + ".mtl"):
        os.remove(converted[:-4] + ".mtl")
    return converted


@pytest.mark.parametrize("tile", ("stripes", "arrows", "bricks"))
def test_textures_are_drawn_alike(tool, mesh, tile, tmp_path):
    folder = str(tmp_path)
    write_all(tool, mesh, tile, folder)
    ours = pixels_of(os.path.join(folder, f"{tile}.png"))
    vtp = vtp_of(os.path.join(folder, f"{tile}.vtp"))
    check_attributes(vtp)
    camera = camera_over(vtk_to_numpy(vtp.GetPoints().GetData()).astype(float),
                         "z" if mesh.startswith("shape:") else "y")
    picture = os.path.join(folder, f"{tile}_texture.png")
    files = [(f"VTK {kind}", os.path.join(folder, f"{tile}.{kind}")) for kind in FORMATS]
    if shutil.which("assimp"):
        files += [(f"Assimp {kind}", through_assimp(folder, f"{tile}.{kind}"))
                  for kind in ASSIMP_FORMATS]
    else:
        print("assimp is missing; install assimp-utils for the other half")
    shares = {}
    for name, path in files:
        out = os.path.join(folder, f"{tile}_in_{name.replace(' ', '_').lower()}.png")
        shares[name] = agreement(ours, rendered(path, picture, camera, out))
    assert min(shares.values()) >= WANTED_AGREEMENT, f"pixels that agree: {shares}; see {folder}"


NUMPY_TYPES = {"Float32": "<f4", "Float64": "<f8", "Int8": "i1", "UInt8": "u1", "Int16": "<i2",
               "UInt16": "<u2", "Int32": "<i4", "UInt32": "<u4", "Int64": "<i8", "UInt64": "<u8"}


def arrays_in_file(path):
    """The arrays of points and cells as they stand in a .vtp file of Brindle's."""
    with open(path, "rb") as file:
        content = file.read()
    begin = content.index(b'<AppendedData encoding="raw">\n_') + len('<AppendedData encoding="raw">\n_')
    found = {}
    for section in ("PointData", "CellData"):
        xml = re.search(rf"<{section}.*?</{section}>", content[:begin].decode(), re.S).group()
        for kind, name, offset in re.findall(r'type="(\w+)" Name="([^"]*)".*?offset="(\d+)"', xml):
            at = begin + int(offset)
            size = int.from_bytes(content[at:at + 8], "little")
            found[section, name] = np.frombuffer(content[at + 8:at + 8 + size], NUMPY_TYPES[kind])
    return found


def check_vtp_arrays(path):
    """VTK must find every array of the file, with its type, bit for bit."""
    data = vtp_of(path)
    expected = arrays_in_file(path)
    for (section, name), numbers in expected.items():
        attributes = data.GetPointData() if section == "PointData" else data.GetCellData()
        read = vtk_to_numpy(attributes.GetArray(name))
        assert read.dtype == numbers.dtype and read.tobytes() == numbers.tobytes(), (path, name)
    count = data.GetPointData().GetNumberOfArrays() + data.GetCellData().GetNumberOfArrays()
    assert count == len(expected) > 0, path


def check_ply_faces(path, triangles):
    """Properties of faces must not keep VTK from reading them."""
    reader = vtk.vtkPLYReader()
    reader.SetFileName(path)
    reader.Update()
    assert reader.GetOutput().GetNumberOfPolys() == triangles, path


def test_arrays_arrive_bit_for_bit(tool, mesh, tmp_path):
    folder = str(tmp_path)

    def write(command, *outputs):
        arguments = [tool, *command, "--quiet"]
        for name in outputs:
            arguments += ["--output", name]
        subprocess.run(arguments, cwd=folder, check=True, stderr=subprocess.DEVNULL)

    write(["stripe", mesh], "plain.vtp", "plain.ply")
    write(["stripe", mesh, "--uv"], "uv.vtp", "uv.ply")
    write(["curves", mesh, "--lines", "both", "--join"], "curves.vtp")
    write(["sample", mesh], "samples.vtp")
    for name in ("plain", "uv", "curves", "samples"):
        check_vtp_arrays(os.path.join(folder, name + ".vtp"))
    for name in ("plain", "uv"):
        triangles = vtp_of(os.path.join(folder, name + ".vtp")).GetNumberOfPolys()
        check_ply_faces(os.path.join(folder, name + ".ply"), triangles)


def sine_actor(data):
    """Two colours, above and below zero, between vertices (docs/paraview.md)."""
    data.GetPointData().SetActiveScalars("sin_phase")
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(2)
    table.SetTableRange(-1, 1)
    table.Build()
    table.SetTableValue(0, 1, 1, 1, 1)
    table.SetTableValue(1, 0, 0, 0.5, 1)
    table.SetNanColor(1, 1, 1, 1)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(-1, 1)
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def test_sine_is_drawn_alike(tool, mesh, tmp_path):
    """Where sin_phase is above zero, Brindle draws a stripe, on a mesh with many edges a period."""
    folder = str(tmp_path)
    subprocess.run([tool, "stripe", mesh, "--subdivide", "1", "--stripes", "16", "--quiet",
                    "--size", f"{WIDTH}x{HEIGHT}", "--output", "sine.vtp", "--output", "sine.png"],
                   cwd=folder, check=True, stderr=subprocess.DEVNULL)
    ours = pixels_of(os.path.join(folder, "sine.png"))
    data = vtp_of(os.path.join(folder, "sine.vtp"))
    window, renderer = off_screen()
    renderer.AddActor(sine_actor(data))
    camera = camera_over(vtk_to_numpy(data.GetPoints().GetData()).astype(float),
                         "z" if mesh.startswith("shape:") else "y")
    out = os.path.join(folder, "sine_in_vtk.png")
    picture_of(window, renderer, camera, out)
    share = agreement(ours, pixels_of(out))
    assert share >= WANTED_AGREEMENT, f"{100 * share:.2f} % of pixels agree; see {out}"


NUMBERS = ("float32", "float64", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64",
           "uint64")
COMPONENTS = (1, 3, 2, 9, 6, 1, 3, 1, 1, 4)
POINTS = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0), (0, 2, 0), (1, 2, 0),
          (2, 2, 0.5)]


def cells_of(lists):
    cells = vtk.vtkCellArray()
    for points in lists:
        cells.InsertNextCell(len(points), points)
    return cells


def add_arrays(data, rows, random):
    """Arrays of all types, with numbers of all sizes, and one that numbers the rows."""
    for kind, components in zip(NUMBERS, COMPONENTS):
        size = (rows, components)
        if np.issubdtype(kind, np.floating):
            values = (random.standard_normal(size) * 10.0 ** random.integers(-30, 15, size))
            values = values.astype(kind)
        else:
            values = random.integers(np.iinfo(kind).min, np.iinfo(kind).max, size, kind, True)
        array = numpy_to_vtk(values, deep=True)
        array.SetName(f"{kind} of \u00e4")
        data.AddArray(array)
    numbers = numpy_to_vtk(np.arange(rows, dtype=np.int32), deep=True)
    numbers.SetName("number")
    data.AddArray(numbers)


def vtk_points():
    points = vtk.vtkPoints()
    for point in POINTS:
        points.InsertNextPoint(*point)
    return points


def poly_data():
    data = vtk.vtkPolyData()
    data.SetPoints(vtk_points())
    data.SetVerts(cells_of([[0], [1, 2]]))
    data.SetLines(cells_of([[0, 1, 2], [3, 4], [1, 5]]))
    data.SetPolys(cells_of([[0, 1, 4, 3], [4, 5, 8]]))
    data.SetStrips(cells_of([[3, 4, 6, 7], [1, 2, 4]]))
    return data


def grid():
    data = vtk.vtkUnstructuredGrid()
    data.SetPoints(vtk_points())
    for kind, points in ((vtk.VTK_QUAD, [0, 1, 4, 3]), (vtk.VTK_TETRA, [0, 1, 3, 8]),
                         (vtk.VTK_PIXEL, [1, 2, 4, 5]), (vtk.VTK_LINE, [0, 1]),
                         (vtk.VTK_TRIANGLE_STRIP, [3, 4, 6, 7]), (vtk.VTK_TRIANGLE, [4, 5, 8])):
        data.InsertNextCell(kind, len(points), points)
    return data


def xml_files(data, folder):
    """The data in every form of VTK's XML, with the compressor."""
    kind = "vtp" if data.IsA("vtkPolyData") else "vtu"
    writer = vtk.vtkXMLPolyDataWriter() if kind == "vtp" else vtk.vtkXMLUnstructuredGridWriter()
    writer.SetInputData(data)
    compressors = {"none": None, "zlib": vtk.vtkZLibDataCompressor(),
                   "lz4": vtk.vtkLZ4DataCompressor(), "lzma": vtk.vtkLZMADataCompressor()}
    for mode, compressor, size, order in itertools.product(
            ("ascii", "binary", "appended", "raw"), compressors, (32, 64), ("little", "big")):
        {"ascii": writer.SetDataModeToAscii, "binary": writer.SetDataModeToBinary,
         "appended": writer.SetDataModeToAppended, "raw": writer.SetDataModeToAppended}[mode]()
        writer.SetEncodeAppendedData(mode == "appended")
        writer.SetCompressor(compressors[compressor])
        writer.SetHeaderType(size)
        writer.SetByteOrder(1 if order == "little" else 0)
        writer.SetNumberOfPieces(2 if kind == "vtp" and order == "big" else 1)
        name = f"{mode}_{compressor}_{size}_{order}.{kind}"
        writer.SetFileName(os.path.join(folder, name))
        writer.Write()
        yield name, compressor


def legacy_files(data, folder):
    kind = "polydata" if data.IsA("vtkPolyData") else "grid"
    writer = vtk.vtkPolyDataWriter() if kind == "polydata" else vtk.vtkUnstructuredGridWriter()
    writer.SetInputData(data)
    for version, binary in itertools.product((42, 51), (False, True)):
        writer.SetFileVersion(version)
        writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
        name = f"{kind}_{version}_{'binary' if binary else 'ascii'}.vtk"
        writer.SetFileName(os.path.join(folder, name))
        writer.Write()
        yield name, "none"


def read_by_vtk(path):
    kind = os.path.splitext(path)[1]
    if kind == ".vtk":
        reader = vtk.vtkGenericDataObjectReader()
    else:
        reader = (vtk.vtkXMLPolyDataReader() if kind == ".vtp"
                  else vtk.vtkXMLUnstructuredGridReader())
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def points_of_cells(data):
    cells = []
    for c in range(data.GetNumberOfCells()):
        points = data.GetCell(c).GetPointIds()
        cells.append({points.GetId(i) for i in range(points.GetNumberOfIds())})
    return cells


def same_rows(theirs, ours, rows):
    """Whether each array of theirs is in ours, of its type, with these of its rows."""
    for i in range(theirs.GetNumberOfArrays()):
        array = theirs.GetArray(i)
        other = ours.GetArray(array.GetName())
        if other is None:
            return f"has lost '{array.GetName()}'"
        wanted, found = vtk_to_numpy(array)[rows], vtk_to_numpy(other)
        if wanted.dtype != found.dtype or wanted.tobytes() != found.tobytes():
            return f"has changed '{array.GetName()}'"
    return ""


def difference(theirs, ours):
    """What is wrong with a mesh that Brindle has written, or nothing."""
    if ours.GetNumberOfPoints() != theirs.GetNumberOfPoints():
        return "has other points"
    wrong = same_rows(theirs.GetPointData(), ours.GetPointData(), slice(None))
    # Pieces repeat each other, so any cell of that number will do.
    numbers = list(vtk_to_numpy(theirs.GetCellData().GetArray("number")))
    cell_of = [numbers.index(n) for n in vtk_to_numpy(ours.GetCellData().GetArray("number"))]
    wrong = wrong or same_rows(theirs.GetCellData(), ours.GetCellData(), cell_of)
    cells = points_of_cells(theirs)
    outside = [t for t, points in enumerate(points_of_cells(ours))
               if not points <= cells[cell_of[t]]]
    return wrong or ("has triangles with rows of other cells" if outside else "")


def test_files_of_vtk_are_read(tool, tmp_path):
    random, folder = np.random.default_rng(5), str(tmp_path)
    problems = {}
    for data in (poly_data(), grid()):
        add_arrays(data.GetPointData(), data.GetNumberOfPoints(), random)
        add_arrays(data.GetCellData(), data.GetNumberOfCells(), random)
        for name, compressor in [*xml_files(data, folder), *legacy_files(data, folder)]:
            path = os.path.join(folder, name)
            result = subprocess.run(
                [tool, "stripe", path, "--direction", "0.3,1,0", "--frequency", "1", "--quiet",
                 "--crease-angle", "180", "--output", path + ".out.vtp"], capture_output=True, text=True, check=False)
            if compressor in ("lz4", "lzma"):
                problem = "" if result.returncode == 1 and "ZLib" in result.stderr else "is read"
            elif result.returncode != 0:
                problem = "is refused: " + result.stderr
            else:
                problem = difference(read_by_vtk(path), read_by_vtk(path + ".out.vtp"))
            problems[path] = problem
    assert len(problems) > 100 and not any(problems.values()), problems


def volume_of(kind):
    """Blocks of cells of one kind, bent so that faces with points amid their edges are curved."""
    source = vtk.vtkCellTypeSource()
    source.SetCellType(kind)
    source.SetBlocksDimensions(3, 2, 2)
    source.Update()
    data = vtk.vtkUnstructuredGrid()
    data.DeepCopy(source.GetOutput())
    data.GetPointData().Initialize()
    data.GetCellData().Initialize()
    places = vtk_to_numpy(data.GetPoints().GetData()).astype(np.float32)
    x, y, z = places.T
    places = np.stack([x + 0.1 * y * y, y + 0.05 * np.sin(z), z + 0.05 * x * x], axis=1)
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(places.astype(np.float32), deep=True))
    data.SetPoints(points)
    random = np.random.default_rng(kind)
    add_arrays(data.GetPointData(), data.GetNumberOfPoints(), random)
    add_arrays(data.GetCellData(), data.GetNumberOfCells(), random)
    return data


def boundary_by_vtk(data):
    """The surface, its curved faces cut at the points amid their edges, with its cells' rows."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(data)
    surface.SetNonlinearSubdivisionLevel(1)
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(surface.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def metrics_of(surface):
    """Volume inside and area."""
    mass = vtk.vtkMassProperties()
    mass.SetInputData(surface)
    mass.Update()
    return np.array([mass.GetVolume(), mass.GetSurfaceArea()])


def boundary_difference(data, theirs, ours):
    wrong = difference(data, ours)
    numbers = [set(vtk_to_numpy(s.GetCellData().GetArray("number"))) for s in (theirs, ours)]
    if numbers[0] != numbers[1]:
        return "has faces of other cells than VTK"
    # Quadrangles may be cut along their other diagonal.
    apart = np.abs(metrics_of(ours) / metrics_of(theirs) - 1).max()
    return wrong or (f"has another volume or area, by {apart:.3g}" if apart > 0.01 else "")


@pytest.mark.parametrize("kind", (
    vtk.VTK_TETRA, vtk.VTK_HEXAHEDRON, vtk.VTK_WEDGE, vtk.VTK_PYRAMID, vtk.VTK_QUADRATIC_TETRA,
    vtk.VTK_QUADRATIC_HEXAHEDRON, vtk.VTK_QUADRATIC_WEDGE, vtk.VTK_QUADRATIC_PYRAMID))
def test_boundary_of_volumes_is_vtks(tool, kind, tmp_path):
    data, path = volume_of(kind), str(tmp_path / "volume.vtu")
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.Write()
    subprocess.run([tool, "stripe", path, "--direction", "0.3,1,0", "--frequency", "1", "--quiet", "--crease-angle",
                    "180", "--output", path + ".out.vtp"], check=True)
    assert boundary_difference(data, boundary_by_vtk(data), read_by_vtk(path + ".out.vtp")) == ""
