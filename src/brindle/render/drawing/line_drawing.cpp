#include "brindle/line_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/output_file.h"
#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/feature_lines.h"
#include "brindle/render/drawing/pen_order.h"

namespace brindle {
namespace {

constexpr int kPerPixel = 2;              // depths along a side of a pixel
constexpr float kStep = 0.5f;             // pixels between visibility tests
constexpr float kShortest = 1.5f;         // pixels: shorter strokes are noise along silhouettes
constexpr float kLongestGap = 1.5f;       // pixels: shorter gaps are noise, too
constexpr float kSmallestCorner = 0.05f;  // pixels: smaller corners are left out
constexpr std::size_t kWorkPerReport = 1 << 20;
constexpr float kSteepest = 5e-3f;  // relative difference of distances of neighbouring cells

float edge_function(const Eigen::Vector2f& a, const Eigen::Vector2f& b, float x, float y) {
  return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
}

float length_of(const Stroke& stroke) {
  float length = 0;
  for (std::size_t i = 1; i < stroke.size(); ++i) length += (stroke[i] - stroke[i - 1]).norm();
  return length;
}

/// As `simplified`, for lines in the picture.
Stroke simplified_stroke(const Stroke& stroke, float tolerance) {
  Polylines line;
  for (const auto& p : stroke) line.add({p.x(), p.y(), 0.0f}, Vec3::UnitZ());
  line.end_line(false);
  Stroke result;
  for (const Vec3& p : simplified(line, tolerance).points) result.emplace_back(p.x(), p.y());
  return result;
}

/// Two decimals, a hundredth of a pixel.
void put(TextOutput& text, float value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.2f", static_cast<double>(value));
  text << static_cast<const char*>(digits);
}

std::string hexadecimal(const Color& color) {
  const auto byte = [](float level) { return static_cast<int>(std::lround(255 * level)); };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color.red), byte(color.green),
                byte(color.blue));
  return text;
}

/// Hundredths of a pixel, the precision of files.
using Hundredths = Eigen::Vector2i;

Hundredths hundredths_of(const Eigen::Vector2f& point) {
  return {static_cast<int>(std::lround(100 * point.x())),
          static_cast<int>(std::lround(100 * point.y()))};
}

/// The shortest notation: "-.5" for -50.
std::string short_number(int hundredths) {
  const int size = std::abs(hundredths);
  std::string digits = hundredths < 0 ? "-" : "";
  if (size >= 100 || size == 0) digits += std::to_string(size / 100);
  if (size % 100 == 0) return digits;
  digits += '.';
  digits += static_cast<char>('0' + size % 100 / 10);
  if (size % 10 != 0) digits += static_cast<char>('0' + size % 10);
  return digits;
}

/// Numbers of a path after one letter that applies to all of them.
class PathText {
 public:
  explicit PathText(TextOutput& text) : text_(text) {}

  void put(char letter, std::initializer_list<Hundredths> points) {
    bool begins = letter != letter_;
    if (begins) text_ << std::string(1, letter);
    letter_ = letter;
    for (const Hundredths& point : points) {
      for (const int number : {point.x(), point.y()}) {
        if (!begins && number >= 0) text_ << ' ';
        text_ << short_number(number);
        begins = false;
      }
    }
  }
  void close() {
    text_ << "z\n";
    letter_ = 0;
  }

 private:
  TextOutput& text_;
  char letter_ = 0;
};

/// Whether a Bézier segment from 0 to `end` is straight to half a hundredth of a pixel.
bool is_line(const Hundredths& first, const Hundredths& last, const Hundredths& end) {
  const Eigen::Vector2d way = end.cast<double>();
  for (const Hundredths& control : {first, last}) {
    const Eigen::Vector2d off = control.cast<double>();
    const double across = off.x() * way.y() - off.y() * way.x();
    if (std::abs(across) > way.norm() || off.dot(way) < 0 || off.dot(way) > way.squaredNorm()) {
      return false;
    }
  }
  return true;
}

/// A closed path; each segment is relative to its start, so that rounding does not accumulate.
void put_curves(TextOutput& text, const Stroke& path) {
  PathText out(text);
  Hundredths from = hundredths_of(path[0]);
  out.put('M', {from});
  for (std::size_t i = 1; i + 2 < path.size(); i += 3) {
    const Hundredths first = hundredths_of(path[i]) - from;
    const Hundredths last = hundredths_of(path[i + 1]) - from;
    const Hundredths end = hundredths_of(path[i + 2]) - from;
    from += end;
    if (is_line(first, last, end)) {
      if (!end.isZero()) out.put('l', {end});
    } else {
      out.put('c', {first, last, end});
    }
  }
  out.close();
}

