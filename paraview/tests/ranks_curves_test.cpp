// Curves and samples of partitions.
#include <array>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

#include <brindle/distributed_pattern.h>
#include <brindle/samples.h>

#include "rank_patterns.h"
#include "vtkBrindleCurves.h"
#include "vtkBrindleSamples.h"

namespace brindle::paraview {
namespace {

using Place = std::array<float, 3>;

Place place_of(vtkPolyData& data, vtkIdType point) {
  const double* p = data.GetPoint(point);
  return {float(p[0]), float(p[1]), float(p[2])};
}

Place place_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// A position named by a rank.
struct Named {
  Place place;
  int rank;
};

/// All positions, with the ranks that name them.
std::map<Place, std::vector<int>> all_named(const std::vector<Named>& own) {
  const Ranks all = ranks();
  std::map<Place, std::vector<int>> named;
  for (const auto& list :
       all.swap_lists(std::vector<std::vector<Named>>(static_cast<std::size_t>(all.size()), own))) {
    for (const Named& one : list) named[one.place].push_back(one.rank);
  }
  return named;
}

/// A single process numbers vertices by its points, ranks by global numbers; rounding depends on
/// the order.
Pieces pieces_numbered_alike(const Cut& cut) {
  Pieces pieces(kShape, cut);
  if (rank_count() > 1) return pieces;
  pieces.whole = pieces.own;
  std::iota(pieces.ids.begin(), pieces.ids.end(), 0u);
  return pieces;
}

/// A partition with arrays of its points' positions and its cells' ranks.
vtkSmartPointer<vtkPolyData> marked(const Pieces& pieces, bool ghosts) {
  auto data = pieces.polygons(true);
  data->GetPointData()->AddArray(vectors_by("place", data->GetNumberOfPoints(), [&](vtkIdType i) {
    return pieces.own.positions[static_cast<std::size_t>(i)];
  }));
  vtkNew<vtkDoubleArray> owner;
  owner->SetName("owner");
  for (vtkIdType t = 0; t < data->GetNumberOfCells(); ++t) owner->InsertNextValue(rank());
  data->GetCellData()->AddArray(owner);
  if (ghosts) data = with_ghosts(data.Get());
  add_swirl(*data, 0);
  return data;
}

void run(vtkBrindleFilter& filter, vtkPolyData* data) {
  filter.SetInputData(data);
  filter.SetField(kArray);
  choose(filter, 0, "v");
  Errors errors(filter);
  filter.Update();
  EXPECT_TRUE(errors.messages.empty()) << errors.messages[0];
}

/// Arrays at points are those of the input, in this rank's own triangles.
void expect_arrays_of_places(vtkPolyData& output) {
  if (output.GetNumberOfPoints() == 0) return;
  const std::vector<float> places = numbers(output, "place");
  double worst = 0;
  for (vtkIdType i = 0; i < output.GetNumberOfPoints(); ++i) {
    const Vec3 told(&places[static_cast<std::size_t>(3 * i)]);
    const Vec3 there(place_of(output, i).data());
    worst = std::max(worst, double((told - there).norm()));
  }
  EXPECT_LT(worst, 1e-5);
  const std::vector<float> owners = numbers(output, "owner");
  EXPECT_EQ(std::ranges::count(owners, float(rank())), output.GetNumberOfPoints());
}

/// The whole surface in one process, with the ranks' phases.
class Alone {
 public:
  explicit Alone(const Mesh& mesh) : mesh_(mesh) {
    std::vector<std::uint64_t> numbers(mesh.vertex_count());
    std::iota(numbers.begin(), numbers.end(), 0u);
    surface_.emplace(SurfacePiece{mesh, std::move(numbers), {}}, MPI_COMM_SELF);
  }

