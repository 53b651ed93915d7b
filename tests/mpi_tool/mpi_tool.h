/// Runs the tool as a user would, over several ranks.
#pragma once

#include <cstring>
#include <numeric>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "apps/tool.h"
#include "brindle/data_arrays.h"
#include "brindle/files.h"

namespace brindle::test {

using Words = std::vector<std::string>;

/// Rows of an array with the positions of their vertices, as bytes.
inline std::set<std::string> rows_at_places(const LoadedMesh& mesh, const DataArray& array,
                                            std::span<const Index> vertices) {
  std::set<std::string> rows;
  const std::size_t size = array.rows() > 0 ? array.bytes.size() / array.rows() : 0;
  for (const Index v : vertices) {
    std::string row(reinterpret_cast<const char*>(mesh.mesh.positions[v].data()), sizeof(Vec3));
    row.append(reinterpret_cast<const char*>(&array.bytes[v * size]), size);
    rows.insert(std::move(row));
  }
  return rows;
}

/// Empty folders; whatever hangs there is ended, long after a busy machine would be done.
struct MpiTool : ToolTest {
  static Words mpirun() {
    Words words = {"1000"};
    std::string word;
    for (const char c : std::string(BRINDLE_MPIRUN) + "|") {
      if (c != '|') {
        word += c;
      } else {
        words.push_back(std::exchange(word, ""));
      }
    }
    return words;
  }

  static std::string joined(const Words& words) {
    std::string text;
    for (const std::string& word : words) text += "'" + word + "' ";
    return text;
  }

  ToolResult on(int ranks, Words arguments) const {
    arguments.insert(arguments.begin(), "stripe");
    return command_on(ranks, arguments);
  }

  /// As `on`, with a command in front.
  ToolResult command_on(int ranks, const Words& arguments) const {
    Words words = mpirun();
    words.insert(words.end(), {"-n", std::to_string(ranks), BRINDLE_TOOL_ALONE});
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_tool(words, folder);
  }

  /// As `command_on`, with more ranks behind, which have words and a folder of their own.
  ToolResult with_others(int ranks, const Words& arguments, int others, const Words& of_others,
                         const std::string& other_folder = ".") const {
    Words words = mpirun();
    words.insert(words.end(), {"-n", std::to_string(ranks), BRINDLE_TOOL_ALONE});
    words.insert(words.end(), arguments.begin(), arguments.end());
    words.insert(words.end(),
                 {":", "-n", std::to_string(others), "-wdir", other_folder, BRINDLE_TOOL_ALONE});
    words.insert(words.end(), of_others.begin(), of_others.end());
    return run_tool(words, folder);
  }

  /// Two ranks; a shell does `before` on the second one.
  ToolResult with_trouble(const std::string& before, Words arguments,
                          const Words& of_second) const {
    Words words = mpirun();
    words.insert(words.end(), {"-n", "1", BRINDLE_TOOL_ALONE, "stripe"});
    words.insert(words.end(), arguments.begin(), arguments.end());
    words.insert(words.end(),
                 {":", "-n", "1", "sh", "-c",
                  before + " exec '" + BRINDLE_TOOL_ALONE + "' stripe " + joined(of_second)});
    return run_tool(words, folder);
  }

  /// Whether a line is neither a stage of a slow job, nor a note on the mesh, nor about help.
  static bool is_message(const std::string& line) {
    const auto ends = [&](const char* words) { return line.ends_with(words); };
    return (has(line, ": ") || has(line, "; ") || ends(":") || line == "cancelled") &&
           !ends(": joined") && !ends("without a wave") && !has(line, "--help");
  }

  /// One message besides notes on the mesh, this exit code, and no file.
  void expect_failure(const ToolResult& result, int exit_code, const std::string& message) const {
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    std::size_t messages = 0;
    for (std::size_t at = 0; (at = result.err.find("brindle: ", at)) != std::string::npos; ++at) {
      const std::size_t end = result.err.find('\n', at);
      messages += is_message(result.err.substr(at + 9, end - at - 9));
    }
    EXPECT_EQ(messages, 1u) << result.err;
    for (const std::string& name : listing()) {
      EXPECT_EQ(name.find("pvtp"), std::string::npos) << name;
      EXPECT_EQ(name.find("tmp"), std::string::npos) << name;
    }
  }

  LoadedMesh piece(const std::string& name) const { return read_mesh(folder / name); }
};

inline const DataArray& array_of(const std::vector<DataArray>& arrays, const std::string& name) {
  for (const DataArray& array : arrays) {
    if (array.name == name) return array;
  }
  throw std::runtime_error("no array " + name);
}

/// The first number of a row.
template <class Number>
Number value(const DataArray& array, std::size_t row) {
  const std::size_t size = sizeof(Number) * static_cast<std::size_t>(array.components);
  Number number;
  std::memcpy(&number, array.bytes.data() + row * size, sizeof(Number));
  return number;
}

/// Expects the rows of a whole file in its parts. Its first `own` vertices have their numbers as
/// `global_id`; those behind them are copies, which have the number of their vertex in parts.
inline void expect_rows_of_whole(const LoadedMesh& whole, std::size_t own,
                                 std::span<const LoadedMesh> parts, const Words& names) {
  std::vector<Index> copies(whole.mesh.vertex_count() - own);
  std::iota(copies.begin(), copies.end(), static_cast<Index>(own));
  for (const std::string& name : names) {
    const DataArray& expected = array_of(whole.arrays.points, name);
    std::set<std::string> found;
    for (const LoadedMesh& part : parts) {
      const DataArray& ids = array_of(part.arrays.points, "global_id");
      const DataArray& array = array_of(part.arrays.points, name);
      std::set<std::uint64_t> known;
      std::vector<Index> vertices, numbers, copied;
      for (Index v = 0; v < ids.rows(); ++v) {
        const auto id = value<std::uint64_t>(ids, v);
        if (!known.insert(id).second) {
          copied.push_back(v);
          continue;
        }
        vertices.push_back(v);
        numbers.push_back(static_cast<Index>(id));
        EXPECT_EQ(part.mesh.positions[v], whole.mesh.positions[id]);
      }
      EXPECT_EQ(rows_of(array, vertices), rows_of(expected, numbers)) << name;
      found.merge(rows_at_places(part, array, copied));
    }
    EXPECT_TRUE(found == rows_at_places(whole, expected, copies)) << name << " of copies";
  }
}

}  // namespace brindle::test
