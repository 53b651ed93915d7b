#include "brindle/saved.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "brindle/base/archive.h"
#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/pipeline/frames/animator_archive.h"
#include "brindle/pipeline/measured_pattern.h"
#include "brindle/version.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

// ---- The file: magic, header, payload -----------------------------------------------------------

constexpr char kMagic[8] = {'b', 'r', 'i', 'n', 'd', 'l', 'e', '\n'};
constexpr std::uint32_t kFormat = 1;  ///< raised when the payload changes

enum class Content : std::uint32_t { pattern, stripes, texture, crosses };

const char* name_of(std::uint32_t content) {
  constexpr const char* kNames[] = {"a pattern", "a StripeAnimator", "a TextureAnimator",
                                    "a CrossAnimator"};
  return content < std::size(kNames) ? kNames[content] : "something unknown";
}

struct Header {
  char magic[8];
  std::uint32_t format, content;
  std::uint64_t size, checksum;  ///< of the payload
};
static_assert(sizeof(Header) == 32);

/// FNV-1a over words of eight bytes, then bytes.
std::uint64_t checksum_of(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * 0x100000001b3u;
    hash ^= hash >> 32;  // so that the high bits of words count everywhere
  };
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + at, 8);
    add(word);
  }
  for (; at < bytes.size(); ++at) add(static_cast<unsigned char>(bytes[at]));
  return hash;
}

/// The payload of a file's bytes. Throws Error without the file's name.
std::string_view payload_of(std::string_view bytes, Content content) {
  Header header{};
  std::memcpy(&header, bytes.data(), std::min(bytes.size(), sizeof header));
  if (std::memcmp(header.magic, kMagic, sizeof kMagic) != 0) {
    throw Error("not a file that brindle saved; use read_mesh for meshes");
  }
  if (bytes.size() < sizeof header) throw Error("the file is truncated; save it again");
  if (header.format > kFormat) {
    throw Error("the file was saved by a newer brindle (format " + std::to_string(header.format) +
                "); brindle " + version() + " reads format " + std::to_string(kFormat));
  }
  if (header.content != static_cast<std::uint32_t>(content)) {
    throw Error(std::string("the file holds ") + name_of(header.content) + ", not " +
                name_of(static_cast<std::uint32_t>(content)));
  }
  const std::string_view payload = bytes.substr(sizeof header);
  if (payload.size() < header.size) throw Error("the file is truncated; save it again");
  if (header.format != kFormat || payload.size() != header.size ||
      checksum_of(payload) != header.checksum) {
    Archive::fail();
  }
  return payload;
}

// ---- Surfaces and patterns ----------------------------------------------------------------------

bool has_edge(const Adjacency& adjacency, Index from, Index to) {
  const std::span<const Index> row = adjacency.of(from);
  return std::binary_search(row.begin(), row.end(), to);
}

/// Throws Error unless rows are those of an Adjacency of this many nodes.
void check_adjacency(const Adjacency& adjacency, std::size_t nodes) {
  const std::vector<Index>& offsets = adjacency.offsets;
  if (offsets.size() != nodes + 1 || offsets[0] != 0 ||
      offsets.back() != adjacency.neighbors.size() ||
      !std::is_sorted(offsets.begin(), offsets.end())) {
    Archive::fail();
  }
  for (Index i = 0; i < nodes; ++i) {
    const std::span<const Index> row = adjacency.of(i);
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (row[k] >= nodes || row[k] == i || (k > 0 && row[k] <= row[k - 1])) Archive::fail();
    }
  }
  for (Index i = 0; i < nodes; ++i) {
    for (const Index j : adjacency.of(i)) {
      if (!has_edge(adjacency, j, i)) Archive::fail();
    }
  }
}

void check_creases(const Creases& creases, std::size_t vertices) {
  const auto is_vertex = [vertices](Index i) { return i < vertices; };
  if (creases.copied.size() > vertices) Archive::fail();
  const std::size_t own = vertices - creases.copied.size();
  for (const Index original : creases.copied) {
    if (original >= own) Archive::fail();
  }
  for (const auto& [first, second] : creases.edges) {
    if (!ranges::all_of(first, is_vertex) || !ranges::all_of(second, is_vertex)) Archive::fail();
  }
}