  /// The whole pattern from the ranks' parts, bit for bit.
  StripePattern gathered(const Pieces& pieces, const StripePattern& own) const {
    const auto data = pieces.polygons();
    const auto rows = data->GetNumberOfPoints();
    data->GetPointData()->AddArray(vectors_by("direction", rows, [&](vtkIdType i) {
      return own.waves.directions[static_cast<std::size_t>(i)];
    }));
    data->GetPointData()->AddArray(vectors_by("rest", rows, [&](vtkIdType i) {
      const auto v = static_cast<std::size_t>(i);
      return Vec3(own.solution.z[v].real(), own.solution.z[v].imag(), own.waves.frequencies[v]);
    }));
    const Gathered directions(mesh_.vertex_count(), *data, "direction");
    const Gathered rest(mesh_.vertex_count(), *data, "rest");
    EXPECT_EQ(directions.different + rest.different, 0u);
    StripePattern whole;
    whole.waves.positions = mesh_.positions;
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      whole.waves.directions.emplace_back(directions.values[v].data());
      const auto& [real, imaginary, frequency] = rest.values[v];
      whole.solution.z.emplace_back(real, imaginary);
      whole.waves.frequencies.push_back(frequency);
    }
    return whole;
  }

  StripeCurves curves(const StripePattern& pattern, const CurveOptions& options = {}) const {
    return whole_curves(part(pattern), options).curves;
  }

  /// Ends of the whole's lines, with counts.
  std::map<Place, std::size_t> ends(const StripePattern& pattern) const {
    const StripeCurves curves = this->curves(pattern);
    std::map<Place, std::size_t> ends;
    for (std::size_t line = 0; line < curves.lines.count(); ++line) {
      if (curves.lines.closed[line] != 0) continue;
      const auto points = curves.lines.points_of(line);
      ++ends[place_of(points.front())];
      ++ends[place_of(points.back())];
    }
    return ends;
  }

  double length(const StripePattern& pattern) const {
    const StripeCurves curves = this->curves(pattern);
    double length = 0;
    for (std::size_t line = 0; line < curves.lines.count(); ++line) {
      length += length_of(curves.lines, line);
    }
    return length;
  }

  /// All samples without doubles, in the order of the ranks' triangles.
  std::vector<Sample> samples(const StripePattern& u, const StripePattern& v,
                              const std::vector<int>& rank_of_triangle) const {
    std::vector<Sample> all = wave_samples(part(u), part(v));
    std::ranges::stable_sort(all, {},
                             [&](const Sample& s) { return rank_of_triangle[s.triangle]; });
    drop_doubles(all);
    return all;
  }

 private:
  PiecePattern part(const StripePattern& pattern) const {
    return {*surface_, pattern.waves, pattern.solution.z, pattern.phase_shift};
  }

