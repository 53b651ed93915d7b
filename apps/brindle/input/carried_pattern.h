/// Patterns that the next ones follow: vertex by vertex, or over another mesh.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/carried_phases.h"
#include "brindle/data_arrays.h"

namespace brindle::tool {

/// How vertices find those of the last pattern.
enum class Matching {
  number,   ///< by their number
  id,       ///< by an array of whole numbers that names them
  position  ///< where they are: the last pattern's wave at the nearest place
};
std::string_view name_of(Matching matching);

struct MatchOptions {
  std::optional<Matching> by;  ///< none: number where both have the same triangles, else position
  std::string array;           ///< of the ids
};

/// --match.
CLI::Option* add_match_option(CLI::App& app, MatchOptions& options);

/// What of a surface its vertices are matched by.
struct MatchSide {
  std::string name;  ///< of its file, for messages
  const Mesh& mesh;
  std::span<const DataArray> arrays;  ///< of points
};

struct VertexMatch {
  Matching by = Matching::number;
  std::vector<Index> counterparts;  ///< by id: as `matched_phases` wants them
};

/// How the vertices of `follower` find those of `last`. Throws Error, naming the files, if they
/// cannot be matched as the options want.
VertexMatch match_vertices(const MatchSide& last, const MatchSide& follower,
                           const MatchOptions& options);

/// What is kept of a pattern.
struct KeptPattern {
  std::string name;  ///< of its file, for messages
  Mesh mesh;
  WaveSet waves;
  std::vector<Complex> z;
  std::vector<DataArray> arrays;   ///< of points
  std::vector<Vec3> normals = {};  ///< of points without triangles whose file has them
  float turn_deg = 0;  ///< by which the waves are turned from the field that they were made of

  LastPattern view() const { return {mesh, waves, z}; }
  MatchSide side() const { return {name, mesh, arrays}; }
};

/// Reads a mesh or points with arrays `phase`, `direction` and `frequency`, as brindle writes them.
/// Where one of them is not finite, or zero, there is no wave. Throws Error, naming the file, if it
/// cannot be read or lacks one of them.
KeptPattern read_pattern(const std::filesystem::path& path);

/// What follows a pattern.
struct Follower {
  std::string name;  ///< of its file, for messages
  const Mesh& mesh;
  const WaveSet& waves;
  std::span<const DataArray> arrays;  ///< of points

  MatchSide side() const { return {name, mesh, arrays}; }
};

struct CarriedPattern {
  std::vector<Complex> z;  ///< a last phase per vertex, 0 where there is none
  Matching matched_by = Matching::number;
  std::size_t unmatched = 0;  ///< waves without a last phase
};

/// Throws Error, naming the files, if vertices cannot be matched as the options want.
CarriedPattern carry(const KeptPattern& last, const Follower& follower,
                     const MatchOptions& options);

/// Whether both have as many vertices and the same triangles.
bool same_connectivity(const Mesh& a, const Mesh& b);

}  // namespace brindle::tool
