/// Conversions between numpy arrays and the library.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
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
using namespace py::literals;

/// The number of arrays that were converted or copied for functions that can read in place. For
/// tests.
std::size_t converted_arrays();

/// Real numbers of one or two dimensions from a caller, of any type, order and stride.
struct Table {
  py::array array;         ///< owns the numbers; of a type that `view` supports
  ArrayView view;          ///< a row per entry of the first dimension
  bool is_number = false;  ///< no dimension: a row of one
};

/// `what` names the argument in messages. Masked numbers become NaN. Throws TypeError for other
/// than real numbers (complex numbers, booleans, text, objects), Error for ragged lists and for
/// more than two dimensions.
Table table_of(py::handle object, const std::string& what);

/// The object as an array without mask: masked numbers become NaN.
py::array unmasked(py::handle object);

/// Throws Error with the remedy for masked integers, which have no NaN.
void refuse_masked(py::handle object, const std::string& what);

/// Throws Error for an array without rows, which the library would treat as missing.
void check_not_empty(std::size_t rows, const std::string& what);

/// Throws Error, with the array's shape and the remedy, unless it has so many rows: one for each of
/// `of`.
void check_rows(const py::array& array, std::size_t rows, const std::string& what,
                const std::string& of, const std::string& remedy = "");

/// The same for a row per vertex. For arrays with a row per triangle, the message names the remedy.
void check_rows(const py::array& array, const Mesh& mesh, const std::string& what);

/// Rows of packed floats, valid during a call: in place if the array has that form, else a
/// converted copy.
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

/// A named array with a row per vertex or triangle; a copy. True and False become 1 and 0, tensors
/// (n, 3, 3) rows of nine numbers.
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

/// A read-only array that shares the memory of `owner` and keeps it alive.
py::array shared(const py::dtype& type, const void* data, const Shape& shape, py::handle owner);

/// As `shared`, for an array without another owner.
py::array array_owning(DataArray&& array);
py::dict dict_owning(std::vector<DataArray>&& arrays);

py::array shared(const DataArray& array, py::handle owner);

/// The numbers of rows: numbers themselves, vectors, or several indices, which are signed in Python
/// because unsigned differences surprise; no mesh here has 2^31 vertices.
template <class Row>
struct RowOf {
  using Number = Row;
};
template <>
struct RowOf<Index> {
  using Number = std::int32_t;
};
template <class Entry, std::size_t Columns>
struct RowOf<std::array<Entry, Columns>> : RowOf<Entry> {};
template <class Entry, int Columns>
struct RowOf<Eigen::Matrix<Entry, Columns, 1>> : RowOf<Entry> {};

template <class Row>
py::array shared_rows(std::span<const Row> rows, py::handle owner) {
  using Number = typename RowOf<Row>::Number;
  constexpr py::ssize_t kColumns = sizeof(Row) / sizeof(Number);
  const auto count = static_cast<py::ssize_t>(rows.size());
  return shared(py::dtype::of<Number>(), rows.data(),
                kColumns == 1 ? Shape{count} : Shape{count, kColumns}, owner);
}

/// A property: the rows of a vector, in shared memory.
template <class Data, class Rows>
void def_rows(py::class_<Data, std::shared_ptr<Data>>& type, const char* name, Rows rows) {
  type.def_property_readonly(name, [rows](py::handle self) {
    return shared_rows(std::span(rows(py::cast<const Data&>(self))), self);
  });
}

/// An array that takes over the vector's memory without copying.
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
