/// The pattern, or the field, that another one continues.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/carried_phases.h"
#include "brindle/data_arrays.h"
#include "input/preparation.h"
#include "input/wave_options.h"

namespace brindle::tool {

/// Vertex matching with the last pattern.
enum class Matching {
  number,   ///< by vertex number
  id,       ///< by an array of integer ids
  position  ///< by position: the last pattern's wave at the nearest point
};
std::string_view name_of(Matching matching);

struct MatchOptions {
  std::optional<Matching> by;  ///< empty: number if both have the same triangles, else position
  std::string array;           ///< name of the array of ids
};

/// --match.
CLI::Option* add_match_option(CLI::App& app, MatchOptions& options);

/// The data of a surface for vertex matching.
struct MatchSide {
  std::string name;  ///< file name, for messages
  const Mesh& mesh;
  std::span<const DataArray> arrays;  ///< of points
};

struct VertexMatch {
  Matching by = Matching::number;
  std::vector<Index> counterparts;  ///< by id: for `matched_phases`
};

/// Matches the vertices of `follower` to those of `last`. Throws Error with the files if they
/// cannot be matched by the options.
VertexMatch match_vertices(const MatchSide& last, const MatchSide& follower,
                           const MatchOptions& options);

/// The kept data of a pattern.
struct KeptPattern {
  std::string name;  ///< file name, for messages
  Mesh mesh;
  WaveSet waves;
  std::vector<Complex> z;
  std::vector<DataArray> arrays;   ///< of points
  std::vector<Vec3> normals = {};  ///< of a point cloud whose file has normals
  float turn_deg = 0;              ///< turn of the waves from their field

  LastPattern view() const { return {mesh, waves, z}; }
  MatchSide side() const { return {name, mesh, arrays}; }
};

/// Reads a mesh or points with the arrays `phase`, `direction` and `frequency` of a Brindle output.
/// Vertices without finite, non-zero values have no wave. Throws Error with the file if it cannot
/// be read or lacks an array.
KeptPattern read_pattern(const std::filesystem::path& path);

/// The input of the pattern that continues another.
struct Follower {
  std::string name;  ///< file name, for messages
  const Mesh& mesh;
  const WaveSet& waves;
  std::span<const DataArray> arrays;  ///< of points

  MatchSide side() const { return {name, mesh, arrays}; }
};

struct CarriedPattern {
  std::vector<Complex> z;  ///< the last phase per vertex, 0 if there is none
  Matching matched_by = Matching::number;
  std::size_t unmatched = 0;  ///< waves without a last phase
};

/// Throws Error with the files if vertices cannot be matched by the options.
CarriedPattern carry(const KeptPattern& last, const Follower& follower,
                     const MatchOptions& options);

/// Whether both have the same triangles and number of vertices.
bool same_connectivity(const Mesh& a, const Mesh& b);

/// The kept data of a field.
struct KeptField {
  std::string name;  ///< file name of its surface, for messages
  Mesh mesh;
  std::vector<Vec3> normals;
  DirectionField directions;      ///< before they are turned
  std::vector<DataArray> arrays;  ///< of points
  double period = 0;              ///< mean over its waves that are known on the mesh
};

/// The field of a pattern, before it was turned. Normals of points are those of the file, or fitted
/// to `neighbors`.
KeptField field_of(const KeptPattern& pattern, std::optional<int> neighbors);

/// A note on a pattern whose waves are turned from its field by another angle than these; else
/// empty. The field is continued; the phases of other waves cannot be.
std::string turn_note(const KeptPattern& pattern, const WaveOptions& waves);

/// The field transferred to the `prepared` surface of the file `name`. Throws Error as
/// `match_vertices` does.
DirectionField carry_field(const KeptField& last, const std::string& name,
                           const Preparation& prepared, const WaveOptions& waves,
                           const MatchOptions& options);

}  // namespace brindle::tool
