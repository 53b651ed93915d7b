/// Objects as bytes, for pickle and copy.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include <nlohmann/json.hpp>
#include <pybind11/pybind11.h>

#include "brindle/curves.h"
#include "brindle/error.h"
#include "brindle/samples.h"
#include "brindle/version.h"
#include "pattern_data.h"
#include "surface_data.h"

namespace brindle::python {

namespace py = pybind11;

template <class T, class... Types>
concept OneOf = (std::same_as<std::remove_const_t<T>, Types> || ...);

/// The number of members of types that are more than their bytes. Structured bindings name all of
/// them: with a new one, `members` does not compile.
template <class T>
constexpr int member_count() {
  if constexpr (requires { T::kMembers; }) return T::kMembers;
  if (OneOf<T, Adjacency, Creases, DataArrays, FieldSupport, WindingSum, TextureWaves>) return 2;
  if (OneOf<T, Mesh, WaveSet>) return 3;
  if (OneOf<T, Surface, DataArray>) return 5;
  if (OneOf<T, FieldMetrics, PhaseSolution, FollowedReport, SurfaceLoop>) return 6;
  if (OneOf<T, Polylines, StripesData>) return 7;
  if (OneOf<T, StripePattern, StripeCurves>) return 8;
  if (OneOf<T, FabricationMetrics, TextureData>) return 12;
  return OneOf<T, SurfaceData> ? 13 : 0;
}

template <class T>
auto members(T& all) {
  constexpr int kCount = member_count<T>();
  if constexpr (std::same_as<T, PreparationMetrics>) {
    return std::tuple_cat(
        members<FieldMetrics>(all),
        std::tie(all.vertices_joined, all.load_milliseconds, all.topology_milliseconds));
  } else if constexpr (kCount == 2) {
    auto& [a, b] = all;
    return std::tie(a, b);
  } else if constexpr (kCount == 3) {
    auto& [a, b, c] = all;
    return std::tie(a, b, c);
  } else if constexpr (kCount == 5) {
    auto& [a, b, c, d, e] = all;
    return std::tie(a, b, c, d, e);
  } else if constexpr (kCount == 6) {
    auto& [a, b, c, d, e, f] = all;
    return std::tie(a, b, c, d, e, f);
  } else if constexpr (kCount == 7) {
    auto& [a, b, c, d, e, f, g] = all;
    return std::tie(a, b, c, d, e, f, g);
  } else if constexpr (kCount == 8) {
    auto& [a, b, c, d, e, f, g, h] = all;
    return std::tie(a, b, c, d, e, f, g, h);
  } else if constexpr (kCount == 12) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l] = all;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l);
  } else {
    static_assert(kCount == 13);
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = all;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m);
  }
}

/// Whether values of the type are their bytes. Eigen's vectors of fixed size are, although their
/// constructors keep the compiler from knowing it.
template <class T>
inline constexpr bool kIsPlain =
    std::is_trivially_copyable_v<T> && !std::is_pointer_v<T> && !std::same_as<T, std::string_view>;
template <class Number, int Rows>
inline constexpr bool kIsPlain<Eigen::Matrix<Number, Rows, 1>> = Rows > 0;
template <>
inline constexpr bool kIsPlain<CornerWaves> = true;
template <>
inline constexpr bool kIsPlain<Sample> = true;

template <class T>
inline constexpr bool kIsPointer = false;
template <class T>
inline constexpr bool kIsPointer<std::shared_ptr<T>> = true;
template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;
template <class T>
concept List = requires(T& list) {
  list.resize(1);
  list.data();
};

/// Writes values as bytes or, made of bytes, reads them into values. Objects that Python holds are
/// listed beside the bytes, so that those that share one still do afterwards.
class Archive {
 public:
  Archive() = default;
  Archive(std::string bytes, py::list objects)
      : bytes_(std::move(bytes)), objects_(std::move(objects)), reads_(true) {}

