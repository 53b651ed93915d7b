#include "ranks/request.h"

#include <bit>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <span>
#include <string_view>

#include <CLI/CLI.hpp>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/progress.h"
#include "brindle/version.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& word) {
  const bool plain = word.find_first_of(" '\"\n\t") == std::string::npos && !word.empty();
  return plain ? word : "'" + word + "'";
}

std::string command_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += quoted(word) + " ";
  return line + "(version " BRINDLE_VERSION ")";
}

/// Without the options that every rank may choose for itself.
std::vector<std::string> without_own_options(const std::vector<std::string>& words) {
  std::vector<std::string> shared;
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (*word == "--quiet" || *word == "-q") continue;
    const std::string name = word->substr(0, word->find('='));
    if (name != "--threads" && name != "--stall-limit") {
      shared.push_back(*word);
    } else if (name == *word && std::next(word) != words.end()) {
      ++word;  // its value
    }
  }
  return shared;
}

/// All ranks' texts, on rank 0.
std::vector<std::string> gathered(Communicator& ranks, const std::string& own) {
  std::vector<std::string> texts;
  for (const auto& bytes : ranks.gather(std::as_bytes(std::span(own)))) {
    texts.emplace_back(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  return texts;
}

[[noreturn]] void refuse_request(const std::string& why) {
  throw CLI::ValidationError(why, CLI::ExitCodes::ValidationError);
}

/// Throws on all ranks unless rank 0's text is empty.
void refuse_on_all(Communicator& ranks, const std::string& why) {
  const std::vector<char> of_first = ranks.of_first(std::vector<char>(why.begin(), why.end()));
  if (!of_first.empty()) refuse_request({of_first.begin(), of_first.end()});
}

/// Size and digest of a file, faster than files are read; empty for what is no readable file, whose
/// reader reports the error.
std::string seen_file(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return "";
  std::ifstream in(path, std::ios::binary);
  std::uint64_t size = 0, digest = 0x2545f4914f6cdd1du;
  std::vector<char> block(std::size_t{1} << 20);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    const auto count = static_cast<std::size_t>(in.gcount());
    size += count;
    for (std::size_t at = 0; at < count; at += 8) {
      const std::size_t part = std::min<std::size_t>(8, count - at);
      std::uint64_t word = part;
      std::memcpy(&word, &block[at], part);
      digest = std::rotl(digest ^ (word * 0x9e3779b97f4a7c15u), 29) * 0xbf58476d1ce4e5b9u;
    }
  }
  if (in.bad()) return "";
  return formatted("%llu bytes, digest %016llx", static_cast<unsigned long long>(size),
                   static_cast<unsigned long long>(digest));
}

/// A file as a rank sees it.
struct SeenBy {
  std::size_t rank;
  std::string seen;
};

/// Describes the first file that two ranks see differently. `of_ranks` has a list of names and what
/// is seen, each with a null character behind it.
std::string difference(const std::vector<std::string>& of_ranks) {
  std::map<std::string, SeenBy> first;
  for (std::size_t rank = 0; rank < of_ranks.size(); ++rank) {
    std::string_view left = of_ranks[rank];
    const auto next = [&left] {
      const std::string word(left.substr(0, left.find('\0')));
      left.remove_prefix(word.size() + 1);
      return word;
    };
    while (!left.empty()) {
      const std::string name = next(), seen = next();
      const auto [known, is_new] = first.emplace(name, SeenBy{rank, seen});
      if (is_new || known->second.seen == seen) continue;
      return "'" + name + "' is not the same file on all ranks:" +
             formatted("\nrank %zu: %s\nrank %zu: %s", known->second.rank,
                       known->second.seen.c_str(), rank, seen.c_str()) +
             "\nstart all ranks in one folder, or give them copies that are the same";
    }
  }
  return "";
}

}  // namespace

void throw_usage_on_all(Communicator& ranks, const std::function<void()>& work) {
  bool wrong_usage = false;
  try {
    ranks.throw_on_all([&] {
      try {
        work();
      } catch (const CLI::ParseError& error) {
        wrong_usage = true;
        throw Error(error.what());
      }
    });
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    if (ranks.any(wrong_usage)) refuse_request(error.what());
    throw;
  }
}

void on_first_rank(Communicator& ranks, const std::function<void()>& work) {
  throw_usage_on_all(ranks, [&] {
    if (ranks.rank() == 0) work();
  });
}

void check_same_words(Communicator& ranks, const std::vector<std::string>& words) {
  const std::vector<std::string> shared = gathered(ranks, command_line(without_own_options(words)));
  const std::vector<std::string> all = gathered(ranks, command_line(words));
  std::string why;
  for (std::size_t r = 1; r < all.size() && why.empty(); ++r) {
    if (shared[r] == shared[0]) continue;
    why = "ranks have different words; give all the same ones\nrank 0: " + all[0] +
          formatted("\nrank %zu: ", r) + all[r];
  }
  refuse_on_all(ranks, why);
}

void check_same_files(Communicator& ranks, const std::vector<fs::path>& own) {
  if (ranks.size() == 1) return;
  std::string seen;
  for (const fs::path& path : own) {
    const std::string file = seen_file(path);
    if (!file.empty()) seen += path.string() + '\0' + file + '\0';
  }
  refuse_on_all(ranks, difference(gathered(ranks, seen)));
}

}  // namespace brindle::tool
