#include "pictures/frame_output.h"

#include <cctype>
#include <string_view>
#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "cli/option_values.h"
#include "pictures/video_file.h"

namespace brindle::tool {

FrameWriter::FrameWriter() : thread_([this] { work(); }) {}

FrameWriter::~FrameWriter() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    waiting_.clear();
  }
  changed_.notify_all();
  thread_.join();
}

void FrameWriter::rethrow() const {
  if (failure_) std::rethrow_exception(failure_);
}

void FrameWriter::add(std::function<void()> job) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return failure_ || waiting_.size() < kMostWaiting; });
  rethrow();
  waiting_.push_back(std::move(job));
  changed_.notify_all();
}

void FrameWriter::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return failure_ || (waiting_.empty() && !busy_); });
  rethrow();
}

void FrameWriter::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
    if (ending_) return;
    std::function<void()> job = std::move(waiting_.front());
    waiting_.pop_front();
    busy_ = true;
    lock.unlock();
    std::exception_ptr failure;
    try {
      job();
    } catch (...) {
      failure = std::current_exception();
    }
    job = nullptr;  // frees its frame before the next one
    lock.lock();
    busy_ = false;
    if (failure) {
      failure_ = failure;
      waiting_.clear();
    }
    changed_.notify_all();
    if (failure_) return;
  }
}

namespace {

constexpr const char* kExpected =
    "a name.mp4, a PNG name with one number in it such as frames/%04d.png, or one of meshes such "
    "as "
    "steps/%04d.vtp";

// "d", "4d", "04d": number of digits, and length of the text.
struct Conversion {
  int digits = 0;
  std::size_t length = 0;
};

std::optional<Conversion> conversion_at(const std::string& name, std::size_t at) {
  Conversion result;
  while (at + result.length < name.size() &&
         std::isdigit(static_cast<unsigned char>(name[at + result.length])) != 0) {
    result.digits = 10 * result.digits + (name[at + result.length++] - '0');
    if (result.digits > 20) return std::nullopt;
  }
  const bool filled_with_zeros = result.length == 0 || name[at] == '0';
  if (!filled_with_zeros || at + result.length >= name.size()) return std::nullopt;
  if (name[at + result.length++] != 'd') return std::nullopt;
  return result;
}

}  // namespace

std::optional<FrameNames> parse_frame_names(const std::filesystem::path& pattern) {
  const std::string name = pattern.filename().string();
  FrameNames names;
  names.folder = pattern.parent_path();
  if (names.folder.string().find('%') != std::string::npos) return std::nullopt;
  bool has_number = false;
  for (std::size_t at = 0; at < name.size(); ++at) {
    std::string& text = has_number ? names.after : names.before;
    if (name[at] != '%') {
      text += name[at];
    } else if (at + 1 < name.size() && name[at + 1] == '%') {
      text += name[at++];
    } else {
      const auto conversion = conversion_at(name, at + 1);
      if (!conversion || has_number) return std::nullopt;
      has_number = true;
      names.digits = conversion->digits;
      at += conversion->length;
    }
  }
  return has_number ? std::optional(names) : std::nullopt;
}

std::string numbered_name(const FrameNames& names, long number) {
  std::string digits = std::to_string(number);
  const auto wanted = static_cast<std::size_t>(names.digits);
  if (digits.size() < wanted) digits.insert(0, wanted - digits.size(), '0');
  return names.before + digits + names.after;
}

FrameOutput parse_frame_output(const std::string& option, const std::string& text) {
  const std::filesystem::path path(text);
  const std::string extension = lower_extension(path);
  FrameOutput output;
  if (extension == ".mp4") {
    output.video = path;
    return output;
  }
  const auto names = parse_frame_names(path);
  if (!names || (extension != ".png" && extension != ".vtp")) {
    wrong_usage(option, kExpected, text);
  }
  output.names = *names;
  output.meshes = extension == ".vtp";
  return output;
}

std::filesystem::path frame_path(const FrameOutput& output, std::size_t number) {
  return output.names.folder / numbered_name(output.names, static_cast<long>(number));
}

std::filesystem::path collection_path(const FrameOutput& output) {
  const std::string& after = output.names.after;
  std::string name = output.names.before + after.substr(0, after.rfind('.'));
  while (!name.empty() && std::string_view("_-.").find(name.back()) != std::string_view::npos) {
    name.pop_back();
  }
  return output.names.folder / ((name.empty() ? "series" : name) + ".pvd");
}

std::vector<std::filesystem::path> frame_files(const FrameOutput& output, std::size_t count) {
  if (output.is_video()) return {output.video};
  std::vector<std::filesystem::path> files;
  for (std::size_t number = 0; number < count; ++number) {
    files.push_back(frame_path(output, number));
  }
  if (output.meshes) files.push_back(collection_path(output));
  return files;
}

void check_frame_output(const FrameOutput& output) {
  check_output_path(output.is_video() ? output.video : frame_path(output, 0));
  if (output.is_video()) check_video_available(output.video);
  if (output.meshes) check_name_in_xml(frame_path(output, 0));  // the collection lists them
}

}  // namespace brindle::tool
