#include "rupture/analysis/phi.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/laws.hpp"
#include "rupture/model/normal_contact.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture {
namespace {

BlockForces forces_of(const Parameters& p, const State& state, Eigen::Index i) {
  const double p_i = NormalContact(p, i).normal_force(state.u_z(i, 0));
  const auto springs = static_cast<double>(springs_per_block(p));
  BlockForces block;
  block.x = block_position(p, i);
  block.k_ij = static_cast<double>(p.N_s) / springs * junction_stiffness(p, i, p_i);
  block.f_thres = p.mu_s[i] * p_i / springs;
  block.f_slip = p.mu_d[i] * p_i / springs;
  block.slipping = 1.0 - pinned_fraction(state.junctions, i);
  for (const double attachment : state.junctions.attachment.row(i)) {
    block.forces.push_back(block.k_ij * (state.u_x(i, 0) - attachment));
  }
  block.mean = std::accumulate(block.forces.begin(), block.forces.end(), 0.0) / springs;
  double squares = 0.0;
  for (const double f : block.forces) squares += (f - block.mean) * (f - block.mean);
  block.sigma = std::sqrt(squares / springs);
  return block;
}

/// Indices of the junctions of block i that change, ordered by the force they carry now.
std::vector<Eigen::Index> changing(const Junctions& junctions, Eigen::Index i, Slipping slipping) {
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index j = 0; j < junctions.attachment.cols(); ++j) {
    if (slipping == Slipping::pin || !is_slipping(junctions.repin_time(i, j))) chosen.push_back(j);
  }
  std::stable_sort(chosen.begin(), chosen.end(), [&](Eigen::Index a, Eigen::Index b) {
    return junctions.attachment(i, a) > junctions.attachment(i, b);
  });
  return chosen;
}

/// Sets the chosen junctions of block i to mean + half_width * quantiles; returns what stopped it,
/// if anything.
std::optional<ImpossibleBlock> spread(State& state, Eigen::Index i, const BlockForces& block,
                                      const PhiChange& change) {
  Junctions& junctions = state.junctions;
  const auto chosen = changing(junctions, i, change.slipping);
  if (chosen.empty()) return std::nullopt;
  double sum = 0.0;
  for (const Eigen::Index j : chosen) sum += block.forces[static_cast<std::size_t>(j)];
  const double mean = sum / static_cast<double>(chosen.size());
  const double room = block.f_thres - std::abs(mean);
  const double range = block.f_thres - block.f_slip;
  const double half_width =
      change.sigma_bar ? *change.sigma_bar * range / unit_sigma(change.shape) : room;
  if (room < 0.0 || half_width > room) {
    return ImpossibleBlock{block.x, std::max(room, 0.0) * unit_sigma(change.shape) / range};
  }
  const auto quantiles = unit_quantiles(change.shape, static_cast<std::int64_t>(chosen.size()));
  for (std::size_t n = 0; n < chosen.size(); ++n) {
    const double force = mean + half_width * quantiles[n];
    junctions.attachment(i, chosen[n]) = state.u_x(i, 0) - force / block.k_ij;
    junctions.repin_time(i, chosen[n]) = Junctions::never;
  }
  return std::nullopt;
}

}  // namespace

void refuse_single_springs(const Parameters& p) {
  const LawInfo& law = law_info(p.law);
  if (law.springs == SpringsPerBlock::N_s) return;
  std::vector<std::string_view> others;
  for (const LawInfo& other : law_table()) {
    if (other.springs == SpringsPerBlock::N_s) others.push_back(other.name);
  }
  throw Failure(
      "the checkpoint has junctions.law = {}: a single spring per block has no "
      "distribution of forces; use a checkpoint of the {} law",
      law.name, alternatives(others));
}

std::vector<double> normal_forces(const Parameters& p, const State& state) {
  std::vector<double> forces;
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    forces.push_back(NormalContact(p, i).normal_force(state.u_z(i, 0)));
  }
  return forces;
}

std::vector<double> friction_forces(const Parameters& p, const State& state) {
  std::vector<double> friction;
  for (const BlockForces& block : block_forces(p, state)) {
    friction.push_back(std::accumulate(block.forces.begin(), block.forces.end(), 0.0));
  }
  return friction;
}

std::vector<BlockForces> block_forces(const Parameters& p, const State& state) {
  std::vector<BlockForces> blocks;
  for (Eigen::Index i = 0; i < p.Nx; ++i) blocks.push_back(forces_of(p, state, i));
  return blocks;
}

std::vector<std::int64_t> histogram(const BlockForces& block, int bins) {
  std::vector<std::int64_t> counts(static_cast<std::size_t>(bins));
  for (const double f : block.forces) {
    const double position = (f / block.f_thres + 1.0) / 2.0 * bins;
    const double bin = std::max(0.0, std::min(position, bins - 1.0));  // 0 if it is not a number
    ++counts[static_cast<std::size_t>(bin)];
  }
  return counts;
}

std::vector<ImpossibleBlock> change_phi(const Parameters& p, State& state,
                                        const PhiChange& change) {
  refuse_single_springs(p);
  std::vector<ImpossibleBlock> impossible;
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const BlockForces block = forces_of(p, state, i);
    if (!change.includes(block.x)) continue;
    if (block.f_thres <= 0.0) {  // not pressed
      impossible.push_back({block.x, 0.0});
    } else if (const auto stopped = spread(state, i, block, change)) {
      impossible.push_back(*stopped);
    }
  }
  return impossible;
}

}  // namespace rupture