void check_loaded_surface(const Surface& surface) {
  const Mesh& mesh = surface.mesh;
  check_mesh(mesh);
  check_positions(surface.normals);
  if (!mesh.origin.allFinite()) Archive::fail();
  check_adjacency(*surface.neighborhood, mesh.vertex_count());
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Index a = triangle[c], b = triangle[(c + 1) % 3];
      if (a != b && !has_edge(*surface.neighborhood, a, b)) Archive::fail();
    }
  }
  check_creases(surface.creases, mesh.vertex_count());
}

void archive_creases(Archive& archive, Creases& creases) {
  std::vector<std::array<Index, 4>> edges;
  for (const auto& [first, second] : creases.edges) {
    edges.push_back({first[0], first[1], second[0], second[1]});
  }
  archive(creases.copied, edges);
  creases.edges.clear();
  for (const auto& e : edges) creases.edges.push_back({{e[0], e[1]}, {e[2], e[3]}});
}

void archive_surface(Archive& archive, Surface& surface) {
  Mesh& mesh = surface.mesh;
  Adjacency neighborhood;
  if (!archive.reads()) neighborhood = *surface.neighborhood;
  archive(mesh.positions, mesh.triangles, mesh.origin, neighborhood.offsets,
          neighborhood.neighbors);
  archive.list_of(mesh.vertex_count(), surface.normals);
  archive_creases(archive, surface.creases);
  archive.list_of_or_none(mesh.triangle_count(), surface.turned);
  if (!archive.reads()) return;
  surface.neighborhood = std::make_shared<const Adjacency>(std::move(neighborhood));
  check_loaded_surface(surface);
}

void archive_change(Archive& archive, std::optional<FrequencyChange>& change) {
  bool has = change.has_value();
  archive(has);
  if (!has) return;
  if (archive.reads()) change.emplace();
  archive_change(archive, *change);
}

void archive_count(Archive& archive, std::size_t& count) {
  std::uint64_t number = count;
  archive(number);
  count = static_cast<std::size_t>(number);
}

void archive_quality(Archive& archive, PatternQuality& q) {
  archive_count(archive, q.branches);
  archive_count(archive, q.field_singularities);
  archive_count(archive, q.vertices_without_wave);
  archive(q.branch_area_share, q.angle_error_mean_deg, q.angle_error_share_over_5deg,
          q.coarse_share_over_5deg, q.spacing_error_mean, q.spacing_error_wanted_mean);
  std::optional<std::uint64_t> avoided;
  if (q.branches_in_avoided_area) avoided = *q.branches_in_avoided_area;
  archive(avoided);
  if (avoided) q.branches_in_avoided_area = static_cast<std::size_t>(*avoided);
}

/// Corner phases follow from the rest.
void archive_pattern(Archive& archive, const Surface& surface, StripePattern& pattern) {
  const std::size_t vertices = surface.mesh.vertex_count();
  WaveSet& waves = pattern.waves;
  archive_waves(archive, vertices, waves);
  archive.list_of_or_none(vertices, pattern.frequencies_wanted);
  archive_change(archive, pattern.frequency_change);
  archive.choice(pattern.phase_shift, PhaseShiftKind::trapezoid);
  PhaseSolution& solution = pattern.solution;
  archive.list_of(vertices, solution.z);
  archive(solution.energy, solution.iterations, solution.energy_per_iteration,
          solution.topology_milliseconds, solution.solve_milliseconds);
  archive_quality(archive, pattern.quality);
  StripeMilliseconds& spent = pattern.milliseconds;
  archive(spent.load, spent.topology, spent.frequency, spent.couple, spent.solve, spent.pattern,
          spent.cancel);
  if (!pattern.frequencies_wanted.empty()) {
    check_waves(waves.positions, waves.directions, pattern.frequencies_wanted);
  }
  check_last_phases(solution.z, vertices);
  if (archive.reads()) set_corners(surface.mesh.triangles, pattern);
}

// ---- Saving and loading -------------------------------------------------------------------------

/// `put` adds what follows the surface.
template <class Put>
std::string file_of(const Surface& surface, Content content, const Put& put) {
  Archive archive;
  archive_surface(archive, const_cast<Surface&>(surface));  // writing changes nothing
  put(archive);
  const std::string& payload = archive.bytes();
  Header header{
      {}, kFormat, static_cast<std::uint32_t>(content), payload.size(), checksum_of(payload)};
  std::copy(std::begin(kMagic), std::end(kMagic), header.magic);
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  return bytes += payload;
}

