/// numpy arrays into the library and out of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>

#include "brindle/arrays.h"
#include "brindle/data_arrays.h"
#include "brindle/mesh.h"
#include "brindle/types.h"

namespace brindle::python {

namespace py = pybind11;

/// How many arrays were converted or copied so that functions that need no copy could read them.
/// For tests.
std::size_t converted_arrays();

/// Real numbers of one or two dimensions that a caller handed over, of any type, order and stride.
struct Table {
  py::array array;         ///< keeps the numbers alive; of a type that `view` knows
  ArrayView view;          ///< a row per entry of the first dimension
  bool is_number = false;  ///< no dimension at all: a row of one
};

/// `what` names the argument in messages. Numbers that numpy masks are NaN. Throws TypeError for
/// what holds no real numbers (complex ones, booleans, text, objects), Error for ragged lists and
/// for more dimensions than two.
Table table_of(py::handle object, const std::string& what);

/// The object as an array without mask: NaN where it masks numbers.
py::array unmasked(py::handle object);

/// Throws Error, naming the remedy, for whole numbers of which some are masked: they have no NaN.
void refuse_masked(py::handle object, const std::string& what);

/// Throws Error for an array without a row, which to the library would be as good as none.
void check_not_empty(std::size_t rows, const std::string& what);

/// Throws Error, with the array's shape and the remedy, unless it has so many rows: one for each of
/// `of`.
void check_rows(const py::array& array, std::size_t rows, const std::string& what,
                const std::string& of, const std::string& remedy = "");

/// The same for a row per vertex. For arrays with a row per triangle, the message names the remedy.
void check_rows(const py::array& array, const Mesh& mesh, const std::string& what);

/// Rows of packed floats that are read during a call: the array's own where they are that already,
/// otherwise a converted copy.
template <class Row>
class RowsIn {
 public:
  RowsIn() = default;
  /// Throws Error unless there is a row per vertex.
  RowsIn(py::handle object, const Mesh& mesh, const std::string& what);

  std::span<const Row> rows() const { return rows_; }

 private:
  py::array array_;
  std::vector<Row> converted_;
  std::span<const Row> rows_;
};
extern template class RowsIn<Vec3>;
extern template class RowsIn<float>;

/// Phases exp(i Phi), one per vertex, of complex numbers of either precision; a copy. 0 where they
/// are masked or not a number.
std::vector<Complex> phases_of(py::handle object, const Mesh& mesh, const std::string& what);

/// A named array of a row per vertex or triangle; a copy. Of True and False it has 1 and 0, of
/// tensors (n, 3, 3) rows of nine numbers.
DataArray data_array_of(const std::string& name, py::handle object);
/// The same of vertices: throws Error for another number of rows.
DataArray data_array_of(const std::string& name, py::handle object, const Mesh& mesh);
std::vector<DataArray> data_arrays_of(const py::dict& arrays);

/// The array among those of vertices or those of triangles, by its number of rows. Throws Error for
/// any other.
DataArrays surface_array_of(const Mesh& mesh, const std::string& name, py::handle object);

/// The means of numbers, or those of axes.
DataArray chosen(DataArray array, bool axes);

using Shape = std::vector<py::ssize_t>;

/// An array that shares memory with `owner`, which it keeps alive, and may not be written to.
py::array shared(const py::dtype& type, const void* data, const Shape& shape, py::handle owner);

/// As `shared`, of arrays that nobody else has.
py::array array_owning(DataArray&& array);
py::dict dict_owning(std::vector<DataArray>&& arrays);

template <class Number>
py::array shared(const Number* data, const Shape& shape, py::handle owner) {
  return shared(py::dtype::of<Number>(), data, shape, owner);
}
py::array shared(std::span<const Vec3> vectors, py::handle owner);
py::array shared(const DataArray& array, py::handle owner);

/// An array that owns what the vector held; nothing is copied.
template <class Number, class Entry>
py::array owned(std::vector<Entry>&& entries, Shape shape) {
  auto* kept = new std::vector<Entry>(std::move(entries));
  const py::capsule owner(kept,
                          [](void* vector) { delete static_cast<std::vector<Entry>*>(vector); });
  return py::array(py::dtype::of<Number>(), std::move(shape), {}, kept->data(), owner);
}
py::array owned(std::vector<Vec3>&& vectors);
template <class Number>
py::array owned(std::vector<Number>&& numbers) {
  const auto count = static_cast<py::ssize_t>(numbers.size());
  return owned<Number>(std::move(numbers), {count});
}

}  // namespace brindle::python
