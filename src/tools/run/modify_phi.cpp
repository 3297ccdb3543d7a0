// modify-phi: replace the distribution of junction forces in a region, keeping each block's mean.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cli/command_line.hpp"
#include "cli/option_values.hpp"
#include "cli/text.hpp"
#include "run/files.hpp"
#include "run/summary.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace {

using namespace rupture;
using namespace rupture::tools;

struct Options {
  std::string checkpoint;
  PhiChange change;
  OutputOptions output;
  std::vector<std::string> arguments;
  std::string rebuild;
};

Options setup(int argc, char** argv) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("shape", one_of("uniform|bell")->default_value("uniform"), "shape of the new distribution");
  add("sigma-bar", number("S"),
      "its standard deviation over f_thres - f_slip; default: as wide as each block allows");
  add("x-from", number("X", "m")->default_value(0.0, "0"), "change blocks from this x on");
  add("x-to", number("X", "m"), "change blocks up to this x");
  add("slipping", one_of("keep|pin")->default_value("keep"),
      "slipping junctions: keep them slipping, or pin them and include them");
  const po::options_description own = options;
  add_output_options(options, "checkpoint");
  const Parsed parsed = parse(
      argc, argv,
      {"modify-phi",
       "modify-phi CHECKPOINT -o OUT [options]",
       "Replaces the distribution phi(f_T) of the forces in the junctions of some blocks and\n"
       "keeps the mean force of each block, so that the stress state stays the same. Prints the\n"
       "width of each block's phi and the histogram of all changed blocks, before and after.",
       {},
       "replace the distribution of junction forces in a region"},
      options, "checkpoint", UsesParameters::no);
  const auto& values = parsed.values;
  Options result;
  result.checkpoint = single_input(values, "checkpoint", "a checkpoint to modify");
  result.change.shape = shape_named(values["shape"].as<std::string>());
  if (values["slipping"].as<std::string>() == "pin") result.change.slipping = Slipping::pin;
  result.change.sigma_bar = optional_non_negative(values, "sigma-bar");
  result.change.x_from = non_negative(values, "x-from");
  if (const auto x_to = optional_non_negative(values, "x-to")) result.change.x_to = *x_to;
  if (result.change.x_to < result.change.x_from) {
    throw UsageError("the region is empty: --x-to is below --x-from");
  }
  result.output = output_options(values);
  result.arguments = parsed.arguments;
  result.rebuild = shell_line(with_options({"modify-phi"}, own, values));
  return result;
}

/// Largest relative change of a block's friction force [1].
double largest_change(const std::vector<double>& before, const std::vector<double>& after) {
  double largest = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    largest = std::max(largest, std::abs(after[i] - before[i]));
    scale = std::max(scale, std::abs(before[i]));
  }
  return scale > 0.0 ? largest / scale : largest;
}

void print_widths(const PhiSummary& summary, std::FILE* to) {
  say_on(to, "   x [m]   mean/f_thres   slipping   sigma-bar before   after\n");
  for (std::size_t i = 0; i < summary.before.size(); ++i) {
    const auto& b = summary.before[i];
    say_on(to, "{:8.4f}   {:12.4f}   {:8.2f}   {:16.4f}   {:.4f}\n", b.x, b.mean / b.f_thres,
           b.slipping, b.sigma_bar(), summary.after[i].sigma_bar());
  }
}

using Counts = std::vector<std::int64_t>;

void add_histogram(Counts& sum, const BlockForces& block) {
  const Counts counts = histogram(block, static_cast<int>(sum.size()));
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += counts[n];
}

std::string bar(std::int64_t count, std::int64_t largest) {
  constexpr std::int64_t kLongest = 24;
  return std::string(static_cast<std::size_t>((count * kLongest + largest - 1) / largest), '#');
}

