#include "cli/report.hpp"

#include <variant>

namespace rupture::tools {

std::string json_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json json_of(const Parameters& parameters, const ParameterInfo& info) {
  if (!choices(info).empty()) return parameter_text(parameters, info);
  return std::visit([&](auto member) { return Json(parameters.*member); }, info.member);
}

}  // namespace rupture::tools
