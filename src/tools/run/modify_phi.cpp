// modify-phi: replace the distribution of junction forces in a region, keeping each block's mean.
#include <fmt/core.h>

#include <algorithm>

#include "run/output.hpp"
#include "run/rebuild.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

void add_change_options(po::options_description& options) {
  auto add = options.add_options();
  add("shape", in_rebuild(one_of("uniform|bell")->default_value("uniform")),
      "shape of the new distribution");
  add("sigma-bar", in_rebuild(number("S")),
      "its standard deviation over f_thres - f_slip; default: as wide as each block allows");
  add("x-from", in_rebuild(number("X", "m")->default_value(0.0, "0")),
      "change blocks from this x on");
  add("x-to", in_rebuild(number("X", "m")), "change blocks up to this x");
  add("slipping", in_rebuild(one_of("keep|pin")->default_value("keep")),
      "slipping junctions: keep them slipping, or pin them and include them");
}

PhiChange change_of(const po::variables_map& values) {
  PhiChange change;
  change.shape = shape_named(values["shape"].as<std::string>());
  if (values["slipping"].as<std::string>() == "pin") change.slipping = Slipping::pin;
  change.sigma_bar = optional_non_negative(values, "sigma-bar");
  change.x_from = non_negative(values, "x-from");
  if (const auto x_to = optional_non_negative(values, "x-to")) change.x_to = *x_to;
  if (change.x_to < change.x_from) {
    throw UsageError("the region is empty: --x-to is below --x-from");
  }
  return change;
}

/// What is reported of all blocks, before and after.
struct ChangedPhi {
  std::vector<BlockForces> before = {}, after = {};
  std::vector<ImpossibleBlock> impossible = {};
  double largest_change = 0.0;  ///< of a block's friction force, over the largest of them

  bool has_changed(std::size_t i) const { return before[i].forces != after[i].forces; }
  std::int64_t changed() const {
    std::int64_t blocks = 0;
    for (std::size_t i = 0; i < before.size(); ++i) blocks += has_changed(i) ? 1 : 0;
    return blocks;
  }
};

/// Largest relative change of a block's friction force [1].
double largest_change(const std::vector<double>& before, const std::vector<double>& after) {
  const Eigen::Map<const Eigen::ArrayXd> b(before.data(), std::ssize(before));
  const Eigen::Map<const Eigen::ArrayXd> a(after.data(), std::ssize(after));
  const double largest = (a - b).abs().maxCoeff(), scale = b.abs().maxCoeff();
  return scale > 0.0 ? largest / scale : largest;
}

/// Throws if no block was changed: a copy under another name would pass for the new distribution.
void refuse_unchanged(const Parameters& p, const ChangedPhi& phi, const PhiChange& change) {
  const auto& impossible = phi.impossible;
  bool is_empty = true;
  for (const BlockForces& block : phi.before) {
    if (!change.includes(block.x)) continue;
    is_empty = false;
    const bool slips = change.slipping == Slipping::keep && block.slipping == 1.0;
    if (!slips && std::ranges::count(impossible, block.x, &ImpossibleBlock::x) == 0) return;
  }
  if (is_empty) {
    throw UsageError(
        "no block lies between --x-from and --x-to: the blocks are {:g} m apart, from x = 0 to "
        "{:g} m",
        block_spacing(p), p.L);
  }
  if (impossible.empty()) {
    throw Failure("all junctions between --x-from and --x-to slip: give --slipping pin");
  }
  const double widest =
      std::ranges::max(impossible, {}, &ImpossibleBlock::largest_sigma_bar).largest_sigma_bar;
  throw Failure(
      "no block between --x-from and --x-to can have this phi: the widest possible has --sigma-bar "
      "{:.4f}",
      std::floor(widest * 1e4) * 1e-4);
}

