#include "rupture/model/field.hpp"

namespace rupture {

Field::Field(Eigen::Index Nx, Eigen::Index Nz)
    : Nx_(Nx),
      Nz_(Nz),
      stride_((Nx + 8) / 8 * 8),
      values_(static_cast<std::size_t>((Nz + 2) * stride_ + 2 * kMargin), 0.0) {}

}  // namespace rupture
