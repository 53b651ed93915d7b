#include "arrays.h"

#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "brindle/error.h"

namespace brindle::python {
namespace {

std::atomic<std::size_t> conversions{0};

std::optional<NumberType> number_type_of(const py::dtype& type) {
  const bool native = type.byteorder() != (std::endian::native == std::endian::little ? '>' : '<');
  const py::ssize_t size = type.itemsize();
  if (!native) return std::nullopt;
  if (type.kind() == 'f') {
    if (size == 4) return NumberType::float32;
    return size == 8 ? std::optional(NumberType::float64) : std::nullopt;
  }
  const int exponent = std::countr_zero(static_cast<unsigned>(size));
  return static_cast<NumberType>(static_cast<int>(NumberType::int8) + 2 * exponent +
                                 (type.kind() == 'i' ? 0 : 1));
}

py::dtype dtype_of(NumberType type) {
  static constexpr const char* kNames[] = {"f4", "f8", "i1", "u1", "i2",
                                           "u2", "i4", "u4", "i8", "u8"};
  return py::dtype(kNames[static_cast<std::size_t>(type)]);
}

bool is_masked_array(py::handle object) {
  const auto& numpy = py::detail::npy_api::get();
  if (Py_TYPE(object.ptr()) == numpy.PyArray_Type_ || !py::isinstance<py::array>(object)) {
    return false;  // the usual case, and free
  }
  return py::isinstance(object, py::module_::import("numpy.ma").attr("MaskedArray"));
}

bool has_masked(py::handle object) {
  return is_masked_array(object) &&
         py::cast<bool>(py::module_::import("numpy.ma").attr("is_masked")(object));
}

// NaN at masked entries.
py::array without_mask(py::array array) {
  if (!is_masked_array(array)) return array;
  if (!has_masked(array)) return array.attr("data");
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'c') array = array.attr("astype")("f8");
  return array.attr("filled")(std::numeric_limits<double>::quiet_NaN());
}

// numpy's conversion of an object. Objects that numpy cannot read are arguments of the wrong shape.
py::array array_of(py::handle object, const std::string& what) {
  if (py::isinstance<py::array>(object)) {
    auto array = py::reinterpret_borrow<py::array>(object);
    const char kind = array.dtype().kind();
    return kind == 'O' || kind == 'U' || kind == 'S' ? array : without_mask(std::move(array));
  }
  if (object.is_none()) throw py::type_error(what + ": expected numbers, got None");
  try {
    return py::module_::import("numpy").attr("asarray")(object);
  } catch (py::error_already_set& error) {
    if (error.matches(PyExc_ValueError))
      throw Error(what + ": no table of numbers: " + error.what());
    if (error.matches(PyExc_TypeError)) {
      throw py::type_error(what + ": expected numbers: " + error.what());
    }
    throw;
  }
}

std::string text_of(const py::object& object) { return py::cast<std::string>(py::str(object)); }

bool has_rows(const py::array& array, std::size_t rows) {
  return array.ndim() > 0 && static_cast<std::size_t>(array.shape(0)) == rows;
}

// Signs of vectors need not agree from triangle to triangle, as those of fibres do not.
std::string remedy_of_cells(const py::array& array, const Mesh& mesh, const std::string& what) {
  if (!has_rows(array, mesh.triangle_count())) return "";
  const bool vectors = array.ndim() == 2 && (array.shape(1) == 2 || array.shape(1) == 3);
  return ", a row per triangle; give surface.cells_to_points(" + what +
         (vectors ? ", axes=True)" : ")");
}

[[noreturn]] void refuse_type(const std::string& what, const py::dtype& type) {
  throw py::type_error(what + ": expected real numbers, got " + text_of(type));
}

template <class Row>
constexpr int kColumns = sizeof(Row) / sizeof(float);

// Whether the rows can be read in place.
template <class Row>
bool is_packed(const Table& table) {
  constexpr int kDimensions = kColumns<Row> == 1 ? 1 : 2;
  return table.view.type() == NumberType::float32 && table.array.ndim() == kDimensions &&
         static_cast<int>(table.view.columns()) == kColumns<Row> &&
         (table.array.flags() & py::array::c_style) != 0 &&
         reinterpret_cast<std::uintptr_t>(table.array.data()) % alignof(float) == 0;
}

std::vector<Vec3> converted(const ArrayView& view, const std::string& what, Vec3 /*row*/) {
  return vectors_of(view, what);
}
std::vector<float> converted(const ArrayView& view, const std::string& what, float /*row*/) {
  return numbers_of(view, what);
}

}  // namespace

