#include "brindle/gpu/stage_trace.h"

#include <algorithm>

#include <epoxy/gl.h>

namespace brindle {

StageTimer::~StageTimer() {
  if (!queries_.empty()) glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

void StageTimer::start() {
  names_.clear();
  mark();
}

void StageTimer::stage(std::string_view name) {
  names_.push_back(name);
  mark();
}

void StageTimer::mark() {
  if (names_.size() == queries_.size()) {
    GLuint query = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &query);
    queries_.push_back(query);
  }
  glQueryCounter(queries_[names_.size()], GL_TIMESTAMP);
}

std::vector<StageTime> StageTimer::milliseconds() const {
  std::vector<StageTime> times;
  const auto nanoseconds = [&](std::size_t query) {
    GLuint64 value = 0;
    glGetQueryObjectui64v(queries_[query], GL_QUERY_RESULT, &value);
    return value;
  };
  for (std::size_t s = 0; s < names_.size(); ++s) {
    const double duration = 1e-6 * static_cast<double>(nanoseconds(s + 1) - nanoseconds(s));
    const auto known = std::ranges::find(times, names_[s], &StageTime::first);
    if (known == times.end()) {
      times.emplace_back(names_[s], duration);
    } else {
      known->second += duration;
    }
  }
  return times;
}

}  // namespace brindle