/// phi(f_T/f_thres) of the blocks that were changed, all together.
void print_histograms(const PhiSummary& summary, std::FILE* to) {
  constexpr int kBins = 20;
  Counts old_counts(kBins), new_counts(kBins);
  int changed = 0;
  for (std::size_t i = 0; i < summary.before.size(); ++i) {
    if (summary.before[i].forces == summary.after[i].forces) continue;
    ++changed;
    add_histogram(old_counts, summary.before[i]);
    add_histogram(new_counts, summary.after[i]);
  }
  say_on(to, "junctions of the {} changed blocks by the force they carry\n", changed);
  if (changed == 0) return;
  const auto largest = std::max(*std::max_element(old_counts.begin(), old_counts.end()),
                                *std::max_element(new_counts.begin(), new_counts.end()));
  say_on(to, "   f_T/f_thres   before                            after\n");
  for (std::size_t n = 0; n < kBins; ++n) {
    const double low = 2.0 * static_cast<double>(n) / kBins - 1.0;
    const auto line =
        fmt::format("  {:5.2f} {:6.2f} {:8} {:24} {:8} {}", low, low + 2.0 / kBins, old_counts[n],
                    bar(old_counts[n], largest), new_counts[n], bar(new_counts[n], largest));
    say_on(to, "{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  }
}

/// Of the blocks between --x-from and --x-to.
struct Region {
  std::size_t blocks = 0, changed = 0;
};

Region region_of(const std::vector<BlockForces>& before, const PhiChange& change,
                 const std::vector<ImpossibleBlock>& impossible) {
  Region region;
  for (const BlockForces& block : before) {
    if (block.x < change.x_from || block.x > change.x_to) continue;
    ++region.blocks;
    const bool slips = change.slipping == Slipping::keep && block.slipping == 1.0;
    const bool refused = std::any_of(impossible.begin(), impossible.end(),
                                     [&](const auto& other) { return other.x == block.x; });
    if (!slips && !refused) ++region.changed;
  }
  return region;
}

double widest_of(const std::vector<ImpossibleBlock>& blocks) {
  double widest = 0.0;
  for (const auto& block : blocks) widest = std::max(widest, block.largest_sigma_bar);
  return widest;
}

/// Throws if no block was changed: a copy under another name would pass for the new distribution.
void refuse_unchanged(const Parameters& p, const State& before, const PhiChange& change,
                      const std::vector<ImpossibleBlock>& impossible) {
  const Region region = region_of(block_forces(p, before), change, impossible);
  if (region.changed > 0) return;
  if (region.blocks == 0) {
    throw UsageError(
        fmt::format("no block lies between --x-from and --x-to: the blocks are {:g} m apart, from "
                    "x = 0 to {:g} m",
                    block_spacing(p), p.L));
  }
  if (impossible.empty()) {
    throw Failure("all junctions between --x-from and --x-to slip: give --slipping pin");
  }
  throw Failure(
      fmt::format("no block between --x-from and --x-to can have this phi: the widest possible has "
                  "--sigma-bar {:.4f}",
                  std::floor(widest_of(impossible) * 1e4) * 1e-4));
}

void print(const PhiSummary& summary, std::FILE* to) {
  print_widths(summary, to);
  print_histograms(summary, to);
  say_on(to, "largest change of a block's friction force: {:.1e} of the largest friction force\n",
         summary.largest_change);
  for (const auto& block : summary.impossible) {
    say_on(to, "not changed: block at x = {:.4f} m, whose sigma-bar can be at most {:.4f}\n",
           block.x, block.largest_sigma_bar);
  }
  const WrittenFile& file = summary.files.front();
  say_on(to, "{}", wrote_text(file.path, file.checksum));
}

int run(const Options& options) {
  Checkpoint checkpoint = read_checkpoint(options.checkpoint);
  check_outputs({options.output.output}, options.output.if_exists, options.checkpoint);
  const Parameters& p = checkpoint.parameters;
  const State before = checkpoint.state;
  const auto impossible = change_phi(p, checkpoint.state, options.change);
  refuse_unchanged(p, before, options.change, impossible);
  const double change =
      largest_change(friction_forces(p, before), friction_forces(p, checkpoint.state));
  checkpoint.run.reset();  // what follows is not the run that the input came from
  checkpoint.provenance.push_back(
      make_provenance("modify-phi", options.arguments, checkpoint.checksum, options.rebuild));
  const auto checksum = write_checkpoint(options.output.output, checkpoint,
                                         options.output.if_exists, options.output.sum);
  const PhiSummary summary = {.before = block_forces(p, before),
                              .after = block_forces(p, checkpoint.state),
                              .impossible = impossible,
                              .largest_change = change,
                              .files = {{options.output.output, "checkpoint", checksum}}};
  if (options.output.verbosity == Verbosity::normal) print(summary, options.output.text());
  print_if_asked(quantities_of(summary), options.output);
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  return run_tool("modify-phi", [&] { return run(setup(argc, argv)); });
}
