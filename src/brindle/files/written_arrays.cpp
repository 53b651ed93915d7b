#include "brindle/files/written_arrays.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "brindle/base/array_numbers.h"
#include "brindle/base/file_names.h"
#include "brindle/base/input_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/binary_numbers.h"

namespace brindle {
namespace {

template <class To, class From>
bool holds_exactly(From number) {
  if constexpr (std::is_integral_v<To>) {
    if constexpr (std::is_integral_v<From>) return std::in_range<To>(number);
    return false;
  } else if constexpr (std::is_integral_v<From>) {
    const auto bits = static_cast<std::uint64_t>(number);
    const std::uint64_t size = std::cmp_less(number, 0) ? 0 - bits : bits;
    return size == 0 || size >> std::countr_zero(size) < std::uint64_t{1}
                                                             << std::numeric_limits<To>::digits;
  } else if constexpr (sizeof(To) < sizeof(From)) {
    if (!std::isfinite(number)) return true;
    return std::abs(number) <= From{std::numeric_limits<To>::max()} &&
           static_cast<From>(static_cast<To>(number)) == number;
  } else {
    return true;
  }
}

template <class To, class From>
bool convert_exactly(const DataArray& array, DataArray& result) {
  result.bytes.resize(array.bytes.size() / sizeof(From) * sizeof(To));
  std::byte* out = result.bytes.data();
  for (std::size_t at = 0; at < array.bytes.size(); at += sizeof(From), out += sizeof(To)) {
    From number;
    std::memcpy(&number, &array.bytes[at], sizeof number);
    if (!holds_exactly<To>(number)) return false;
    const auto converted = static_cast<To>(number);
    std::memcpy(out, &converted, sizeof converted);
  }
  return true;
}

bool all_finite(const DataArray& array) {
  bool finite = true;
  for_each_number(array.view(), [&](std::size_t, std::size_t, auto number) {
    finite = finite && std::isfinite(static_cast<double>(number));
  });
  return finite;
}

/// Levels from 0 to 1, rounded to bytes.
DataArray colors_as_bytes(const DataArray& color) {
  if (color.type == NumberType::uint8) return color;
  std::vector<std::uint8_t> levels;
  for_each_number(color.view(), [&](std::size_t, std::size_t, auto level) {
    levels.push_back(color_byte(static_cast<float>(level)));
  });
  return make_data_array(color.name, color.components, levels);
}

DataArray colors_as_floats(const DataArray& color) {
  const float full = color.type == NumberType::uint8 ? 255 : 1;
  std::vector<float> levels;
  for_each_number(color.view(), [&](std::size_t, std::size_t, auto level) {
    levels.push_back(static_cast<float>(level) / full);
  });
  return make_data_array(color.name, color.components, levels);
}

std::string xml_text(std::string_view name) {
  std::string text;
  while (!name.empty()) {
    const auto [bytes, code] = first_utf8_letter(name);
    const bool in_xml = bytes > 0 && code >= 0x20 && code != 0x7f && (code & 0xfffe) != 0xfffe;
    text += in_xml ? name.substr(0, bytes) : "_";
    name.remove_prefix(in_xml ? bytes : 1);
  }
  return text;
}

/// Appends underscores to the name until it is free, and takes it.
std::string free_name(std::string name, std::vector<std::string>& taken) {
  while (std::find(taken.begin(), taken.end(), name) != taken.end()) name += '_';
  taken.push_back(name);
  return name;
}

/// Converts arrays to a file format and collects a line for each that is left out.
class Fitting {
 public:
  Fitting(std::string kind, DataArrays arrays) : kind_(std::move(kind)) {
    for (std::vector<DataArray>* of : {&arrays.points, &arrays.cells}) {
      for (DataArray& array : *of) array.name = array.name.empty() ? "array" : array.name;
    }
    if (kind_ == ".csv") {
      result_.arrays = std::move(arrays);
    } else if (kind_ == ".vtp") {
      fit_vtp(arrays.points, result_.arrays.points);
      fit_vtp(arrays.cells, result_.arrays.cells);
    } else if (kind_ == ".ply") {
      fit_ply(arrays.points, {"x", "y", "z"}, result_.arrays.points);
      fit_ply(arrays.cells, {"vertex_indices"}, result_.arrays.cells);
    } else if (kind_ == ".obj") {
      fit_obj(arrays.points);
      leave_out(arrays.cells);
    } else if (kind_ == ".stl" || kind_ == ".3mf") {
      for (const DataArray& array : arrays.points) leave_out(array, "per vertex");
      leave_out(arrays.cells);
    } else {
      fit_gltf(arrays.points);
      leave_out(arrays.cells);
    }
  }

