/// VTK files as text, for tests of what the program makes of their arrays.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace brindle::test {

/// Rows of numbers, one after the other.
struct TextArray {
  std::string name;
  int components = 1;
  std::vector<double> numbers;
};

struct TextMesh {
  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<int, 3>> triangles;
  std::vector<TextArray> points = {};
  std::vector<TextArray> cells = {};
};

inline void write_array(std::ostream& out, const char* type, const TextArray& array) {
  out << "<DataArray type=\"" << type << "\" Name=\"" << array.name << "\" NumberOfComponents=\""
      << array.components << "\" format=\"ascii\">\n";
  for (const double number : array.numbers) {
    if (std::isnan(number)) {
      out << "nan ";
    } else {
      out << number << ' ';
    }
  }
  out << "\n</DataArray>\n";
}

/// A .vtp file; numbers are doubles, written exactly.
inline std::string vtp_text(const TextMesh& mesh) {
  TextArray positions{"Points", 3, {}}, corners{"connectivity", 1, {}}, ends{"offsets", 1, {}};
  for (const auto& p : mesh.positions)
    positions.numbers.insert(positions.numbers.end(), p.begin(), p.end());
  for (const auto& t : mesh.triangles) {
    corners.numbers.insert(corners.numbers.end(), t.begin(), t.end());
    ends.numbers.push_back(static_cast<double>(corners.numbers.size()));
  }
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n<PolyData>\n<Piece NumberOfPoints=\""
      << mesh.positions.size() << "\" NumberOfPolys=\"" << mesh.triangles.size()
      << "\">\n<PointData>\n";
  for (const TextArray& array : mesh.points) write_array(out, "Float64", array);
  out << "</PointData>\n<CellData>\n";
  for (const TextArray& array : mesh.cells) write_array(out, "Float64", array);
  out << "</CellData>\n<Points>\n";
  write_array(out, "Float32", positions);
  out << "</Points>\n<Polys>\n";
  write_array(out, "Int32", corners);
  write_array(out, "Int32", ends);
  out << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return out.str();
}

}  // namespace brindle::test