std::size_t converted_arrays() { return conversions; }

namespace {

Table table_of_array(py::array array, const std::string& what) {
  const char kind = array.dtype().kind();
  const py::ssize_t dimensions = array.ndim();
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    if (array.size() > 0 || kind == 'O') refuse_type(what, array.dtype());
    array = array.attr("astype")("f8");  // an empty object has no type
  }
  if (dimensions > 2) {
    throw Error(what + ": an array of " + std::to_string(dimensions) +
                " dimensions; it must have one row per entry");
  }
  // Half and long double precision, and foreign byte order.
  if (!number_type_of(array.dtype())) {
    array = array.attr("astype")(kind == 'f' ? py::dtype("f8")
                                             : array.dtype().attr("newbyteorder")("="));
  }
  const auto rows = dimensions > 0 ? array.shape(0) : 1;
  const auto columns = dimensions > 1 ? array.shape(1) : 1;
  const ArrayView view(array.data(), *number_type_of(array.dtype()), static_cast<std::size_t>(rows),
                       static_cast<std::size_t>(columns), dimensions > 0 ? array.strides(0) : 0,
                       dimensions > 1 ? array.strides(1) : 0);
  return {std::move(array), view, dimensions == 0};
}

}  // namespace

Table table_of(py::handle object, const std::string& what) {
  return table_of_array(array_of(object, what), what);
}

py::array unmasked(py::handle object) { return array_of(object, "array"); }

void refuse_masked(py::handle object, const std::string& what) {
  if (!has_masked(object)) return;
  throw Error(what +
              ": some are masked, and whole numbers have no NaN; fill them, or leave "
              "those rows out");
}

void check_not_empty(std::size_t rows, const std::string& what) {
  if (rows > 0) return;
  throw Error(what + ": the array is empty; leave it out, or give a row to each");
}

void check_rows(const py::array& array, std::size_t rows, const std::string& what,
                const std::string& of, const std::string& remedy) {
  if (has_rows(array, rows)) return;
  check_not_empty(static_cast<std::size_t>(array.size()), what);
  throw Error(what + ": expected a row for each of " + std::to_string(rows) + " " + of +
              ", got the shape " + text_of(array.attr("shape")) + remedy);
}

void check_rows(const py::array& array, const Mesh& mesh, const std::string& what) {
  check_rows(array, mesh.vertex_count(), what, "vertices", remedy_of_cells(array, mesh, what));
}

template <class Row>
RowsIn<Row>::RowsIn(py::handle object, const Mesh& mesh, const std::string& what) {
  Table table = table_of(object, what);
  check_rows(table.array, mesh, what);
  if (is_packed<Row>(table)) {
    rows_ = {static_cast<const Row*>(table.array.data()), table.view.rows()};
  } else {
    converted_ = converted(table.view, what, Row());
    rows_ = converted_;
    ++conversions;
  }
  array_ = std::move(table.array);
}
template class RowsIn<Vec3>;
template class RowsIn<float>;

