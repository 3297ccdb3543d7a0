#include "rupture/model/laws.hpp"

namespace rupture {

const std::vector<LawInfo>& law_table() {
  static const std::vector<LawInfo> table = {
      {"reference", SpringsPerBlock::N_s, "junctions.f_new to f_slip"},
      {"simplified", SpringsPerBlock::one, "junctions.v_slow to 0",
       SpringMemory{&Junctions::slow_until, "slow_until", "s", -kNever}},
      {"decaying", SpringsPerBlock::N_s, "junctions.mu_new to junctions.mu_d"},
      {"distance", SpringsPerBlock::N_s, "junctions.f_new to f_slip",
       SpringMemory{&Junctions::slip_left, "slip_left", "m", 0.0}},
  };
  return table;
}

const LawInfo& law_info(Law law) {
  return law_table().at(static_cast<std::size_t>(law));
}

std::vector<std::string_view> law_names(const std::vector<Law>& laws) {
  std::vector<std::string_view> names;
  for (const Law law : laws) names.push_back(law_info(law).name);
  if (!laws.empty()) return names;
  for (const LawInfo& info : law_table()) names.push_back(info.name);
  return names;
}

}  // namespace rupture
