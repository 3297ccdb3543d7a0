#include "rupture/model/laws.hpp"

namespace rupture {

const std::vector<LawInfo>& law_table() {
  static const std::vector<LawInfo> table = {
      {"reference", SpringsPerBlock::N_s, SlowSlip::relaxation, "junctions.f_new to f_slip",
       ClosedForm::known},
      {"simplified", SpringsPerBlock::one, SlowSlip::imposed, "junctions.v_slow to 0",
       ClosedForm::unknown},
      {"decaying", SpringsPerBlock::N_s, SlowSlip::relaxation, "junctions.mu_new to junctions.mu_d",
       ClosedForm::unknown},
  };
  return table;
}

const LawInfo& law_info(Law law) {
  return law_table().at(static_cast<std::size_t>(law));
}

const std::vector<std::string_view>& law_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> found;
    for (const LawInfo& info : law_table()) found.push_back(info.name);
    return found;
  }();
  return names;
}

std::vector<std::string_view> law_names(const std::vector<Law>& laws) {
  std::vector<std::string_view> names;
  for (const Law law : laws) names.push_back(law_info(law).name);
  return names;
}

}  // namespace rupture
