/// Who hears of a long job.
#pragma once

#include <string>
#include <string_view>

#include "brindle/progress.h"

namespace brindle::tool {

class JobListener {
 public:
  virtual ~JobListener() = default;

  /// What to hand to a long job.
  virtual Progress progress() = 0;

  /// Names the stage that begins. Throws Cancelled if the job is to stop.
  void stage(std::string_view name) { progress().report(name, 0); }

  /// Lines for the user; nothing if the text is empty.
  virtual void note(const std::string& text) = 0;
};

}  // namespace brindle::tool
