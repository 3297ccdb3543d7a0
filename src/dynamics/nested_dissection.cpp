#include <utility>

#include "statics.hpp"

namespace rupture {
namespace {

/// Columns i_0 to i_1 and rows j_0 to j_1, the ends excluded.
struct Rectangle {
  Eigen::Index i_0, i_1, j_0, j_1;

  Eigen::Index width() const { return i_1 - i_0; }
  Eigen::Index height() const { return j_1 - j_0; }
};

class Dissection {
 public:
  Dissection(Eigen::Index Nx, Eigen::Index Nz)
      : Nx_(Nx), places_(static_cast<std::size_t>(Nx * Nz)) {
    order({0, Nx, 0, Nz});
  }

  std::vector<Eigen::Index> places() && { return std::move(places_); }

 private:
  /// Cuts across the longer side. Springs reach the next column and row, so one line separates.
  void order(const Rectangle& part) {
    if (part.width() <= 2 && part.height() <= 2) return append(part);
    Rectangle before = part, line = part, after = part;
    if (part.width() >= part.height()) {
      before.i_1 = line.i_0 = (part.i_0 + part.i_1) / 2;
      after.i_0 = line.i_1 = line.i_0 + 1;
    } else {
      before.j_1 = line.j_0 = (part.j_0 + part.j_1) / 2;
      after.j_0 = line.j_1 = line.j_0 + 1;
    }
    order(before);
    order(after);
    append(line);
  }

  void append(const Rectangle& part) {
    for (Eigen::Index j = part.j_0; j < part.j_1; ++j) {
      for (Eigen::Index i = part.i_0; i < part.i_1; ++i) {
        places_[static_cast<std::size_t>(j * Nx_ + i)] = next_++;
      }
    }
  }

  Eigen::Index Nx_, next_ = 0;
  std::vector<Eigen::Index> places_;
};

}  // namespace

std::vector<Eigen::Index> nested_dissection(Eigen::Index Nx, Eigen::Index Nz) {
  return Dissection(Nx, Nz).places();
}

}  // namespace rupture