  const std::string& bytes() const { return bytes_; }
  const py::list& objects() const { return objects_; }
  void check_end() const {
    if (place_ != bytes_.size() || object_ != objects_.size()) fail();
  }

  template <class T>
  void operator()(T& value) {
    if constexpr (kIsPlain<T>) {
      raw(&value, sizeof value);
    } else if constexpr (kIsPointer<T>) {
      pointer(value);
    } else if constexpr (kIsOptional<T>) {
      optional(value);
    } else if constexpr (std::same_as<T, nlohmann::ordered_json>) {
      json(value);
    } else if constexpr (List<T>) {
      list(value);
    } else {
      std::apply([this](auto&... all) { ((*this)(all), ...); }, members(value));
    }
  }

 private:
  [[noreturn]] static void fail() {
    throw Error("the pickled bytes are damaged or not whole; pickle the object again");
  }

  void raw(void* data, std::size_t size) {
    if (!reads_) {
      bytes_.append(static_cast<const char*>(data), size);
    } else {
      if (size > bytes_.size() - place_) fail();
      if (size > 0) std::memcpy(data, bytes_.data() + place_, size);
      place_ += size;
    }
  }

  template <class T>
  void list(T& values) {
    std::uint64_t size = values.size();
    raw(&size, sizeof size);
    if (reads_) {
      if (size > bytes_.size() - place_) fail();
      values.resize(static_cast<std::size_t>(size));
    }
    if constexpr (kIsPlain<typename T::value_type>) {
      raw(values.data(), values.size() * sizeof(typename T::value_type));
    } else {
      for (auto& value : values) (*this)(value);
    }
  }

  template <class T>
  void optional(T& value) {
    bool has = value.has_value();
    raw(&has, sizeof has);
    if (reads_ && has) value.emplace();
    if (has) (*this)(*value);
  }

  void json(nlohmann::ordered_json& value) {
    std::vector<std::uint8_t> bytes;
    if (!reads_) bytes = nlohmann::ordered_json::to_cbor(value);
    list(bytes);
    if (reads_) value = nlohmann::ordered_json::from_cbor(bytes);
  }

  void pointer(std::shared_ptr<const Adjacency>& value) {
    bool has = value != nullptr;
    raw(&has, sizeof has);
    if (!has) return;
    Adjacency adjacency;
    if (!reads_) adjacency = *value;
    (*this)(adjacency);
    if (reads_) value = std::make_shared<const Adjacency>(std::move(adjacency));
  }

  template <class T>
  void pointer(std::shared_ptr<T>& value) {
    if (!reads_) {
      objects_.append(py::cast(value));
    } else {
      if (object_ == objects_.size()) fail();
      value = py::cast<std::shared_ptr<T>>(objects_[object_++]);
    }
  }

  std::string bytes_;
  py::list objects_;
  std::size_t place_ = 0, object_ = 0;
  bool reads_ = false;
};

/// Lets objects, which never change, be pickled, and copied as themselves. `Data` has `members`.
template <class Data>
void bind_pickle(py::class_<Data, std::shared_ptr<Data>>& type) {
  const auto itself = [](py::object self) { return self; };
  type.def("__copy__", itself)
      .def("__deepcopy__", [](py::object self, const py::object&) { return self; })
      .def(py::pickle(
          [](Data& data) {
            Archive archive;
            archive(data);
            return py::make_tuple(version(), py::bytes(archive.bytes()), archive.objects());
          },
          [](const py::tuple& state) {
            if (py::cast<std::string>(state[0]) != version()) {
              throw Error("the object was pickled by brindle " + py::cast<std::string>(state[0]) +
                          ", and this is " + version() + "; make it again with this one");
            }
            Archive archive(py::cast<std::string>(state[1]), py::cast<py::list>(state[2]));
            auto data = std::make_shared<Data>();
            archive(*data);
            archive.check_end();
            return data;
          }));
}

}  // namespace brindle::python
