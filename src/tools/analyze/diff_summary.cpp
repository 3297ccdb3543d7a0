#include "analyze/diff_summary.hpp"

#include <algorithm>

#include "cli/text.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/parameters_content.hpp"
#include "rupture/checkpoint/provenance.hpp"

namespace rupture::tools {
namespace {

/// Checksums of the file itself, of that from which it was made before it, and so on.
std::vector<std::string> ancestors(const ContentFile& file) {
  std::vector<std::string> all = {file.checksum};
  const auto chain = read_provenance(file.content);
  for (auto step = chain.rbegin(); step != chain.rend(); ++step) {
    all.push_back(step->parent_checksum);
  }
  return all;
}

/// The last file that both come from; null if there is none.
Json ancestor_json(const ContentFile& a, const ContentFile& b) {
  const auto others = ancestors(b);
  for (const std::string& checksum : ancestors(a)) {
    if (!checksum.empty() && std::ranges::count(others, checksum) > 0) {
      return {{"checksum", checksum}};
    }
  }
  return nullptr;
}

/// The parameters that differ and that the laws use.
Json parameters_json(const ContentFile& a, const ContentFile& b) {
  const Parameters of_a = read_parameters(a.content), of_b = read_parameters(b.content);
  Json list = Json::array();
  for (const auto& info : parameter_table()) {
    const std::string text = used_text(of_a, info), other = used_text(of_b, info);
    if (text != other) list.push_back({{"name", info.name}, {"a", text}, {"b", other}});
  }
  return list;
}

/// The first sample of two records, of those that both have, in which a series differs; null if
/// none does.
Json first_sample_json(Pair pair) {
  const auto is_other = [](const auto& entry) { return !entry.first.starts_with("/series/"); };
  std::erase_if(pair.a, is_other);
  std::erase_if(pair.b, is_other);
  keep_common_rows(pair.a, pair.b);
  std::optional<std::uint64_t> sample;
  for (const Difference& difference : diff(pair.a, pair.b)) {
    if (difference.change != Change::values) continue;
    const Shape& shape = pair.a.at(difference.path).shape;
    const std::uint64_t row = difference.first / (element_count(shape) / shape[0]);
    sample = std::min(sample.value_or(row), row);
  }
  if (!sample) return nullptr;
  return {{"sample", *sample}, {"time", element<double>(pair.a.at("/series/time"), *sample)}};
}

std::string parameters_line(const Json& parameters) {
  std::vector<std::string> texts;
  for (const Json& one : parameters) {
    const std::string name = one["name"], a = one["a"], b = one["b"];
    texts.push_back(fmt::format("{} = {} and {}", name, a, b));
  }
  return texts.empty() ? "none" : in_one_line(fmt::format("{}", fmt::join(texts, "; ")));
}

std::string ancestor_line(const Json& ancestor) {
  if (ancestor.is_null()) return "none that the steps of both name";
  const std::string checksum = ancestor["checksum"];
  return "content checksum " + in_one_line(checksum.substr(0, 12));
}

std::string differences_line(const Json& report) {
  const Json &differences = report["differences"], &sample = report["first_sample"];
  std::string text =
      fmt::format("{} of {} datasets", differences.size(), report["datasets"].dump());
  if (!sample.is_null()) {
    return text + fmt::format(", the series from t = {:.10g} s on (sample {})",
                              sample["time"].get<double>(), sample["sample"].dump());
  }
  for (const Json& one : differences) {
    if (one["path"] != "/state/u_x" || !one.contains("absolute")) continue;
    const Json& most = one["absolute"];
    text += fmt::format(", /state/u_x by at most {:.4g} m, at {}", most["largest"].get<double>(),
                        shape_text(most["index"]));
  }
  return text;
}

}  // namespace

Json times_json(const ContentFile& a, const ContentFile& b) {
  if (a.kind != FileKind::checkpoint) return nullptr;
  const auto time_of = [](const ContentFile& file) {
    const Checkpoint checkpoint = checkpoint_from(file.content);
    return time(checkpoint.parameters, checkpoint.state);
  };
  return {{"a", time_of(a)}, {"b", time_of(b)}};
}

std::string times_text(const Json& times) {
  if (times.is_null() || times["a"] == times["b"]) return "";
  return fmt::format("different times: t = {:.10g} s and {:.10g} s\n", times["a"].get<double>(),
                     times["b"].get<double>());
}

Json summary_json(const ContentFile& a, const ContentFile& b, const Pair& pair) {
  return {{"parameters", parameters_json(a, b)},
          {"ancestor", ancestor_json(a, b)},
          {"first_sample", first_sample_json(pair)}};
}

std::string summary_text(const Json& report) {
  return fmt::format("parameters that differ: {}\ncommon ancestor: {}\nwhat differs: {}\n",
                     parameters_line(report["parameters"]), ancestor_line(report["ancestor"]),
                     differences_line(report));
}

}  // namespace rupture::tools
