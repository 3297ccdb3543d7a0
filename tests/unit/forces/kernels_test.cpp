// The loops over rows: whatever the length of a row, the number of bands or the instruction set,
// the padding stays zero and the bits stay the same.
#include "rupture/forces/kernels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
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

// --- all instruction sets that this processor can run give the same bits

#if defined(__x86_64__)
constexpr std::array kNames = {"sse2", "avx2", "avx512"};
#elif defined(__aarch64__)
constexpr std::array kNames = {"neon"};
#else
constexpr std::array kNames = {"baseline"};
#endif

/// Everything one variant computes, as bits.
using Bits = std::vector<std::uint64_t>;

void append(Bits& bits, double value) {
  bits.push_back(std::bit_cast<std::uint64_t>(value));
}
void append(Bits& bits, const std::vector<double>& values) {
  for (const double value : values) append(bits, value);
}
void append(Bits& bits, const Field& field) {
  for (Eigen::Index j = 0; j < field.Nz(); ++j) {
    for (Eigen::Index i = 0; i < field.Nx(); ++i) append(bits, field(i, j));
  }
}

/// Twenty steps. Some springs are strained beyond the reach of the series.
Bits bulk_bits(const Kernels& kernels, const Parameters& p) {
  Shaken shaken(p, 0.003);
  State& state = shaken.state;
  Field e_x(p.Nx, p.Nz), e_z(e_x), d_x(e_x), d_z(e_x);
  Bulk bulk(p, 1, kernels);
  Bits bits;
  bulk.half_kick_and_drift(0, state);
  for (int n = 0; n < 20; ++n) {
    bulk.keep_neighbouring_rows(0, state);
    bulk.add_forces_and_half_kick(0, shaken.boundary(), n % 2 == 0 ? Then::go_on : Then::stop,
                                  state);
    if (n % 2 == 1) bulk.half_kick_and_drift(0, state);
    bulk.elastic(state.u_x, state.u_z, e_x, e_z);
    bulk.damping(state, d_x, d_z);
    append(bits, bulk.damping_power());
    for (Eigen::Index i = 0; i < p.Nx; ++i) append(bits, bulk.bottom_velocity()[i]);
    for (const Field* field : fields_of(state)) append(bits, *field);
    for (const Field* field : {&e_x, &e_z, &d_x, &d_z}) append(bits, *field);
  }
  return bits;
}

Bits contact_bits(const Kernels& kernels, std::size_t Nx) {
  Noise noise(1e-5);
  std::vector<double> u_z(Nx), p(Nx), k_ij(Nx), w(Nx), kappa;
  for (double& u : u_z) u = noise();  // pressed or not
  u_z[0] = 0.0;
  u_z[1] = -0.0;
  while (kappa.size() < Nx) kappa.push_back(39.2e9 * static_cast<double>(1 + kappa.size() % 3));
  kernels.contact(static_cast<std::ptrdiff_t>(Nx), u_z.data(), 6.75e6, 100.0, kappa.data(),
                  {p.data(), k_ij.data(), w.data()});
  Bits bits;
  for (const auto& values : {p, k_ij, w}) append(bits, values);
  return bits;
}

Bits trail_bits(const Kernels& kernels, std::size_t N_s) {
  Noise noise(1e-6);
  std::vector<double> attachment(N_s), repin_time(N_s);
  for (double& a : attachment) a = noise();
  for (double& t : repin_time) t = noise() > 0.0 ? 1e-3 : Junctions::never;
  Bits bits;
  append(bits, kernels.trail(static_cast<std::ptrdiff_t>(N_s), -3e-7, 4e-7, repin_time.data(),
                             attachment.data()));
  append(bits, attachment);
  return bits;
}

class InstructionSets : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    found_ = find_kernels(GetParam());
    if (found_ == nullptr) GTEST_SKIP() << "not on this processor or not in this build";
    EXPECT_EQ(found_->name, GetParam());
  }
  const Kernels* found_ = nullptr;
};

TEST_P(InstructionSets, agree_to_the_last_bit_on_the_bulk) {
  for (const Eigen::Index Nx : {3, 4, 5, 6, 7, 8, 9, 10, 15, 16, 17, 20, 63, 64, 65, 66, 130}) {
    const Parameters p = small_slider(Nx, 4), other = with_other_bulk(p);
    EXPECT_EQ(bulk_bits(*found_, p), bulk_bits(kernels(), p)) << Nx << " blocks per row";
    EXPECT_EQ(bulk_bits(*found_, other), bulk_bits(kernels(), other)) << Nx << " blocks per row";
  }
}

TEST_P(InstructionSets, agree_to_the_last_bit_on_the_contact) {
  for (std::size_t Nx = 3; Nx <= 20; ++Nx) {
    EXPECT_EQ(contact_bits(*found_, Nx), contact_bits(kernels(), Nx)) << Nx << " blocks";
  }
}

TEST_P(InstructionSets, agree_to_the_last_bit_on_the_junctions) {
  for (const std::size_t N_s : {1U, 2U, 7U, 8U, 9U, 15U, 16U, 17U, 100U}) {
    EXPECT_EQ(trail_bits(*found_, N_s), trail_bits(kernels(), N_s)) << N_s << " junctions";
  }
}

INSTANTIATE_TEST_SUITE_P(Kernels, InstructionSets, ::testing::ValuesIn(kNames),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace rupture::testing
