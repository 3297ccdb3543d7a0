// Shared by the checkpoint tests: a folder that vanishes, a small checkpoint and samples of a
// record.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/checkpoint/verify.hpp"
#include "rupture/model/error.hpp"
#include "support/files.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

namespace fs = std::filesystem;

/// A fresh folder per test.
class InFolder : public ::testing::Test {
 protected:
  fs::path file(const std::string& name) const { return folder_.file(name); }

  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      found.push_back(entry.path().filename().string());
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  const Folder folder_;
};

inline void spill(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

inline std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

inline void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}

/// 5 x 4 blocks with 3 junctions each.
inline Parameters small_parameters() {
  Parameters parameters;
  parameters.L = 0.04;
  parameters.H = 0.03;
  parameters.Nx = 5;
  parameters.Nz = 4;
  parameters.h = 0.01;
  parameters.N_s = 3;
  parameters.f_new = NewForce::f_slip;
  parameters.E /= 4;  // for such a time step
  parameters.dt = 1e-5;
  parameters.V = 1e-3;
  return parameters;
}

inline Checkpoint small_checkpoint() {
  Checkpoint checkpoint;
  checkpoint.parameters = small_parameters();
  checkpoint.state = State(checkpoint.parameters);
  checkpoint.state.step = 1234567;
  checkpoint.state.drive = {1000, 1.0 / 3.0};
  Noise(1e-6).fill(checkpoint.state.u_x);
  checkpoint.provenance = {{"load", "0.1.0", "abc", "load -o x.h5", "gcc 12.2.0", ""},
                           {"restart", "0.1.0", "abc", "restart 'my x.h5'", "gcc 12.2.0",
                            content_checksum(checkpoint_content(checkpoint))}};
  return checkpoint;
}

/// Sample number n of a record with small_parameters(); every value but `pinned` differs from every
/// other one.
inline Sample small_sample(std::size_t Nx, int n) {
  Sample sample;
  sample.time = 0.001 * n;
  sample.step = std::int64_t{100} * n;
  sample.F_T = 7.0 + n;
  sample.x_drive = 1e-6 * n;
  for (std::size_t i = 0; i < Nx; ++i) {
    const double value = n + static_cast<double>(i) / 16.0;
    sample.pinned.push_back(static_cast<std::uint16_t>(2 + (static_cast<std::size_t>(n) + i) % 2));
    sample.p.push_back(value);
    sample.tau.push_back(-value);
    sample.u_x.push_back(1e-6 * value);
  }
  return sample;
}

}  // namespace rupture::testing