void put_points(TextOutput& text, const Stroke& stroke) {
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    text << (i == 0 ? "M" : i == 1 ? "L" : " ");
    put(text, stroke[i].x());
    text << ' ';
    put(text, stroke[i].y());
  }
}

void put_pen(TextOutput& text, const Pen& pen) {
  text << "<g id=\"" << pen.name << "\" fill=\"" << (pen.filled ? hexadecimal(pen.color) : "none");
  if (pen.filled) {
    text << "\" fill-rule=\"evenodd\">\n<path d=\"";
    for (const Stroke& stroke : pen.strokes) {
      if (pen.curved) {
        put_curves(text, stroke);
        continue;
      }
      put_points(text, stroke);
      text << "Z\n";
    }
    text << "\"/>\n</g>\n";
    return;
  }
  text << "\" stroke=\"" << hexadecimal(pen.color) << "\" stroke-width=\"";
  put(text, pen.width);
  text << "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (const Stroke& stroke : pen.strokes) {
    text << "<path d=\"";
    put_points(text, stroke);
    text << "\"/>\n";
  }
  text << "</g>\n";
}

std::string page_of(int width, int height) {
  return formatted("width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\"", width, height, width,
                   height);
}

std::string page_of(const PaperSize& paper) {
  constexpr double kPixels = kDrawingDpi / kMillimetresPerInch;
  return formatted("width=\"%.9gmm\" height=\"%.9gmm\" viewBox=\"0 0 %.9g %.9g\"", paper.width,
                   paper.height, kPixels * paper.width, kPixels * paper.height);
}

Camera drawing_camera(const Mesh& mesh, const CameraView& view, int width, int height) {
  check_drawing_size(width, height);
  return framed_camera(points_of_triangles(mesh), view, width, height);
}

}  // namespace

Visibility::Visibility(const Mesh& mesh, const CameraView& view, int width, int height,
                       const Progress& progress)
    : Visibility(mesh, drawing_camera(mesh, view, width, height), width, height, progress) {}

Visibility::Visibility(const Mesh& mesh, const Camera& camera, int width, int height,
                       const Progress& progress)
    : camera_(camera),
      width_(width),
      height_(height),
      columns_(kPerPixel * width),
      rows_(kPerPixel * height) {
  check_drawing_size(width, height);
  JobStages stages(progress, {{"hidden lines", 1}});
  const Progress hiding = stages.begin("hidden lines");
  ticking_resize(nearness_, static_cast<std::size_t>(columns_) * rows_, hiding.part(0, 0.1));
  draw(mesh, hiding.part(0.1, 1));
  stages.finish();
}

Visibility::Seen Visibility::project(const Vec3& point) const {
  const Vec3 relative = point - camera_.origin;
  const Eigen::Vector4f seen = camera_.view_from_world * relative.homogeneous();
  const Eigen::Vector4f clip = camera_.clip_from_view * seen;
  const float x = clip.x() / clip.w(), y = clip.y() / clip.w();
  return {
      {0.5f * (1 + x) * static_cast<float>(width_), 0.5f * (1 - y) * static_cast<float>(height_)},
      camera_.orthographic() ? -seen.z() : clip.w(),
      camera_.slice ? camera_.slice->signedDistance(point) : -1.0f};
}

/// The cells in which a triangle may be visible.
struct Visibility::Cells {
  int first_row, last_row, first_column, last_column;

  int columns() const { return std::max(0, last_column - first_column + 1); }
  /// Cost of the triangle, in cells.
  std::size_t work() const {
    const int rows = std::max(0, last_row - first_row + 1);
    return 16 + static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns());
  }
};

void Visibility::draw(const Mesh& mesh, const Progress& progress) {
  std::vector<Seen> seen;
  seen.reserve(mesh.vertex_count());
  reported_for(mesh.vertex_count(), progress.part(0, 0.1),
               [&](std::size_t v) { seen.push_back(project(mesh.positions[v])); });
  const auto corners_of = [&](std::size_t number) {
    const Triangle& t = mesh.triangles[number];
    return std::array{seen[t[0]], seen[t[1]], seen[t[2]]};
  };
  std::size_t work = 0;
  reported_for(mesh.triangle_count(), progress.part(0.1, 0.2),
               [&](std::size_t t) { work += cells_of(corners_of(t)).work(); });
  Reporter reporter(progress.part(0.2, 1), work, kWorkPerReport);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) draw_triangle(corners_of(t), reporter);
}

