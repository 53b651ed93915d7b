#include "brindle/line_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <ostream>

#include <Eigen/Geometry>

#include "brindle/base/output_file.h"
#include "brindle/base/text_output.h"
#include "brindle/error.h"

namespace brindle {
namespace {

constexpr int kPerPixel = 2;         // depths along a side of a pixel
constexpr float kStep = 0.5f;        // pixels between points whose visibility is asked for
constexpr float kShortest = 1.5f;    // pixels: shorter strokes are noise along silhouettes
constexpr float kLongestGap = 1.5f;  // pixels: shorter gaps are noise, too
constexpr float kSteepest = 5e-3f;   // of distances, between neighbouring cells

float edge_function(const Eigen::Vector2f& a, const Eigen::Vector2f& b, float x, float y) {
  return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
}

float length_of(const Stroke& stroke) {
  float length = 0;
  for (std::size_t i = 1; i < stroke.size(); ++i) length += (stroke[i] - stroke[i - 1]).norm();
  return length;
}

Stroke without_needless_corners(const Stroke& stroke) {
  constexpr float kSmallest = 0.05f;
  Polylines line;
  for (const auto& p : stroke) {
    line.points.emplace_back(p.x(), p.y(), 0.0f);
    line.normals.emplace_back(0.0f, 0.0f, 1.0f);
  }
  line.offsets.push_back(static_cast<Index>(stroke.size()));
  line.closed.push_back(0);
  Stroke result;
  for (const Vec3& p : simplified(line, kSmallest).points) result.emplace_back(p.x(), p.y());
  return result;
}

/// Two digits behind the point are a hundredth of a pixel.
void put(TextOutput& text, float value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.2f", static_cast<double>(value));
  text << static_cast<const char*>(digits);
}

void remove_edge(std::map<Index, std::vector<Index>>& edges, Index from, Index to) {
  std::erase(edges[from], to);
  std::erase(edges[to], from);
}

/// Edges joined into lines as long as they go on.
Polylines chains(const Mesh& mesh, std::span<const Vec3> normals,
                 std::map<Index, std::vector<Index>> edges) {
  Polylines lines;
  std::vector<Index> starts;
  // From where lines end or fork first, then what is left: closed lines.
  for (const auto& [vertex, others] : edges) {
    if (others.size() != 2) starts.push_back(vertex);
  }
  for (const auto& [vertex, others] : edges) starts.push_back(vertex);
  for (const Index start : starts) {
    while (!edges[start].empty()) {
      for (Index vertex = start;;) {
        lines.points.push_back(mesh.positions[vertex]);
        lines.normals.push_back(normals[vertex]);
        if (edges[vertex].empty()) break;
        const Index next = edges[vertex].front();
        remove_edge(edges, vertex, next);
        vertex = next;
      }
      lines.offsets.push_back(static_cast<Index>(lines.points.size()));
      lines.closed.push_back(0);
    }
  }
  return lines;
}

std::string hexadecimal(const Color& color) {
  const auto byte = [](float level) { return static_cast<int>(std::lround(255 * level)); };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color.red), byte(color.green),
                byte(color.blue));
  return text;
}

}  // namespace

Visibility::Visibility(const Mesh& mesh, const CameraView& view, int width, int height)
    : width_(width), height_(height), columns_(kPerPixel * width), rows_(kPerPixel * height) {
  if (width < 1 || height < 1 || width > 8192 || height > 8192) {
    throw Error("a drawing has 1 to 8192 pixels along each side, not " + std::to_string(width) +
                "x" + std::to_string(height));
  }
  camera_ = framed_camera(points_of_triangles(mesh), view, width, height);
  nearness_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
  draw(mesh);
}

Visibility::Seen Visibility::project(const Vec3& point) const {
  const Vec3 relative = point - camera_.origin;
  const Eigen::Vector4f clip =
      camera_.clip_from_view * (camera_.view_from_world * relative.homogeneous());
  const float x = clip.x() / clip.w(), y = clip.y() / clip.w();
  return {
      {0.5f * (1 + x) * static_cast<float>(width_), 0.5f * (1 - y) * static_cast<float>(height_)},
      clip.w()};
}

void Visibility::draw(const Mesh& mesh) {
  std::vector<Seen> seen;
  seen.reserve(mesh.vertex_count());
  for (const Vec3& position : mesh.positions) seen.push_back(project(position));
  for (const Triangle& t : mesh.triangles) draw_triangle({seen[t[0]], seen[t[1]], seen[t[2]]});
}