  const Mesh& mesh_;
  std::optional<DistributedSurface> surface_;
};

/// The number of this rank's lines with that direction to their right, seen from outside.
vtkIdType lines_left_of(vtkPolyData& output, const Eigen::Vector3d& direction) {
  vtkIdType count = 0;
  vtkNew<vtkIdList> points;
  for (vtkIdType line = 0; line < output.GetNumberOfLines(); ++line) {
    output.GetCellPoints(line, points);
    const vtkIdType first = points->GetId(0), last = points->GetId(points->GetNumberOfIds() - 1);
    const Eigen::Vector3d way =
        Eigen::Vector3d(output.GetPoint(last)) - Eigen::Vector3d(output.GetPoint(first));
    const Eigen::Vector3d normal(output.GetPointData()->GetNormals()->GetTuple3(first));
    count += normal.cross(way).dot(direction) < 0;
  }
  return count;
}

/// Ends of this rank's open lines, none of which has a single point.
std::vector<Named> ends_of(vtkPolyData& output) {
  std::vector<Named> ends;
  vtkDataArray* closed = output.GetCellData()->GetArray("closed");
  vtkNew<vtkIdList> points;
  for (vtkIdType line = 0; line < output.GetNumberOfLines(); ++line) {
    output.GetCellPoints(line, points);
    EXPECT_GE(points->GetNumberOfIds(), 2);
    if (closed->GetComponent(line, 0) != 0) continue;
    for (const vtkIdType end : {vtkIdType{0}, points->GetNumberOfIds() - 1}) {
      ends.push_back({place_of(output, points->GetId(end)), rank()});
    }
  }
  return ends;
}

// At borders, lines of two ranks end at the same bits; all other ends are those of the whole's
// lines.
TEST(RankCurves, EndTogetherAtBorders) {
  std::size_t met = 0;
  for (const Cut& cut : cuts()) {
    const Pieces pieces = pieces_numbered_alike(cut);
    const Alone alone(pieces.whole);
    Twin twin(pieces, pieces.ids);
    const std::map<Place, std::size_t> wanted = alone.ends(alone.gathered(pieces, twin.pattern(0)));
    for (const bool ghosts : {false, true}) {
      SCOPED_TRACE(std::string(cut.name) + (ghosts ? ", ghosts" : ""));
      vtkNew<vtkBrindleCurves> filter;
      run(*filter, marked(pieces, ghosts));
      const auto named = all_named(ends_of(*filter->GetOutput()));
      std::size_t alone_there = 0, odd = 0;
      for (const auto& [place, who] : named) {
        const auto end = wanted.find(place);
        if (end != wanted.end()) {
          odd += who.size() % 2 != end->second % 2;
          ++alone_there;
        } else {
          odd += who.size() != 2 || who[0] == who[1];
          ++met;
        }
      }
      EXPECT_EQ(odd, 0u);
      EXPECT_EQ(alone_there, wanted.size());
      EXPECT_GT(wanted.size(), 0u);
    }
  }
  EXPECT_EQ(met > 1000, rank_count() > 1) << met;
}

// Lines of one pattern: the total length of the whole's, with or without ghosts, with arrays.
TEST(RankCurves, AreThoseOfOnePattern) {
  for (const Cut& cut : cuts()) {
    const Pieces pieces = pieces_numbered_alike(cut);
    const Alone alone(pieces.whole);
    Twin twin(pieces, pieces.ids);
    const double wanted = alone.length(alone.gathered(pieces, twin.pattern(0)));
    for (const bool ghosts : {false, true}) {
      SCOPED_TRACE(std::string(cut.name) + (ghosts ? ", ghosts" : ""));
      vtkNew<vtkBrindleCurves> filter;
      run(*filter, marked(pieces, ghosts));
      double length = 0;
      vtkDataArray* lengths = filter->GetOutput()->GetCellData()->GetArray("length");
      for (vtkIdType i = 0; lengths != nullptr && i < lengths->GetNumberOfTuples(); ++i) {
        length += lengths->GetComponent(i, 0);
      }
      EXPECT_NEAR(sum(length) / wanted, 1, 1e-5);
      expect_arrays_of_places(*filter->GetOutput());
    }
  }
}

/// Sorted lengths of lines, negative for closed ones.
std::vector<double> sorted_lengths(const StripeCurves& curves) {
  std::vector<double> lengths;
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    lengths.push_back(length_of(curves.lines, line) * (curves.lines.closed[line] != 0 ? -1 : 1));
  }
  std::ranges::sort(lengths);
  return lengths;
}

std::vector<double> sorted_lengths(vtkPolyData& output) {
  std::vector<double> lengths;
  vtkDataArray& length = *output.GetCellData()->GetArray("length");
  vtkDataArray& closed = *output.GetCellData()->GetArray("closed");
  for (vtkIdType i = 0; i < output.GetNumberOfLines(); ++i) {
    lengths.push_back(length.GetComponent(i, 0) * (closed.GetComponent(i, 0) != 0 ? -1 : 1));
  }
  std::ranges::sort(lengths);
  return lengths;
}

/// The input's arrays at points of whole lines, with the ranks that they come from.
void expect_arrays_of_ranks(vtkPolyData& output, std::set<float>& ranks) {
  const std::vector<float> places = numbers(output, "place"), owners = numbers(output, "owner");
  ranks.insert(owners.begin(), owners.end());
  double worst = 0;
  for (vtkIdType i = 0; i < output.GetNumberOfPoints(); ++i) {
    const Vec3 told(&places[static_cast<std::size_t>(3 * i)]);
    worst = std::max(worst, double((told - Vec3(place_of(output, i).data())).norm()));
  }
  EXPECT_LT(worst, 1e-5);
}

struct Asked {
  CurveOptions options;
  double minimum_length;
};

