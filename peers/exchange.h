// What the programs of all peers read and write: meshes as OBJ, vectors as CSV, metrics as JSON.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using Point = std::array<double, 3>;

struct TriangleMesh {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// The vertices and triangles of an OBJ file, whose faces are triangles and nothing else. Throws
// std::runtime_error with the file and the line.
TriangleMesh read_obj(const std::string& path);

// One row x,y,z a vertex. Throws where the file cannot be written.
void write_vectors(const std::string& path, const std::vector<Point>& vectors);

// A stopwatch that starts when it is made and whenever it is read, in milliseconds.
class Stopwatch {
 public:
  double lap();

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

// Metrics by name, written as one JSON object in the order in which they came.
class Metrics {
 public:
  void add(const std::string& name, double value);
  void add(const std::string& name, const std::string& text);
  void write(const std::string& path) const;

 private:
  std::vector<std::pair<std::string, std::string>> entries_;
};

// Options of a driver: words --name value.
std::string option(const std::vector<std::string>& words, const std::string& name,
                   const std::string& otherwise);
double number_option(const std::vector<std::string>& words, const std::string& name,
                     double otherwise);

// Runs `driver` on the words behind the program's name and turns what it throws into one line on
// stderr. Exit codes: 0 done, 1 it failed, 2 wrong usage (no words).
int run_driver(int count, char** words, const std::string& usage,
               const std::function<void(const std::vector<std::string>&)>& driver);
