#include "brindle/render/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// Strokes are separated by spaces; '-' begins one with sharp corners, '~' one with rounded
/// corners. A point has two characters, 0 to 9, a, b: x, and y from two units below the base line.
/// Capitals are eight units high, small letters five.
struct Letter {
  char32_t code;
  std::string_view strokes;
};

constexpr Letter kLetters[] = {
    {U' ', ""},
    {U'0', "~02424a0a02"},
    {U'1', "-183a32"},
    {U'2', "~080a4a4702 -0242"},
    {U'3', "~090a4a4626 ~2646420203"},
    {U'4', "-323a0444"},
    {U'5', "-4a0a07 ~0747420203"},
    {U'6', "~4a0a0504 ~0242470702"},
    {U'7', "-0a4a12"},
    {U'8', "~0a4a46060a ~0242460602"},
    {U'9', "~02424748 ~05454a0a05"},
    {U'.', "-1212"},
    {U',', "-1201"},
    {U'-', "-0636"},
    {U'+', "-0646 -2428"},
    {U'/', "-014b"},
    {U'(', "~2b080421"},
    {U')', "~0b282401"},
    {U'[', "-2b0b0121"},
    {U']', "-0b2b2101"},
    {U'%', "~0a2a28080a ~2444422224 -024a"},
    {U'°', "~0b2b29090b"},
    {U'²', "~0a0b2b2a08 -0828"},
    {U'³', "~0b2b2a1a ~1a2a2808"},
    {U'·', "-1515"},
    {U'=', "-0545 -0747"},
    {U':', "-1212 -1616"},
    {U'_', "-0141"},
    {U'^', "-082a48"},
    {U'|', "-0b01"},
    {U'<', "-480644"},
    {U'>', "-084604"},
    {U'A', "-022a42 -1535"},
    {U'B', "-020a2a -0626 -0222 ~2a4a4626 ~26464222"},
    {U'C', "~484a0a024244"},
    {U'D', "-020a1a -0212 ~1a4a4212"},
    {U'E', "-4a0a0242 -0636"},
    {U'F', "-4a0a02 -0636"},
    {U'G', "~484a0a024246 -4626"},
    {U'H', "-020a -424a -0646"},
    {U'I', "-020a"},
    {U'J', "~3a320204"},
    {U'K', "-020a -4a05 -1642"},
    {U'L', "-0a0242"},
    {U'M', "-020a265a52"},
    {U'N', "-020a424a"},
    {U'O', "~02525a0a02"},
    {U'P', "-020a2a -0525 ~2a4a4525"},
    {U'Q', "~02525a0a02 -3452"},
    {U'R', "-020a2a -0525 ~2a4a4525 -2542"},
    {U'S', "~494a0a0646420203"},
    {U'T', "-0a4a -222a"},
    {U'U', "~0a02424a"},
    {U'V', "-0a224a"},
    {U'W', "-0a1238526a"},
    {U'X', "-024a -0a42"},
    {U'Y', "-0a264a -2622"},
    {U'Z', "-0a4a0242"},
    {U'a', "~0242470702 -4742"},
    {U'b', "-020a ~0242470702"},
    {U'c', "~464707024243"},
    {U'd', "~0242470702 -4a42"},
    {U'e', "-0545 ~454707024243"},
    {U'f', "~3a1a17 -1712 -0737"},
    {U'g', "~0242470702 -4742 ~42400001"},
    {U'h', "-020a ~05074742"},
    {U'i', "-0207 -0909"},
    {U'j', "~171000 -1919"},
    {U'k', "-020a -3704 -1532"},
    {U'l', "-0a04 ~040212"},
    {U'm', "-0207 ~05073732 ~35376762"},
    {U'n', "-0207 ~05074742"},
    {U'o', "~0242470702"},
    {U'p', "-0007 ~0242470702"},
    {U'q', "-4047 ~0242470702"},
    {U'r', "-0207 ~050737"},
    {U's', "~4647070545420203"},
    {U't', "-1a14 ~141232 -0737"},
    {U'u', "~07024245 -4742"},
    {U'v', "-072247"},
    {U'w', "-0712263247"},
    {U'x', "-0742 -0247"},
    {U'y', "-0722 -4710"},
    {U'z', "-07470242"},
    {U'µ', "-0007 ~07024245 -4742"},
};