std::vector<Complex> phases_of(py::handle object, const Mesh& mesh, const std::string& what) {
  const py::array array = array_of(object, what);
  if (array.dtype().kind() != 'c') {
    throw py::type_error(what + ": expected complex numbers, got " + text_of(array.dtype()));
  }
  check_rows(array, mesh, what);
  if (array.ndim() != 1) throw Error(what + ": expected one number per vertex");
  const py::array_t<Complex, py::array::c_style | py::array::forcecast> numbers(array);
  std::vector<Complex> phases(numbers.data(), numbers.data() + numbers.size());
  for (Complex& z : phases) {
    if (std::isnan(z.real()) || std::isnan(z.imag())) z = 0;
  }
  return phases;
}

DataArray data_array_of(const std::string& name, py::handle object) {
  const std::string what = "array '" + name + "'";
  py::array given = array_of(object, what);
  if (given.dtype().kind() == 'b') given = given.attr("astype")("u1");
  if (given.ndim() == 3 && given.shape(1) == 3 && given.shape(2) == 3) {
    given = given.attr("reshape")(given.shape(0), 9);
  }
  if (given.ndim() > 2) {
    throw Error(what + ": rows of " + std::to_string(given.ndim() - 1) +
                " dimensions; give rows of numbers, (n,) or (n, k), or tensors (n, 3, 3)");
  }
  const Table table = table_of_array(std::move(given), what);
  if (table.view.columns() == 0) throw Error("array '" + name + "': its rows have no numbers");
  const py::array packed = py::module_::import("numpy").attr("ascontiguousarray")(table.array);
  DataArray array{name, table.view.type(), static_cast<int>(table.view.columns()), {}};
  const auto* bytes = static_cast<const std::byte*>(packed.data());
  array.bytes.assign(bytes, bytes + packed.nbytes());
  return array;
}

DataArray data_array_of(const std::string& name, py::handle object, const Mesh& mesh) {
  const py::array array = array_of(object, name);
  check_rows(array, mesh, name);
  return data_array_of(name, array);
}

std::vector<DataArray> data_arrays_of(const py::dict& arrays) {
  std::vector<DataArray> result;
  for (const auto& [name, array] : arrays) {
    if (!py::isinstance<py::str>(name)) throw py::type_error("names of arrays are strings");
    result.push_back(data_array_of(py::cast<std::string>(name), array));
  }
  return result;
}

DataArrays surface_array_of(const Mesh& mesh, const std::string& name, py::handle object) {
  DataArray array = data_array_of(name, object);
  const std::size_t rows = array.rows();
  if (rows == mesh.vertex_count()) return {{std::move(array)}, {}};
  if (rows == mesh.triangle_count() && rows > 0) return {{}, {std::move(array)}};
  throw Error("array '" + name + "': it has " + std::to_string(rows) + " rows for " +
              std::to_string(mesh.vertex_count()) + " vertices and " +
              std::to_string(mesh.triangle_count()) + " triangles");
}

DataArray chosen(DataArray array, bool axes) {
  if (axes && !array.axis_bytes.empty()) array.bytes = std::move(array.axis_bytes);
  return array;
}

py::array shared(const py::dtype& type, const void* data, const Shape& shape, py::handle owner) {
  py::array array(type, shape, {}, data, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::array shared(const DataArray& array, py::handle owner) {
  const auto rows = static_cast<py::ssize_t>(array.rows());
  return shared(dtype_of(array.type), array.bytes.data(),
                array.components == 1 ? Shape{rows} : Shape{rows, array.components}, owner);
}

py::array array_owning(DataArray&& array) {
  auto* kept = new DataArray(std::move(array));
  const py::capsule owner(kept, [](void* made) { delete static_cast<DataArray*>(made); });
  return shared(*kept, owner);
}

py::dict dict_owning(std::vector<DataArray>&& arrays) {
  py::dict result;
  for (DataArray& array : arrays) {
    const py::str name(array.name);
    result[name] = array_owning(std::move(array));
  }
  return result;
}

py::array owned(std::vector<Vec3>&& vectors) {
  const auto count = static_cast<py::ssize_t>(vectors.size());
  return owned<float>(std::move(vectors), {count, 3});
}

}  // namespace brindle::python