  FittedArrays take() { return std::move(result_); }

 private:
  void leave_out(const DataArray& array, const std::string& why) {
    result_.left_out.push_back("array " + printable_name(array) + " (" + why + ") is not kept in " +
                               kind_);
  }
  void leave_out(const std::vector<DataArray>& cells) {
    for (const DataArray& array : cells) leave_out(array, "per triangle");
  }
  static std::string printable_name(const DataArray& array) {
    return "'" + printable(array.name, 60) + "'";
  }
  static std::string components_of(const DataArray& array) {
    return std::to_string(array.components) +
           (array.components == 1 ? " component" : " components");
  }

  static void fit_vtp(std::vector<DataArray>& arrays, std::vector<DataArray>& fitted) {
    std::vector<std::string> taken;
    for (DataArray& array : arrays) {
      if (is_color(array)) array = colors_as_bytes(array);
      array.name = free_name(xml_text(array.name), taken);
      fitted.push_back(std::move(array));
    }
  }

  void fit_ply(std::vector<DataArray>& arrays, std::vector<std::string> taken,
               std::vector<DataArray>& fitted) {
    const auto reserve = [&](bool (*is)(const DataArray&), std::vector<std::string> names) {
      if (std::none_of(arrays.begin(), arrays.end(), is)) return;
      taken.insert(taken.end(), names.begin(), names.end());
    };
    reserve(is_normal, {"nx", "ny", "nz"});
    reserve(is_color, {"red", "green", "blue"});
    reserve(is_uv, {"texture_u", "texture_v", "s", "t"});
    for (DataArray& array : arrays) {
      std::optional<DataArray> typed = ply_numbers(array);
      if (!typed) {
        leave_out(array, "64-bit numbers");
      } else if (is_normal(*typed) || is_color(*typed) || is_uv(*typed)) {
        fitted.push_back(std::move(*typed));
      } else {
        typed->name = one_word(typed->name);
        fitted.push_back(with_free_columns(std::move(*typed), taken));
      }
    }
  }

  static std::optional<DataArray> ply_numbers(const DataArray& array) {
    if (is_color(array)) return colors_as_bytes(array);
    if (array.type != NumberType::int64 && array.type != NumberType::uint64) return array;
    for (const NumberType type : {NumberType::int32, NumberType::uint32, NumberType::float64}) {
      if (auto typed = exactly_as(array, type)) return typed;
    }
    return std::nullopt;
  }

  void fit_gltf(std::vector<DataArray>& arrays) {
    std::vector<std::string> taken;
    for (DataArray& array : arrays) {
      if (array.components > 4) {
        leave_out(array, components_of(array));
        continue;
      }
      const bool special = is_normal(array) || is_color(array) || is_uv(array);
      std::optional<DataArray> typed =
          is_color(array) ? colors_as_floats(array) : exactly_as(array, NumberType::float32);
      if (!typed) {
        leave_out(array, "numbers that are no 32-bit floats");
      } else if (!all_finite(*typed)) {
        leave_out(array, "numbers that are not finite");
      } else {
        if (!special) typed->name = free_name(gltf_name(typed->name), taken);
        result_.arrays.points.push_back(std::move(*typed));
      }
    }
  }

  static std::string gltf_name(std::string_view name) {
    std::string result = one_word(name);
    if (!result.starts_with('_')) result.insert(0, 1, '_');
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return result;
  }

