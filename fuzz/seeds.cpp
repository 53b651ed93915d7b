#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

#include "brindle/data_arrays.h"
#include "brindle/files.h"
#include "brindle/shapes.h"
#include "targets.h"
#ifdef BRINDLE_FUZZ_SESSIONS
#include "fuzzed_session.h"
#endif

namespace brindle::fuzz {
namespace {

std::string written(const std::string& extension, const Mesh& mesh, bool with_arrays) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("brindle-seed-" + std::to_string(::getpid()) + "." + extension);
  DataArrays arrays;
  if (with_arrays) {
    const std::vector<float> numbers(3 * mesh.vertex_count(), 0.5f);
    arrays.points.push_back(make_data_array("normal", 3, numbers));
    const std::vector<float> stress(mesh.vertex_count(), 2.0f);
    arrays.points.push_back(make_data_array("stress", 1, stress));
  }
  write_mesh(path, mesh, fitted_arrays(path, arrays).arrays.points);
  std::ifstream in(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(in), {});
  in.close();
  std::filesystem::remove(path);
  return bytes;
}

/// In formats that are read and not written.
std::vector<std::string> plain_texts(std::string_view name) {
  if (name == "off") return {"OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n3 0 1 2\n3 1 3 2\n"};
  if (name == "stl") {
    return {
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nendsolid a\n",
        std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(12, '\0') +
            std::string("\0\0\0\0\0\0\0\0\0\0\0\0", 12) +
            std::string("\0\0\x80?\0\0\0\0\0\0\0\0", 12) +
            std::string("\0\0\0\0\0\0\x80?\0\0\0\0\0\0", 14)};
  }
  if (name == "vtk") {
    return {
        "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 "
        "1 0\nPOLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS s float 1\nLOOKUP_TABLE default\n1 "
        "2 3\nVECTORS v float\n1 0 0 0 1 0 0 0 1\n",
        "# vtk DataFile Version 4.2\na\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 "
        "0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nCELL_DATA 1\nFIELD f "
        "1\nm 1 1 int\n7\n"};
  }
  if (name == "vtu") {
    return {
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">"
        "<UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><Points><DataArray "
        "type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 "
        "0</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" "
        "format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int64\" Name=\"offsets\" "
        "format=\"ascii\">3</DataArray><DataArray type=\"UInt8\" Name=\"types\" "
        "format=\"ascii\">5</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>"};
  }
  if (name == "pvd") {
    return {
        "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" file=\"a.vtp\"/>"
        "<DataSet timestep=\"1\" file=\"b.vtp\"/></Collection></VTKFile>"};
  }
  if (name == "series") return {R"({"files": [{"name": "a.vtu", "time": 0.5}]})"};
  if (name == "pvtp") {
    return {
        "<VTKFile type=\"PPolyData\"><PPolyData GhostLevel=\"0\"><PPointData "
        "GlobalIds=\"g\"><PDataArray type=\"Int64\" Name=\"g\"/></PPointData><PPoints>"
        "<PDataArray type=\"Float32\" NumberOfComponents=\"3\"/></PPoints><Piece "
        "Source=\"a_0.vtp\"/></PPolyData></VTKFile>"};
  }
  if (name == "csv") return {"x,y,z,stress\n0,0,0,1\n1,0,0,2\n0,1,0,3\n", "0,0,0\n1,2,3\n"};
  if (name == "field") return {"1,0,0,9\n0,1,0,9\nnan,nan,nan,9\n0,0,1,8\n"};
#ifdef BRINDLE_FUZZ_SESSIONS
  if (name == "session") return {session_text()};
#endif
  if (name == "commands") {
    return {R"({"command": "set_option", "name": "stripes", "values": ["60"]})"
            "\n"
            R"({"command": "undo"})"
            "\n"};
  }
  if (name == "strokes") {
    return {R"({"strokes": [{"radius": 0.1, "strength": 2, "points": [[0, 0, 1], [0.5, 0, 1]]}]})"};
  }
  return {};
}

}  // namespace

std::vector<std::string> seeds(const Target& target) {
  const std::string name(target.name);
  if (name == "operations") return {std::string(200, '\x80'), std::string(200, '\x7f')};
  if (name == "pattern") {
    // A plain grid, one frequency, two frames.
    const std::string grid(62, '\x7f');
    return {grid + std::string("\0\x90\0\0\0\0\0\0\x80\2", 10) + std::string(40, '\1'),
            grid + grid + grid};
  }
  std::vector<std::string> all = plain_texts(name);
  if (!all.empty()) return all;
  const Mesh mesh = make_shape("sphere,resolution=1");
  return {written(name, mesh, false), written(name, mesh, true)};
}

}  // namespace brindle::fuzz