/// 1 / distance is linear in perspective pictures, the distance itself in orthographic ones.
float Visibility::nearness(std::span<const Seen> seen, std::span<const float> weights) const {
  float sum = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    sum += camera_.orthographic() ? weights[i] * seen[i].distance : weights[i] / seen[i].distance;
  }
  return camera_.orthographic() ? 1 / sum : sum;
}

/// Signed distance from the slice up to a positive factor, linear in space.
float Visibility::beyond(std::span<const Seen> seen, std::span<const float> weights) const {
  float sum = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const float share = weights[i] * seen[i].beyond;
    sum += camera_.orthographic() ? share : share / seen[i].distance;
  }
  return sum;
}

Visibility::Cells Visibility::cells_of(const std::array<Seen, 3>& corners) const {
  const auto& [a, b, c] = corners;
  const Eigen::Vector2f lower = a.pixel.cwiseMin(b.pixel).cwiseMin(c.pixel);
  const Eigen::Vector2f upper = a.pixel.cwiseMax(b.pixel).cwiseMax(c.pixel);
  const auto cell = [](float pixel, int count) {
    return static_cast<int>(
        std::clamp(std::floor(kPerPixel * pixel), -1.0f, static_cast<float>(count)));
  };
  // NaN fails this test and covers no cell.
  if (!(lower.x() <= upper.x() && lower.y() <= upper.y())) return {0, -1, 0, -1};
  return {std::max(0, cell(lower.y(), rows_)), std::min(rows_ - 1, cell(upper.y(), rows_)),
          std::max(0, cell(lower.x(), columns_)),
          std::min(columns_ - 1, cell(upper.x(), columns_))};
}

void Visibility::draw_triangle(const std::array<Seen, 3>& corners, Reporter& reporter) {
  const auto& [a, b, c] = corners;
  const auto [first_row, last_row, first_column, last_column] = cells_of(corners);
  const float area = edge_function(a.pixel, b.pixel, c.pixel.x(), c.pixel.y());
  reporter.done(16);
  if (area == 0 || !std::isfinite(area)) return;
  for (int row = first_row; row <= last_row; ++row) {
    reporter.done(static_cast<std::size_t>(std::max(0, last_column - first_column + 1)));
    const float y = (static_cast<float>(row) + 0.5f) / kPerPixel;
    for (int column = first_column; column <= last_column; ++column) {
      const float x = (static_cast<float>(column) + 0.5f) / kPerPixel;
      const float u = edge_function(b.pixel, c.pixel, x, y) / area;
      const float v = edge_function(c.pixel, a.pixel, x, y) / area;
      const float w = 1 - u - v;
      if (u < 0 || v < 0 || w < 0) continue;
      if (camera_.slice && beyond(corners, std::array{u, v, w}) > 0) continue;
      float& nearest = nearness_[static_cast<std::size_t>(row) * columns_ + column];
      nearest = std::max(nearest, nearness(corners, std::array{u, v, w}));
    }
  }
}

bool Visibility::in_picture(const Seen& seen) const {
  const float x = kPerPixel * seen.pixel.x(), y = kPerPixel * seen.pixel.y();
  return x >= 0 && y >= 0 && x < static_cast<float>(columns_) && y < static_cast<float>(rows_);
}

/// Visible if not farther than the farthest surface in the nine cells around the point. These
/// contain the point's own surface, however steep it is.
bool Visibility::visible(const Seen& seen, float tolerance) const {
  if (!in_picture(seen)) return false;
  const float x = kPerPixel * seen.pixel.x(), y = kPerPixel * seen.pixel.y();
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  float farthest = 0, nearest = std::numeric_limits<float>::infinity();
  for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
      const float nearness = nearness_[static_cast<std::size_t>(r) * columns_ + c];
      if (nearness == 0) continue;
      farthest = std::max(farthest, 1 / nearness);
      nearest = std::min(nearest, 1 / nearness);
    }
  }
  // Towards its silhouette a surface gets ever steeper.
  const float slack = std::min(farthest - nearest, kSteepest * farthest) + tolerance * farthest;
  return farthest == 0 || seen.distance <= farthest + slack;
}

