// All instruction sets that this processor can run give the same bits.
#include "rupture/forces/kernels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "rupture/forces/bulk.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

using testing::Noise;

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

/// Twenty steps of a shaken lattice under made-up boundary forces. Some springs are strained beyond
/// the reach of the series.
Bits bulk_bits(const Kernels& kernels, const Parameters& p) {
  State state(p);
  Noise displacements(0.003 * block_spacing(p)), velocities(0.1), forces(30.0);
  displacements.fill(state.u_x);
  displacements.fill(state.u_z);
  velocities.fill(state.v_x);
  velocities.fill(state.v_z);
  std::vector<double> normal(static_cast<std::size_t>(p.Nx)), tau(normal), top(normal);
  for (double& force : normal) force = forces();
  for (double& force : tau) force = forces();
  for (double& force : top) force = forces();
  const Boundary boundary = {normal.data(), tau.data(), top.data(), 1, 55.0};
  Field e_x(p.Nx, p.Nz), e_z(e_x), d_x(e_x), d_z(e_x);
  Bulk bulk(p, 1, kernels);
  Bits bits;
  bulk.kick_drift(0, state);
  for (int n = 0; n < 20; ++n) {
    bulk.prepare(0, state);
    bulk.finish(0, boundary, n % 2 == 0 ? Then::go_on : Then::stop, state);
    if (n % 2 == 1) bulk.kick_drift(0, state);
    bulk.elastic(state.u_x, state.u_z, e_x, e_z);
    bulk.damping(state, d_x, d_z);
    append(bits, bulk.damping_power());
    for (Eigen::Index i = 0; i < p.Nx; ++i) append(bits, bulk.bottom_velocity()[i]);
    for (const Field* field : {&state.u_x, &state.u_z, &state.v_x, &state.v_z, &state.f_x,
                               &state.f_z, &e_x, &e_z, &d_x, &d_z}) {
      append(bits, *field);
    }
  }
  return bits;
}

Bits contact_bits(const Kernels& kernels, std::size_t Nx) {
  Noise noise(1e-5);
  std::vector<double> u_z(Nx), p(Nx), k_ij(Nx), w(Nx);
  for (double& u : u_z) u = noise();  // pressed or not
  u_z[0] = 0.0;
  u_z[1] = -0.0;
  kernels.contact(static_cast<std::ptrdiff_t>(Nx), u_z.data(), 6.75e6, 100.0, 39.2e9,
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
    const Parameters p = testing::small_slider(Nx, 4), other = testing::with_other_bulk(p);
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

TEST(Kernels, of_an_unknown_name_do_not_exist) {
  EXPECT_EQ(find_kernels("mmx"), nullptr);
  EXPECT_EQ(find_kernels(""), nullptr);
}

TEST(Contact, presses_only_below_the_track_and_follows_its_law) {
  const std::vector<double> u_z = {-5e-6, 0.0, 3e-6};
  std::vector<double> p(3), k_ij(3), w(3);
  kernels().contact(3, u_z.data(), 6e6, 100.0, 40e9, {p.data(), k_ij.data(), w.data()});
  EXPECT_DOUBLE_EQ(p[0], 30.0);
  EXPECT_DOUBLE_EQ(k_ij[0], std::sqrt(40e9 * 0.3));
  EXPECT_DOUBLE_EQ(w[0], 0.3 / std::sqrt(40e9 * 0.3));
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(p[i], 0.0);
    EXPECT_EQ(k_ij[i], 0.0);
    EXPECT_EQ(w[i], 0.0);
  }
}

}  // namespace
}  // namespace rupture