constexpr std::string_view kUnknown = "-020a4a4202";
constexpr float kCapitals = 8;  // units
constexpr float kSpace = 2.4f;  // between letters
constexpr float kBlank = 2.6f;  // a blank's width

using Points = std::vector<Eigen::Vector2f>;

float unit_of(char c) { return static_cast<float>(c <= '9' ? c - '0' : c - 'a' + 10); }

/// Corner cutting (Chaikin 1974); ends stay.
Points with_corners_cut(const Points& points, bool closed) {
  Points cut;
  if (!closed) cut.push_back(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    cut.push_back(0.75f * points[i - 1] + 0.25f * points[i]);
    cut.push_back(0.25f * points[i - 1] + 0.75f * points[i]);
  }
  cut.push_back(closed ? cut.front() : points.back());
  return cut;
}

Points stroke_of(std::string_view text) {
  Points points;
  for (std::size_t i = 1; i + 1 < text.size(); i += 2) {
    points.emplace_back(unit_of(text[i]), unit_of(text[i + 1]) - 2);
  }
  if (text.front() == '~') {
    const bool closed = points.front() == points.back();
    for (int times = 0; times < 4; ++times) points = with_corners_cut(points, closed);
  }
  return points;
}

std::string_view letter_of(char32_t code) {
  const auto letter = ranges::find(kLetters, code, &Letter::code);
  return letter == std::end(kLetters) ? kUnknown : letter->strokes;
}

/// The next UTF-8 character; longer ones than two bytes are not distinguished.
char32_t next_code(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  if (first < 0x80) return first;
  char32_t code = first & 0x1f;
  while (!text.empty() && (static_cast<unsigned char>(text.front()) & 0xc0) == 0x80) {
    code = code << 6 | (static_cast<unsigned char>(text.front()) & 0x3f);
    text.remove_prefix(1);
  }
  return code;
}

/// Calls `put` with the strokes of each letter and its position; returns the end of the text.
template <class Put>
float lay_out(std::string_view text, Put put) {
  float x = 0;
  while (!text.empty()) {
    const char32_t code = next_code(text);
    if (code == U' ') {
      x += kBlank;
      continue;
    }
    float width = 0;
    std::string_view rest = letter_of(code);
    while (!rest.empty()) {
      const std::string_view stroke = rest.substr(0, rest.find(' '));
      rest.remove_prefix(std::min(rest.size(), stroke.size() + 1));
      const Points points = stroke_of(stroke);
      for (const auto& point : points) width = std::max(width, point.x());
      put(points, x);
    }
    x += width + kSpace;
  }
  return std::max(x - kSpace, 0.0f);
}

}  // namespace

std::vector<Stroke> text_strokes(std::string_view text, const Eigen::Vector2f& start,
                                 float height) {
  const float scale = height / kCapitals;
  std::vector<Stroke> strokes;
  lay_out(text, [&](const Points& points, float x) {
    Stroke& stroke = strokes.emplace_back();
    for (const auto& point : points) {
      stroke.emplace_back(start.x() + scale * (x + point.x()), start.y() - scale * point.y());
    }
  });
  return strokes;
}

float text_width(std::string_view text, float height) {
  return height / kCapitals * lay_out(text, [](const Points& /*points*/, float /*x*/) {});
}

std::vector<double> tick_values(double lowest, double highest, int most) {
  if (!(highest > lowest)) return {lowest};
  const double rough = (highest - lowest) / std::max(most - 1, 1);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * (1 - 1e-9)) {
      step = factor * power;
      break;
    }
  }
  std::vector<double> values;
  const double slack = 1e-6 * step;
  for (double k = std::ceil((lowest - slack) / step); k * step <= highest + slack; ++k) {
    values.push_back(k * step);
  }
  if (values.size() < 2) return {lowest, highest};
  return values;
}

}  // namespace brindle
