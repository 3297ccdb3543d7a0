// One scalar field on the lattice of blocks.
//
// Storage is row by row with unit stride along x. Each row is padded to a multiple of eight values
// with at least one zero behind its last block, and one row of zeros lies below and above, so that
// the force loops read neighbours without asking whether they exist. Padding stays zero for ever.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <new>
#include <vector>

namespace rupture {

// Memory that starts on a cache line, so that no vector of eight doubles straddles two.

template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  CacheLineAllocator() = default;
  template <class U>
  explicit(false) CacheLineAllocator(const CacheLineAllocator<U>&) {}

  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
  void deallocate(T* memory, std::size_t) { ::operator delete(memory, alignment); }
  bool operator==(const CacheLineAllocator&) const = default;
};

using AlignedVector = std::vector<double, CacheLineAllocator<double>>;

template <class T>
using RowMajorArray = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class Field {
 public:
  using View = Eigen::Map<RowMajorArray<double>, 0, Eigen::OuterStride<>>;
  using ConstView = Eigen::Map<const RowMajorArray<double>, 0, Eigen::OuterStride<>>;

  Field() = default;
  Field(Eigen::Index Nx, Eigen::Index Nz)
      : Nx_(Nx),
        Nz_(Nz),
        stride_((Nx + 8) / 8 * 8),
        values_(static_cast<std::size_t>((Nz + 2) * stride_ + 2 * kMargin), 0.0) {}

  Eigen::Index Nx() const { return Nx_; }
  Eigen::Index Nz() const { return Nz_; }
  Eigen::Index stride() const { return stride_; }

  /// Value at block i = 0..Nx-1 (from the driven side) of row j = 0..Nz-1 (from the interface).
  double& operator()(Eigen::Index i, Eigen::Index j) { return row(j)[i]; }
  double operator()(Eigen::Index i, Eigen::Index j) const { return row(j)[i]; }

  /// First block of row j; rows -1 and Nz are padding.
  double* row(Eigen::Index j) { return values_.data() + kMargin + (j + 1) * stride_; }
  const double* row(Eigen::Index j) const { return values_.data() + kMargin + (j + 1) * stride_; }

  /// The blocks without padding, shape [Nz][Nx].
  View blocks() { return {row(0), Nz_, Nx_, Eigen::OuterStride<>(stride_)}; }
  ConstView blocks() const { return {row(0), Nz_, Nx_, Eigen::OuterStride<>(stride_)}; }

 private:
  static constexpr Eigen::Index kMargin = 8;  // room in front for reading at i = -1
  Eigen::Index Nx_ = 0, Nz_ = 0, stride_ = 0;
  AlignedVector values_;
};

}  // namespace rupture
