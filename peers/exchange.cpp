#include "exchange.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <stdexcept>

namespace {

[[noreturn]] void fail(const std::string& path, std::size_t line, const std::string& what) {
  throw std::runtime_error(path + ":" + std::to_string(line) + ": " + what);
}

Point point_of(const std::string& path, std::size_t number, const std::string& line) {
  Point point;
  const char* next = line.c_str() + 2;
  for (double& value : point) {
    char* end = nullptr;
    value = std::strtod(next, &end);
    if (end == next) fail(path, number, "not three numbers");
    next = end;
  }
  return point;
}

// Of a corner 7/3/7 the first number counts.
std::array<std::size_t, 3> triangle_of(const std::string& path, std::size_t number,
                                       const std::string& line, std::size_t points) {
  std::array<std::size_t, 3> triangle{};
  const char* next = line.c_str() + 2;
  for (std::size_t& index : triangle) {
    char* end = nullptr;
    index = std::strtoull(next, &end, 10) - 1;
    if (end == next || index >= points) fail(path, number, "not three vertices");
    next = end + std::strcspn(end, " ");
  }
  if (next[std::strspn(next, " \r")] != 0) fail(path, number, "more than three corners");
  return triangle;
}

void write_whole(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(path + ": cannot be written");
}

std::string text_of(double value) {
  if (!std::isfinite(value)) return "null";
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.9g", value);
  return digits;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + '"';
}

}  // namespace

TriangleMesh read_obj(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + ": cannot be read");
  TriangleMesh mesh;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (line.starts_with("v ")) {
      mesh.points.push_back(point_of(path, number, line));
    } else if (line.starts_with("f ")) {
      mesh.triangles.push_back(triangle_of(path, number, line, mesh.points.size()));
    }
  }
  if (mesh.triangles.empty()) throw std::runtime_error(path + ": it has no triangles");
  return mesh;
}

void write_vectors(const std::string& path, const std::vector<Point>& vectors) {
  std::string text;
  for (const Point& v : vectors) {
    for (std::size_t m = 0; m < 3; ++m) {
      text += std::isfinite(v[m]) ? text_of(v[m]) : "nan";
      text += m < 2 ? ',' : '\n';
    }
  }
  write_whole(path, text);
}

double Stopwatch::lap() {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double, std::milli> passed = now - began_;
  began_ = now;
  return passed.count();
}

void Metrics::add(const std::string& name, double value) {
  entries_.emplace_back(name, text_of(value));
}

void Metrics::add(const std::string& name, const std::string& text) {
  entries_.emplace_back(name, quoted(text));
}

void Metrics::write(const std::string& path) const {
  std::string text = "{";
  for (const auto& [name, value] : entries_) {
    text += (text.size() > 1 ? ",\n " : "\n ") + quoted(name) + ": " + value;
  }
  write_whole(path, text + "\n}\n");
}

std::string option(const std::vector<std::string>& words, const std::string& name,
                   const std::string& otherwise) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] == "--" + name) return words[i + 1];
  }
  return otherwise;
}

double number_option(const std::vector<std::string>& words, const std::string& name,
                     double otherwise) {
  const std::string text = option(words, name, "");
  if (text.empty()) return otherwise;
  std::size_t read = 0;
  double value = 0;
  try {
    value = std::stod(text, &read);
  } catch (const std::logic_error&) {
  }
  if (read != text.size()) throw std::runtime_error("--" + name + ": '" + text + "' is no number");
  return value;
}

int run_driver(int count, char** words, const std::string& usage,
               const std::function<void(const std::vector<std::string>&)>& driver) {
  if (count < 2) {
    std::fprintf(stderr, "usage: %s %s\n", words[0], usage.c_str());
    return 2;
  }
  try {
    driver({words + 1, words + count});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peer: %s\n", error.what());
    return 1;
  }
}
