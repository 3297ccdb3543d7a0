#include "run/ends.hpp"

#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

double arrived_below(const po::variables_map& values) {
  if (values.count("until-quiet") + values.count("until-spanned") == 0) {
    throw UsageError("--arrived-below needs --until-quiet or --until-spanned: give one of them");
  }
  const double limit = fraction(values, "arrived-below");
  if (limit <= kRupturedFraction) return limit;
  throw UsageError("--arrived-below must be at most {}, at which a block ruptures (got {})",
                   kRupturedFraction, limit);
}

}  // namespace

void add_early_end_options(po::options_description& options) {
  auto add = options.add_options();
  add("until-quiet", seconds_or("5 t_R"),
      "stop as soon as no junction has broken for T or an event has spanned the interface");
  add("until-spanned", "stop as soon as an event has spanned the interface");
  add("until-rupture-at", number("X", "m"),
      "stop at the step at which the block nearest to X ruptures");
  add("quiet-time", in_rebuild(seconds()),
      "time without ruptures that separates events; default 5 t_R");
  add("arrived-below", number("F"),
      "with --until-quiet or --until-spanned: once an event has spanned the interface, wait until "
      "less than this fraction of the junctions at the leading edge is pinned; default: 0.3, at "
      "which a block ruptures");
}

bool may_end_early(const po::variables_map& values) {
  return values.count("until-quiet") + values.count("until-spanned") +
             values.count("until-rupture-at") >
         0;
}

EarlyEnd early_end(const po::variables_map& values, const Parameters& p) {
  EarlyEnd end;
  end.spanned = values.count("until-spanned") > 0;
  end.quiet_time = optional_non_negative(values, "quiet-time");
  if (values.count("until-quiet") > 0) {
    const auto quiet = values["until-quiet"].as<boost::optional<double>>();
    end.quiet_steps = steps_in(p, quiet ? non_negative(*quiet, "until-quiet") : quiet_time(p, end));
    end.spanned = true;
  }
  if (values.count("arrived-below") > 0) end.arrived_below = arrived_below(values);
  if (const auto x = optional_non_negative(values, "until-rupture-at")) {
    end.rupture_of = block_at(p, *x, "until-rupture-at");
  }
  return end;
}

}  // namespace rupture::tools
