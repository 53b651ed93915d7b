#include "ranks/request.h"

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "brindle/base/text.h"
#include "brindle/version.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> kOfOneRank = {"--threads", "--quiet", "--stall-limit"};

std::string quoted(const std::string& word) {
  const bool plain = word.find_first_of(" '\"\n\t") == std::string::npos && !word.empty();
  return plain ? word : "'" + word + "'";
}

std::string words_of(int argc, char** argv) {
  std::string words;
  for (int i = 1; i < argc; ++i) words += (i > 1 ? " " : "") + quoted(argv[i]);
  return words;
}

/// A separator that no word contains.
constexpr char kEnd = '\0';

std::string key_of(const CLI::App& command) {
  std::map<std::string, std::string> given;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || kOfOneRank.contains(name)) continue;
    for (const std::string& result : option->results()) given[name] += result + kEnd;
  }
  std::string key = command.get_name() + kEnd;
  for (const auto& [name, results] : given) key += name + kEnd + results + kEnd;
  return key;
}

/// "rank 3", "ranks 0, 1 and 7 more".
std::string name_of(const std::vector<int>& ranks) {
  constexpr std::size_t kMostNamed = 8;
  std::string text = ranks.size() == 1 ? "rank " : "ranks ";
  for (std::size_t i = 0; i < ranks.size() && i < kMostNamed; ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(ranks[i]);
  }
  if (ranks.size() > kMostNamed) {
    text += " and " + std::to_string(ranks.size() - kMostNamed) + " more";
  }
  return text;
}

/// Rank 0's text, on all ranks.
std::string text_of_first(Communicator& ranks, const std::string& text) {
  const std::vector<char> of_first = ranks.of_first(std::vector<char>(text.begin(), text.end()));
  return {of_first.begin(), of_first.end()};
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// One line for all ranks with the same words.
std::string groups_of(const std::vector<std::vector<std::byte>>& keys,
                      const std::vector<std::vector<std::byte>>& words) {
  std::vector<std::pair<std::string, std::vector<int>>> groups;
  for (std::size_t r = 0; r < keys.size(); ++r) {
    const std::string key = text_of(keys[r]);
    auto group = groups.begin();
    while (group != groups.end() && group->first != key) ++group;
    if (group == groups.end()) group = groups.insert(group, {key, {}});
    group->second.push_back(static_cast<int>(r));
  }
  if (groups.size() == 1) return "";
  std::string text;
  for (const auto& [key, ranks] : groups) {
    text += "\n" + name_of(ranks) + ": " + text_of(words[static_cast<std::size_t>(ranks[0])]);
  }
  return text;
}

/// Mixes eight bytes at a time, faster than files are read.
class Digest {
 public:
  void add(std::span<const char> bytes) {
    std::size_t at = 0;
    for (; at + 8 <= bytes.size(); at += 8) mix(bytes.subspan(at, 8));
    if (at < bytes.size()) mix(bytes.subspan(at));
  }
  std::uint64_t value() const { return state_; }

 private:
  void mix(std::span<const char> part) {
    std::uint64_t word = part.size();
    std::memcpy(&word, part.data(), part.size());
    state_ = std::rotl(state_ ^ (word * 0x9e3779b97f4a7c15u), 29) * 0xbf58476d1ce4e5b9u;
  }

  std::uint64_t state_ = 0x2545f4914f6cdd1du;
};

/// A file as seen by a rank.
struct SeenFile {
  std::string name;
  std::uint64_t size = 0;
  std::uint64_t digest = 0;  ///< of all that is in it
};

/// Empty for what is no readable file; its reader reports the error.
std::optional<SeenFile> seen_file(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  SeenFile file{path.string()};
  Digest digest;
  std::vector<char> block(std::size_t{1} << 20);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    const auto count = static_cast<std::size_t>(in.gcount());
    digest.add(std::span(block).first(count));
    file.size += count;
  }
  if (in.bad()) return std::nullopt;
  file.digest = digest.value();
  return file;
}

struct RankFile {
  int rank;
  std::uint64_t size, digest;
};

std::vector<std::byte> packed(const std::vector<SeenFile>& files) {
  std::vector<std::byte> bytes;
  const auto put = [&](std::span<const std::byte> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
  };
  for (const SeenFile& file : files) {
    const std::array<std::uint64_t, 3> head = {file.name.size(), file.size, file.digest};
    put(std::as_bytes(std::span(head)));
    put(bytes_of(file.name));
  }
  return bytes;
}

/// The ranks' views of each file, by name.
std::map<std::string, std::vector<RankFile>> files_of(
    const std::vector<std::vector<std::byte>>& of_ranks) {
  std::map<std::string, std::vector<RankFile>> seen;
  for (std::size_t r = 0; r < of_ranks.size(); ++r) {
    std::span<const std::byte> left = of_ranks[r];
    while (!left.empty()) {
      std::array<std::uint64_t, 3> head;
      std::memcpy(head.data(), left.data(), sizeof(head));
      left = left.subspan(sizeof(head));
      const std::string name(reinterpret_cast<const char*>(left.data()), head[0]);
      left = left.subspan(head[0]);
      seen[name].push_back({static_cast<int>(r), head[1], head[2]});
    }
  }
  return seen;
}

/// Describes the first file that differs between ranks; empty if there is none.
std::string difference(const std::map<std::string, std::vector<RankFile>>& seen) {
  for (const auto& [name, files] : seen) {
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<int>> kinds;
    for (const RankFile& file : files) kinds[{file.size, file.digest}].push_back(file.rank);
    if (kinds.size() == 1) continue;
    std::string text = "'" + name + "' is not the same file on all ranks:";
    for (const auto& [kind, ranks] : kinds) {
      text += formatted("\n%s: %llu bytes, digest %016llx", name_of(ranks).c_str(),
                        static_cast<unsigned long long>(kind.first),
                        static_cast<unsigned long long>(kind.second));
    }
    return text + "\nstart all ranks in one folder, or give them copies that are the same";
  }
  return "";
}

}  // namespace

Request request_of(const CLI::App& app, int argc, char** argv) {
  return {std::string(BRINDLE_VERSION) + kEnd + key_of(*app.get_subcommands().front()),
          words_of(argc, argv)};
}

Request request_of(int argc, char** argv) {
  const std::string words = words_of(argc, argv);
  return {std::string(BRINDLE_VERSION) + kEnd + words, words};
}

void check_same_request(Communicator& ranks, const Request& own) {
  const auto keys = ranks.gather(bytes_of(own.key));
  const std::string shown = own.words + " (version " BRINDLE_VERSION ")";
  const auto words = ranks.gather(bytes_of(shown));
  const std::string text =
      text_of_first(ranks, ranks.rank() == 0 ? groups_of(keys, words) : std::string());
  if (text.empty()) return;
  throw CLI::ValidationError("ranks have different words; give all the same ones" + text,
                             CLI::ExitCodes::ValidationError);
}

void check_same_files(Communicator& ranks, const std::vector<fs::path>& own) {
  if (ranks.size() == 1) return;
  std::vector<SeenFile> files;
  for (const fs::path& path : own) {
    if (auto file = seen_file(path)) files.push_back(std::move(*file));
  }
  const auto of_ranks = ranks.gather(packed(files));
  const std::string text =
      text_of_first(ranks, ranks.rank() == 0 ? difference(files_of(of_ranks)) : std::string());
  if (text.empty()) return;
  throw CLI::ValidationError(text, CLI::ExitCodes::ValidationError);
}

}  // namespace brindle::tool
