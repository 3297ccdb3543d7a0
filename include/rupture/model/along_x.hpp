// A property of the interface: one value, or one for each block.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rupture {

template <class T>
class AlongX {
 public:
  // NOLINTNEXTLINE(*-explicit-*): a plain value is given as such
  // cppcheck-suppress noExplicitConstructor
  AlongX(T everywhere) : first_(everywhere) {}
  /// The value of each block. Equal ones are the one value, so that comparisons, files and
  /// checksums know no difference.
  explicit AlongX(std::vector<T> blocks) : first_(blocks.front()), blocks_(std::move(blocks)) {
    if (std::ranges::count(blocks_, first_) == std::ssize(blocks_)) blocks_.clear();
  }

  /// The value of the block in column i. There is no conversion to T: who uses it must say where.
  T operator[](std::int64_t i) const {
    return blocks_.empty() ? first_ : blocks_[static_cast<std::size_t>(i)];
  }
  T largest() const { return varies() ? std::ranges::max(blocks_) : first_; }
  T smallest() const { return varies() ? std::ranges::min(blocks_) : first_; }
  /// As many blocks are above as below; of an even number, the lower one of those in the middle.
  T median() const {
    std::vector<T> sorted = blocks_;
    std::ranges::sort(sorted);
    return varies() ? sorted[(sorted.size() - 1) / 2] : first_;
  }

  bool varies() const { return !blocks_.empty(); }
  const std::vector<T>& blocks() const { return blocks_; }  ///< empty: the same everywhere

  bool operator==(const AlongX&) const = default;

 private:
  T first_;
  std::vector<T> blocks_;
};

}  // namespace rupture