// Lines that need the whole equal those of one process with the same phases, on one rank.
TEST(RankCurves, WholeOnesAreThoseOfOneProcess) {
  std::set<float> seen;
  for (const Cut& cut : cuts()) {
    const Pieces pieces = pieces_numbered_alike(cut);
    const Alone alone(pieces.whole);
    Twin twin(pieces, pieces.ids);
    const StripePattern pattern = alone.gathered(pieces, twin.pattern(0));
    const std::vector<double> apart = sorted_lengths(alone.curves(pattern));
    for (const auto& [options, minimum_length] : {Asked{{.join = true}, 0},
                                                  {{}, 0.5},
                                                  {{.join = true}, 0.5},
                                                  {{.fair = 0.25f}, 0},
                                                  {{.join = true, .fair = 0.25f}, 0.5}}) {
      SCOPED_TRACE(std::string(cut.name) + (options.join ? ", joined " : " ") +
                   std::to_string(minimum_length) + " fair " + std::to_string(options.fair));
      vtkNew<vtkBrindleCurves> filter;
      filter->SetJoin(options.join);
      filter->SetFair(static_cast<double>(options.fair));
      filter->SetMinimumLength(minimum_length);
      run(*filter, marked(pieces, options.join));
      vtkPolyData& output = *filter->GetOutput();
      if (rank() != 0) {
        EXPECT_EQ(output.GetNumberOfPoints(), 0);
        continue;
      }
      const StripeCurves expected = longer_than(alone.curves(pattern, options), minimum_length);
      const std::vector<double> lengths = sorted_lengths(output);
      const std::vector<double> wanted = sorted_lengths(expected);
      EXPECT_NE(wanted, apart);
      ASSERT_EQ(lengths.size(), wanted.size());
      for (std::size_t i = 0; i < lengths.size(); ++i) EXPECT_NEAR(lengths[i], wanted[i], 1e-4);
      expect_arrays_of_ranks(output, seen);
    }
  }
  EXPECT_EQ(seen.size(), rank() == 0 ? static_cast<std::size_t>(rank_count()) : 0u);
}

TEST(RankCurves, HaveWavesToTheirLeft) {
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const Pieces pieces("plane,resolution=30", cut);
    vtkNew<vtkBrindleCurves> filter;
    filter->SetInputData(pieces.polygons());
    filter->SetField(kDirection);
    filter->SetDirection(3, 1, 0);
    filter->Update();
    EXPECT_EQ(lines_left_of(*filter->GetOutput(), {3, 1, 0}), 0);
    EXPECT_GT(sum(double(filter->GetOutput()->GetNumberOfLines())), 20);
  }
}

// Lines end beside vertices without a wave, and do not degenerate where they only touch a border.
TEST(RankCurves, OfHolesHaveNoLinesOfOnePoint) {
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const Pieces pieces = pieces_numbered_alike(cut);
    const auto data = marked(pieces, false);
    vtkDataArray& vectors = *data->GetPointData()->GetArray("v");
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
      if (std::abs(data->GetPoint(i)[0]) < 0.2) vectors.SetTuple3(i, 0, 0, 0);
    }
    vtkNew<vtkBrindleCurves> filter;
    run(*filter, data);
    for (const auto& [place, who] : all_named(ends_of(*filter->GetOutput()))) {
      EXPECT_LE(who.size(), 2u);
    }
    EXPECT_GT(sum(double(filter->GetOutput()->GetNumberOfLines())), 0);
  }
}

// Samples of one pattern: each on one rank, with the bits of the whole's.
TEST(RankSamples, AreThoseOfTheWholeEachOnOneRank) {
  for (const Cut& cut : cuts()) {
    const Pieces pieces = pieces_numbered_alike(cut);
    const Alone alone(pieces.whole);
    Twin twin(pieces, pieces.ids), other(pieces, pieces.ids);
    const StripePattern u = alone.gathered(pieces, twin.pattern(0));
    const StripePattern v = alone.gathered(pieces, other.pattern(0, std::numbers::pi_v<float> / 2));
    std::map<Place, std::size_t> wanted;
    for (const Sample& sample : alone.samples(u, v, cut.ranks_of(pieces.whole))) {
      ++wanted[place_of(sample.position)];
    }
    ASSERT_GT(wanted.size(), 100u);
    for (const bool ghosts : {false, true}) {
      SCOPED_TRACE(std::string(cut.name) + (ghosts ? ", ghosts" : ""));
      vtkNew<vtkBrindleSamples> filter;
      run(*filter, marked(pieces, ghosts));
      vtkPolyData& output = *filter->GetOutput();
      std::vector<Named> own;
      for (vtkIdType i = 0; i < output.GetNumberOfPoints(); ++i) {
        own.push_back({place_of(output, i), rank()});
      }
      std::map<Place, std::size_t> found;
      for (const auto& [place, who] : all_named(own)) found[place] = who.size();
      EXPECT_EQ(found, wanted);
      expect_arrays_of_places(output);
    }
  }
}

}  // namespace
}  // namespace brindle::paraview