  void fit_obj(std::vector<DataArray>& arrays) {
    for (DataArray& array : arrays) {
      if (is_normal(array) || is_uv(array)) {
        result_.arrays.points.push_back(std::move(array));
      } else {
        leave_out(array, components_of(array));
      }
    }
  }

  std::string kind_;
  FittedArrays result_;
};

}  // namespace

bool is_normal(const DataArray& array) {
  return array.name == "normal" && array.components == 3 && is_floating(array.type);
}

bool is_color(const DataArray& array) {
  return array.name == "color" && array.components == 3 &&
         (is_floating(array.type) || array.type == NumberType::uint8);
}

bool is_uv(const DataArray& array) {
  return array.name == "uv" && array.components == 2 && is_floating(array.type);
}

FittedArrays fitted_arrays(const std::filesystem::path& path, DataArrays arrays) {
  return Fitting(lower_extension(path), std::move(arrays)).take();
}

std::optional<DataArray> exactly_as(const DataArray& array, NumberType type) {
  if (array.type == type) return array;
  DataArray result{array.name, type, array.components, {}};
  bool exact = false;
  with_number_type(array.type, [&]<class From>(From) {
    with_number_type(type, [&]<class To>(To) { exact = convert_exactly<To, From>(array, result); });
  });
  return exact ? std::optional(std::move(result)) : std::nullopt;
}

std::string one_word(std::string_view name) {
  std::string word(name);
  std::replace_if(
      word.begin(), word.end(),
      [](unsigned char c) { return c >= 0x80 || !(std::isalnum(c) || c == '_'); }, '_');
  return word;
}

std::vector<std::string> column_names(const DataArray& array) {
  if (array.components == 1) return {array.name};
  if (array.components == 3) return {array.name + "_x", array.name + "_y", array.name + "_z"};
  std::vector<std::string> names;
  for (int c = 0; c < array.components; ++c) names.push_back(array.name + "_" + std::to_string(c));
  return names;
}

DataArray with_free_columns(DataArray array, std::vector<std::string>& taken) {
  const auto is_taken = [&](const std::string& name) {
    return std::find(taken.begin(), taken.end(), name) != taken.end();
  };
  std::vector<std::string> names = column_names(array);
  while (std::any_of(names.begin(), names.end(), is_taken)) {
    array.name += '_';
    names = column_names(array);
  }
  taken.insert(taken.end(), names.begin(), names.end());
  return array;
}

std::vector<DataArray> fitted_columns(const std::filesystem::path& path,
                                      std::span<const DataArray> arrays, std::size_t rows,
                                      std::vector<std::string> taken) {
  check_rows(path, arrays, rows, "point");
  FittedArrays fitted = fitted_arrays(path, {{arrays.begin(), arrays.end()}, {}});
  if (!fitted.left_out.empty()) refuse_array(path, fitted.left_out.front());
  for (DataArray& array : fitted.arrays.points) {
    if (is_normal(array)) array.name += '_';
    if (lower_extension(path) == ".vtp") {
      array.name = free_name(std::move(array.name), taken);
    } else {
      array = with_free_columns(std::move(array), taken);
    }
  }
  return std::move(fitted.arrays.points);
}

void check_rows(const std::filesystem::path& path, std::span<const DataArray> arrays,
                std::size_t rows, const char* of) {
  for (const DataArray& array : arrays) {
    const auto fail = [&](const std::string& what) {
      throw Error("cannot write '" + shown(path.string()) + "': array '" + array.name + "' " +
                  what);
    };
    if (array.components < 1) fail("has no components");
    const std::size_t row = size_of(array.type) * static_cast<std::size_t>(array.components);
    if (array.bytes.size() == rows * row) continue;
    fail("has " + std::to_string(array.rows()) + " rows, not " + std::to_string(rows) +
         ", one for every " + of);
  }
}

void refuse_array(const std::filesystem::path& path, const std::string& left_out) {
  throw Error("cannot write '" + shown(path.string()) + "': " + left_out +
              "; write .vtp or .ply, or leave it out");
}

}  // namespace brindle
