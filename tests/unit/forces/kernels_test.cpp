// The loops over rows: whatever the length of a row or the number of bands, the padding stays zero
// and the bits stay the same. (golden/ compares the bits of all instruction sets.)
#include "rupture/forces/kernels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "rupture/forces/bulk.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

// Vector loops read and write 2, 4 or 8 blocks at once.
constexpr Eigen::Index kShortest = 3, kLongest = 20;

void expect_zero_padding(const Field& field) {
  for (Eigen::Index j = -1; j <= field.Nz(); ++j) {
    const bool row = j >= 0 && j < field.Nz();
    for (Eigen::Index i = row ? field.Nx() : 0; i < field.stride(); ++i) {
      ASSERT_EQ(field.row(j)[i], 0.0) << i << ", " << j;
    }
  }
}

std::array<const Field*, 6> fields_of(const State& s) {
  return {&s.u_x, &s.u_z, &s.v_x, &s.v_z, &s.f_x, &s.f_z};
}

/// A shaken slider and boundary forces that differ on every block.
struct Shaken {
  explicit Shaken(const Parameters& parameters, double size = 0.01)  // in units of the spacing
      : p(parameters), state(p), normal(static_cast<std::size_t>(p.Nx)), tau(normal), top(normal) {
    Noise displacements(size * block_spacing(p)), velocities(1.0), forces(30.0);
    displacements.fill(state.u_x);
    displacements.fill(state.u_z);
    velocities.fill(state.v_x);
    velocities.fill(state.v_z);
    for (double& force : normal) force = forces();
    for (double& force : tau) force = forces();
    for (double& force : top) force = forces();
  }
  Boundary boundary() const { return {normal.data(), tau.data(), top.data(), 1, 55.0}; }

  Parameters p;
  State state;
  std::vector<double> normal, tau, top;
};

/// With either bulk, for each height.
std::vector<Shaken> shaken(Eigen::Index Nx, const std::vector<Eigen::Index>& heights) {
  std::vector<Shaken> sliders;
  for (const Eigen::Index Nz : heights) {
    sliders.emplace_back(small_slider(Nx, Nz));
    sliders.emplace_back(with_other_bulk(small_slider(Nx, Nz)));
  }
  return sliders;
}

TEST(RowLengths, leave_the_padding_zero) {
  for (Eigen::Index Nx = kShortest; Nx <= kLongest; ++Nx) {
    SCOPED_TRACE(Nx);
    for (Shaken s : shaken(Nx, {4})) {
      Bulk bulk(s.p);
      Field f_x(s.p.Nx, s.p.Nz), f_z(f_x);
      for (const Then then : {Then::stop, Then::go_on, Then::stop}) {
        bulk.half_kick_and_drift(0, s.state);
        bulk.keep_neighbouring_rows(0, s.state);
        bulk.add_forces_and_half_kick(0, s.boundary(), then, s.state);
        for (const Field* field : fields_of(s.state)) expect_zero_padding(*field);
        bulk.elastic(s.state.u_x, s.state.u_z, f_x, f_z);
        expect_zero_padding(f_x);
        expect_zero_padding(f_z);
        bulk.damping(s.state, f_x, f_z);
        expect_zero_padding(f_x);
        expect_zero_padding(f_z);
      }
    }
  }
}

/// Three steps with the rows in `bands` bands, which are worked on in turn.
State three_steps(Shaken s, int bands, Then between) {
  Bulk bulk(s.p, bands);
  EXPECT_LE(bulk.bands(), bands);
  const auto each_band = [&](const auto& work) {
    for (int band = bulk.bands() - 1; band >= 0; --band) work(band);
  };
  each_band([&](int band) { bulk.half_kick_and_drift(band, s.state); });
  for (int n = 0; n < 3; ++n) {
    const Then then = n < 2 ? between : Then::stop;
    each_band([&](int band) { bulk.keep_neighbouring_rows(band, s.state); });
    each_band([&](int band) { bulk.add_forces_and_half_kick(band, s.boundary(), then, s.state); });
    if (n < 2 && then == Then::stop) {
      each_band([&](int band) { bulk.half_kick_and_drift(band, s.state); });
    }
  }
  return s.state;
}

TEST(Bands, and_steps_in_one_sweep_change_no_bit) {
  const auto expect_same = [](Eigen::Index Nx, Eigen::Index Nz, int most_bands) {
    for (const Shaken& s : shaken(Nx, {Nz})) {
      const State whole = three_steps(s, 1, Then::stop);
      for (int bands = 1; bands <= most_bands; ++bands) {
        const State banded = three_steps(s, bands, Then::go_on);
        for (std::size_t n = 0; n < 6; ++n) {
          EXPECT_TRUE((fields_of(banded)[n]->blocks() == fields_of(whole)[n]->blocks()).all()) << n;
        }
      }
    }
  };
  for (Eigen::Index Nx = kShortest; Nx <= kLongest; ++Nx) expect_same(Nx, 5, 1);
  for (const Eigen::Index Nx : {9, 70, 130}) expect_same(Nx, 7, 9);  // in one chunk, two and three
}

}  // namespace rupture::testing