template <class Animator>
std::string file_of_animator(const Surface& surface, Content content, const Animator& animator) {
  return file_of(surface, content, [&](Archive& archive) {
    AnimatorArchive::write(archive, surface, const_cast<Animator&>(animator));
  });
}

template <class Result>
void save_file(const std::filesystem::path& path, const Surface& surface, const Result& result) {
  const std::string bytes = saved_bytes(surface, result);
  write_file(path, [&](OutputStream& out) { out << bytes; });
}

/// `take(archive, surface)` returns what follows the surface.
template <class Result, class Take>
Saved<Result> result_of(std::string_view bytes, Content content, const Take& take) {
  Archive archive(payload_of(bytes, content));
  Surface surface;
  archive_surface(archive, surface);
  Result result = take(archive, surface);
  archive.check_end();
  return {std::move(surface), std::move(result)};
}

template <class Result>
Saved<Result> load_file(const std::filesystem::path& path,
                        Saved<Result> (*load)(std::string_view bytes)) {
  const std::string bytes = whole_input(path, "a file that brindle saved");
  try {
    return load(bytes);
  } catch (const Error& error) {
    throw Error(shown(path.string()) + ": " + error.what());
  }
}

}  // namespace

std::string saved_bytes(const Surface& surface, const StripePattern& pattern) {
  if (pattern.solution.z.size() != surface.mesh.vertex_count()) {
    throw Error("the pattern is of another surface; save it with its own");
  }
  return file_of(surface, Content::pattern, [&](Archive& archive) {
    archive_pattern(archive, surface, const_cast<StripePattern&>(pattern));
  });
}
std::string saved_bytes(const Surface& surface, const StripeAnimator& animator) {
  return file_of_animator(surface, Content::stripes, animator);
}
std::string saved_bytes(const Surface& surface, const TextureAnimator& animator) {
  return file_of_animator(surface, Content::texture, animator);
}
std::string saved_bytes(const Surface& surface, const CrossAnimator& animator) {
  return file_of_animator(surface, Content::crosses, animator);
}

void save(const std::filesystem::path& path, const Surface& surface, const StripePattern& pattern) {
  save_file(path, surface, pattern);
}
void save(const std::filesystem::path& path, const Surface& surface,
          const StripeAnimator& animator) {
  save_file(path, surface, animator);
}
void save(const std::filesystem::path& path, const Surface& surface,
          const TextureAnimator& animator) {
  save_file(path, surface, animator);
}
void save(const std::filesystem::path& path, const Surface& surface,
          const CrossAnimator& animator) {
  save_file(path, surface, animator);
}

Saved<StripePattern> pattern_of_bytes(std::string_view bytes) {
  return result_of<StripePattern>(bytes, Content::pattern, [](Archive& archive, const Surface& s) {
    StripePattern pattern;
    archive_pattern(archive, s, pattern);
    return pattern;
  });
}
Saved<StripeAnimator> stripe_animator_of_bytes(std::string_view bytes) {
  return result_of<StripeAnimator>(bytes, Content::stripes, AnimatorArchive::read_stripes);
}
Saved<TextureAnimator> texture_animator_of_bytes(std::string_view bytes) {
  return result_of<TextureAnimator>(bytes, Content::texture, AnimatorArchive::read_texture);
}
Saved<CrossAnimator> cross_animator_of_bytes(std::string_view bytes) {
  return result_of<CrossAnimator>(bytes, Content::crosses, AnimatorArchive::read_crosses);
}

Saved<StripePattern> load_pattern(const std::filesystem::path& path) {
  return load_file(path, pattern_of_bytes);
}
Saved<StripeAnimator> load_stripe_animator(const std::filesystem::path& path) {
  return load_file(path, stripe_animator_of_bytes);
}
Saved<TextureAnimator> load_texture_animator(const std::filesystem::path& path) {
  return load_file(path, texture_animator_of_bytes);
}
Saved<CrossAnimator> load_cross_animator(const std::filesystem::path& path) {
  return load_file(path, cross_animator_of_bytes);
}

}  // namespace brindle
