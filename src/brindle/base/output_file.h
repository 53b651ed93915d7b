/// Files that are either written whole or not at all.
#pragma once

#include <filesystem>
#include <functional>

#include "brindle/base/output_stream.h"
#include "brindle/error.h"
#include "brindle/progress.h"

namespace brindle {

/// Lets `write` fill a file that has no name yet, then gives it the name `path`. On any failure,
/// and if the process is killed meanwhile, nothing stays behind and what stood at `path` before
/// stays as it was. (Where the file system knows no files without names, the file is called
/// .brindle-NUMBER.tmp until it is whole, and being killed leaves that.) A file that is replaced
/// hands its owner and permissions on; a link is followed, and stays. A `path` that is not a
/// regular file (a device, a pipe) is written to directly.
/// Throws Error, naming the path, the system's reason and the remedy, if the folder does not exist,
/// cannot be written to or is full; passes on what `write` throws. `progress` hears "writing PATH"
/// after every few megabytes, and Cancelled leaves the path as any failure does; how large the file
/// will be is not known, so that the fraction nears 1 ever more slowly.
void write_file(const std::filesystem::path& path, const std::function<void(OutputStream&)>& write,
                const Progress& progress = {});

/// The same in two steps, for who cannot write to a stream, and for who has to hear of other files
/// before this one gets its name: a file without a name.
class UnfinishedFile {
 public:
  /// Throws Error as `write_file` does. `path` is no device.
  explicit UnfinishedFile(const std::filesystem::path& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  int descriptor() const { return descriptor_; }

  /// Lets `write` fill the file, as `write_file` does.
  void write(const std::function<void(OutputStream&)>& write, const Progress& progress = {});

  /// By what other programs can open it, as long as this lives.
  std::filesystem::path place() const;

  /// Gives the file its name. Throws Error as `write_file` does.
  void finish();

 private:
  std::filesystem::path path_, target_;
  std::filesystem::path temporary_;  ///< its name now; empty if it has none
  int descriptor_ = -1;
};

/// Throws the Error that `write_file` would throw for a `path` that is a folder, lies in a folder
/// that does not exist or may not be written to, or has too long a name. Ask before a long job,
/// whose result would be lost.
void check_output_path(const std::filesystem::path& path);

/// Whether something is there that is no regular file: a device or a pipe, written to directly.
bool is_device(const std::filesystem::path& path);

}  // namespace brindle