/// What changed, then the table of all blocks.
std::string text_of(const ChangedPhi& phi) {
  const auto mean_width = [&](const std::vector<BlockForces>& blocks) {
    double sum = 0.0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (phi.has_changed(i)) sum += blocks[i].sigma_bar();
    }
    return sum / static_cast<double>(std::max<std::int64_t>(phi.changed(), 1));
  };
  std::string text = fmt::format(
      "changed {} of {} blocks: their mean sigma-bar was {:.4f} and is {:.4f}; friction forces "
      "changed by at most {:.1e} of the largest\n",
      phi.changed(), phi.before.size(), mean_width(phi.before), mean_width(phi.after),
      phi.largest_change);
  for (const auto& block : phi.impossible) {
    text +=
        fmt::format("not changed: block at x = {:.4f} m, whose sigma-bar can be at most {:.4f}\n",
                    block.x, block.largest_sigma_bar);
  }
  text += "   x [m]   mean/f_thres   slipping   sigma-bar before   after\n";
  for (std::size_t i = 0; i < phi.before.size(); ++i) {
    const auto& b = phi.before[i];
    text += fmt::format("{:8.4f}   {:12.4f}   {:8.2f}   {:16.4f}   {:.4f}\n", b.x,
                        b.mean / b.f_thres, b.slipping, b.sigma_bar(), phi.after[i].sigma_bar());
  }
  return text;
}

Quantities row_of(const ImpossibleBlock& block) {
  return {
      {"x", "m", "position of the block", block.x},
      {"largest_sigma_bar", "1", "widest phi that it can have", if_finite(block.largest_sigma_bar)},
  };
}

Quantities quantities_of(const ChangedPhi& phi) {
  const auto width = [](const BlockForces& block) { return if_finite(block.sigma_bar()); };
  List impossible{row_of(ImpossibleBlock{}), {}};
  for (const auto& block : phi.impossible) impossible.elements.push_back(row_of(block));
  return {
      {"x", "m", "position of each interface block", each(phi.before, &BlockForces::x)},
      {"slipping", "1", "fraction of slipping junctions of each block, before",
       each(phi.before, &BlockForces::slipping)},
      {"sigma_bar_before", "1", "width of phi of each block, before", each(phi.before, width)},
      {"sigma_bar_after", "1", "width of phi of each block, after", each(phi.after, width)},
      {"changed", "1", "blocks that were changed", phi.changed()},
      {"largest_change", "1", "largest change of a friction force, over the largest friction force",
       phi.largest_change},
      {"impossible", "", "blocks that cannot have this phi and were not changed", impossible},
  };
}

int modify_phi(const Parsed& parsed) {
  const std::string path = single_input(parsed.values, "checkpoint", "a checkpoint to modify");
  const PhiChange change = change_of(parsed.values);
  const OutputOptions output = output_options(parsed.values);
  const auto command = with_options({"modify-phi"}, add_change_options, parsed.values);

  Checkpoint checkpoint = read_start(path, parsed.values);
  check_output(output, path);
  const Parameters& p = checkpoint.parameters;
  const auto friction = friction_forces(p, checkpoint.state);
  ChangedPhi phi = {.before = block_forces(p, checkpoint.state)};
  phi.impossible = change_phi(p, checkpoint.state, change);
  refuse_unchanged(p, phi, change);
  phi.after = block_forces(p, checkpoint.state);
  phi.largest_change = largest_change(friction, friction_forces(p, checkpoint.state));
  if (checkpoint.run) {  // what follows is another run, in the same event
    checkpoint.run = run_from(p, checkpoint.state.step, std::move(checkpoint.run->event));
  }
  checkpoint.provenance.push_back(
      make_provenance("modify-phi", parsed.arguments, checkpoint.checksum, command.text()));
  return write_and_report(FileKind::checkpoint, checkpoint_content(checkpoint), quantities_of(phi),
                          text_of(phi), output);
}

}  // namespace

constinit const Command modify_phi_command = {
    "modify-phi CHECKPOINT -o OUT",
    "checkpoint",
    "replace the distribution of junction forces in a region",
    "Replaces the distribution phi(f_T) of the forces in the junctions of some blocks and\n"
    "keeps the mean force of each block, so that the stress state stays the same. Prints the\n"
    "width of each block's phi before and after; rupture analyze phi has the histograms.",
    {add_change_options, add_start_options, add_checkpoint_options},
    modify_phi,
    [] { return with_files(quantities_of(ChangedPhi{})); }};

}  // namespace rupture::tools
