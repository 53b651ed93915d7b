/// Gathers distributed rows on rank 0.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/types.h"

namespace brindle {

/// The number of rows of every rank. Rows are sent directly; all functions but accessors are
/// collective.
class PartsOnFirst {
 public:
  /// Keeps a reference to `ranks`.
  PartsOnFirst(Communicator& ranks, std::size_t own) : ranks_(&ranks) {
    for (const std::size_t count : ranks.all(own)) {
      first_.push_back(first_.back() + static_cast<Index>(count));
    }
  }

  /// The rows of rank r are first(r) .. first(r + 1) - 1 of all.
  Index first(int rank) const { return first_[static_cast<std::size_t>(rank)]; }
  Index count() const { return first_.back(); }

  /// `all` receives all ranks' rows, rank by rank; empty on other ranks than the first.
  template <class T>
  void gather(std::span<const T> own, std::vector<T>& all) const {
    all.resize(ranks_->rank() == 0 ? count() : 0);
    const Outgoing outgoing{0, std::as_bytes(own)};
    std::vector<Incoming> incoming;
    for (int r = 0; ranks_->rank() == 0 && r < ranks_->size(); ++r) {
      incoming.push_back({r, std::as_writable_bytes(part(std::span(all), r))});
    }
    ranks_->transfer({&outgoing, 1}, incoming);
  }

  /// The reverse.
  template <class T>
  void scatter(std::span<const T> all, std::span<T> own) const {
    std::vector<Outgoing> outgoing;
    for (int r = 0; ranks_->rank() == 0 && r < ranks_->size(); ++r) {
      outgoing.push_back({r, std::as_bytes(part(all, r))});
    }
    const Incoming incoming{0, std::as_writable_bytes(own)};
    ranks_->transfer(outgoing, {&incoming, 1});
  }

 private:
  template <class T>
  std::span<T> part(std::span<T> all, int r) const {
    return all.subspan(first(r), first(r + 1) - first(r));
  }

  Communicator* ranks_;
  std::vector<Index> first_{0};
};

}  // namespace brindle