void Visibility::add_strokes(std::span<const Seen> path, float tolerance, bool hidden,
                             std::vector<Stroke>& strokes) const {
  Stroke stroke;
  const auto finish = [&] {
    if (length_of(stroke) >= kShortest)
      strokes.push_back(simplified_stroke(stroke, kSmallestCorner));
    stroke.clear();
  };
  float passed = 0;  // pixels since the last visible point
  Stroke behind;     // held back: noise if the gap turns out short
  const auto pass = [&](const Seen& seen, float step) {
    behind.push_back(seen.pixel);
    passed += step;
    if (seen.beyond <= 0 && in_picture(seen) && visible(seen, tolerance) != hidden) {
      if (passed > kLongestGap + step) finish(), behind = {seen.pixel};
      stroke.insert(stroke.end(), behind.begin(), behind.end());
      behind.clear();
      passed = 0;
    }
  };
  if (!path.empty()) pass(path[0], 0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Seen& from = path[i - 1];
    const Seen& to = path[i];
    const float length = (to.pixel - from.pixel).norm();
    if (!std::isfinite(length) || length > 1e5f) continue;
    const int steps = std::max(1, static_cast<int>(std::ceil(length / kStep)));
    for (int step = 1; step <= steps; ++step) {
      const float t = static_cast<float>(step) / static_cast<float>(steps);
      const float near = nearness(path.subspan(i - 1, 2), std::array{1 - t, t});
      const float off = beyond(path.subspan(i - 1, 2), std::array{1 - t, t});
      pass({from.pixel + t * (to.pixel - from.pixel), 1 / near, off},
           length / static_cast<float>(steps));
    }
  }
  finish();
}

std::vector<Stroke> Visibility::strokes(const Polylines& lines, float tolerance, bool hidden,
                                        const Progress& heard) const {
  JobStages stages(heard, {{"strokes", 1}});
  Reporter reporter(stages.begin("strokes"), lines.points.size());
  std::vector<Stroke> strokes;
  std::vector<Seen> path;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    path.clear();
    reporter.done(lines.points_of(line).size());
    for (const Vec3& point : lines.points_of(line)) path.push_back(project(point));
    if (lines.closed[line] && !path.empty()) path.push_back(path.front());
    add_strokes(path, tolerance, hidden, strokes);
  }
  stages.finish();
  return strokes;
}

std::vector<Pen> line_drawing(const Mesh& mesh, std::span<const Vec3> normals,
                              std::span<const PenLines> drawn, const CameraView& view, int width,
                              int height, const Progress& progress) {
  // The outline is smooth; the one in the depth cells beside it has corners.
  constexpr float kOutlineTolerance = 0.01f;
  constexpr Color kOutlineColor{0.25f, 0.25f, 0.27f};
  constexpr double kSeen = 0.3, kDrawn = 0.7, kOutlined = 0.9, kOrdered = 0.95;
  const Visibility visibility(mesh, view, width, height, progress.part(0, kSeen));
  std::vector<Pen> pens;
  for (const PenLines& lines : drawn) {
    const auto done = static_cast<double>(pens.size()) / static_cast<double>(drawn.size());
    const double share = (kDrawn - kSeen) / static_cast<double>(drawn.size());
    const double begin = kSeen + done * (kDrawn - kSeen);
    pens.push_back(
        {lines.name, lines.color, 1.0f,
         visibility.strokes(lines.lines, 1e-4f, false, progress.part(begin, begin + share))});
  }
  const Polylines bounds =
      outline(mesh, normals, view, width, height, progress.part(kDrawn, kOutlined));
  pens.push_back(
      {"outline", kOutlineColor, 1.4f,
       visibility.strokes(bounds, kOutlineTolerance, false, progress.part(kOutlined, kOrdered))});
  const Camera camera = drawing_camera(mesh, view, width, height);
  if (camera.slice) {
    const Polylines edge = slice_lines(mesh, normals, *camera.slice);
    for (Stroke& stroke : visibility.strokes(edge, kOutlineTolerance)) {
      pens.back().strokes.push_back(std::move(stroke));
    }
  }
  order_strokes(pens, progress.part(kOrdered, 1));
  return pens;
}

void write_svg(const std::filesystem::path& path, int width, int height, std::span<const Pen> pens,
               const Progress& progress, const std::optional<PaperSize>& paper) {
  const auto write = [&](OutputStream& out) {
    TextOutput text(out);
    text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         << (paper ? page_of(*paper) : page_of(width, height)) << ">\n";
    for (const Pen& pen : pens) put_pen(text, pen);
    text << "</svg>\n";
  };
  write_file(path, write, progress);
}

}  // namespace brindle