/// 1 / distance is linear in the picture.
void Visibility::draw_triangle(const std::array<Seen, 3>& corners) {
  const auto& [a, b, c] = corners;
  const float area = edge_function(a.pixel, b.pixel, c.pixel.x(), c.pixel.y());
  if (area == 0 || !std::isfinite(area)) return;
  const Eigen::Vector2f lower = a.pixel.cwiseMin(b.pixel).cwiseMin(c.pixel);
  const Eigen::Vector2f upper = a.pixel.cwiseMax(b.pixel).cwiseMax(c.pixel);
  const auto cell = [](float pixel, int count) {
    return static_cast<int>(
        std::clamp(std::floor(kPerPixel * pixel), -1.0f, static_cast<float>(count)));
  };
  const int first_row = std::max(0, cell(lower.y(), rows_));
  const int last_row = std::min(rows_ - 1, cell(upper.y(), rows_));
  const int first_column = std::max(0, cell(lower.x(), columns_));
  const int last_column = std::min(columns_ - 1, cell(upper.x(), columns_));
  for (int row = first_row; row <= last_row; ++row) {
    const float y = (static_cast<float>(row) + 0.5f) / kPerPixel;
    for (int column = first_column; column <= last_column; ++column) {
      const float x = (static_cast<float>(column) + 0.5f) / kPerPixel;
      const float u = edge_function(b.pixel, c.pixel, x, y) / area;
      const float v = edge_function(c.pixel, a.pixel, x, y) / area;
      const float w = 1 - u - v;
      if (u < 0 || v < 0 || w < 0) continue;
      float& nearest = nearness_[static_cast<std::size_t>(row) * columns_ + column];
      nearest = std::max(nearest, u / a.distance + v / b.distance + w / c.distance);
    }
  }
}

/// Behind nothing: not farther than the farthest surface seen in the nine cells around it. The
/// surface that the point lies on is among them, however steep it is.
bool Visibility::visible(const Seen& seen, float tolerance) const {
  const float x = kPerPixel * seen.pixel.x(), y = kPerPixel * seen.pixel.y();
  const bool within =
      x >= 0 && y >= 0 && x < static_cast<float>(columns_) && y < static_cast<float>(rows_);
  if (!within) return false;
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
  // Towards its outline a surface falls off ever more steeply.
  const float slack = std::min(farthest - nearest, kSteepest * farthest) + tolerance * farthest;
  return farthest == 0 || seen.distance <= farthest + slack;
}

void Visibility::add_strokes(std::span<const Seen> path, float tolerance,
                             std::vector<Stroke>& strokes) const {
  Stroke stroke;
  const auto finish = [&] {
    if (length_of(stroke) >= kShortest) strokes.push_back(without_needless_corners(stroke));
    stroke.clear();
  };
  float hidden = 0;  // pixels since the last visible point
  Stroke behind;     // what may turn out to be a gap that is noise
  const auto pass = [&](const Seen& seen, float step) {
    behind.push_back(seen.pixel);
    hidden += step;
    if (visible(seen, tolerance)) {
      if (hidden > kLongestGap + step) finish(), behind = {seen.pixel};
      stroke.insert(stroke.end(), behind.begin(), behind.end());
      behind.clear();
      hidden = 0;
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
      const float nearness = (1 - t) / from.distance + t / to.distance;
      pass({from.pixel + t * (to.pixel - from.pixel), 1 / nearness},
           length / static_cast<float>(steps));
    }
  }
  finish();
}

std::vector<Stroke> Visibility::strokes(const Polylines& lines, float tolerance) const {
  std::vector<Stroke> strokes;
  std::vector<Seen> path;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    path.clear();
    for (const Vec3& point : lines.points_of(line)) path.push_back(project(point));
    if (lines.closed[line] && !path.empty()) path.push_back(path.front());
    add_strokes(path, tolerance, strokes);
  }
  return strokes;
}

Polylines outline(const Mesh& mesh, std::span<const Vec3> normals, const CameraView& view,
                  int width, int height) {
  const Camera camera = framed_camera(points_of_triangles(mesh), view, width, height);
  const Eigen::Matrix3f axes = camera.view_from_world.topLeftCorner<3, 3>();
  const Vec3 eye = camera.origin - axes.transpose() * camera.view_from_world.topRightCorner<3, 1>();
  struct Sides {
    int front = 0, back = 0;
  };
  std::map<std::pair<Index, Index>, Sides> edges;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.positions[t[0]];
    const Vec3 normal = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
    const bool front = normal.dot(eye - a) > 0;
    for (int m = 0; m < 3; ++m) {
      Sides& sides = edges[std::minmax(t[m], t[(m + 1) % 3])];
      ++(front ? sides.front : sides.back);
    }
  }
  std::map<Index, std::vector<Index>> bounding;  // for every vertex those at the other ends
  for (const auto& [edge, sides] : edges) {
    const bool bounds = sides.front + sides.back == 1 || (sides.front > 0 && sides.back > 0);
    if (!bounds) continue;
    bounding[edge.first].push_back(edge.second);
    bounding[edge.second].push_back(edge.first);
  }
  return chains(mesh, normals, bounding);
}

void write_svg(const std::filesystem::path& path, int width, int height,
               std::span<const Pen> pens) {
  write_file(path, [&](std::ostream& out) {
    TextOutput text(out);
    text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\""
         << width << "\" height=\"" << height << "\" viewBox=\"0 0 " << width << ' ' << height
         << "\">\n";
    for (const Pen& pen : pens) {
      text << "<g id=\"" << pen.name << "\" fill=\"none\" stroke=\"" << hexadecimal(pen.color)
           << "\" stroke-width=\"";
      put(text, pen.width);
      text << "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
      for (const Stroke& stroke : pen.strokes) {
        text << "<path d=\"M";
        for (std::size_t i = 0; i < stroke.size(); ++i) {
          text << (i == 0 ? "" : i == 1 ? "L" : " ");
          put(text, stroke[i].x());
          text << ' ';
          put(text, stroke[i].y());
        }
        text << "\"/>\n";
      }
      text << "</g>\n";
    }
    text << "</svg>\n";
  });
}

}  // namespace brindle
