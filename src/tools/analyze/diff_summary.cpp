#include "analyze/diff_summary.hpp"

#include <algorithm>
#include <cstdlib>

#include "cli/text.hpp"
#include "run/rebuild.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/parameters_content.hpp"
#include "rupture/checkpoint/provenance.hpp"

namespace rupture::tools {
namespace {

/// A file on the way to another, and its time [s] where the steps tell.
struct Ancestor {
  std::string checksum;
  std::optional<double> time;
};

/// When a step ended that began at `before`.
std::optional<double> time_after(const ProvenanceEntry& step, std::optional<double> before) {
  if (step.tool == "prepare") return 0.0;
  if (step.tool == "modify-phi") return before;
  const auto command = read_rebuild(step.rebuild);
  const auto* const until = command ? command->find("until") : nullptr;
  if (until == nullptr) return std::nullopt;
  return std::strtod(until->value.c_str(), nullptr);
}

/// The file itself, before it that from which it was made, and so on.
std::vector<Ancestor> ancestors(const ContentFile& file) {
  const auto chain = read_provenance(file.content);
  if (chain.empty()) return {};
  std::vector<Ancestor> all = {{chain.front().parent_checksum, std::nullopt}};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const bool last = i + 1 == chain.size();
    all.push_back({last ? file.checksum : chain[i + 1].parent_checksum,
                   time_after(chain[i], all.back().time)});
  }
  std::ranges::reverse(all);
  return all;
}

/// The last file that both come from; null if there is none.
Json ancestor_json(const ContentFile& a, const ContentFile& b) {
  const auto others = ancestors(b);
  for (const auto& [checksum, time] : ancestors(a)) {
    const auto found = std::ranges::find(others, checksum, &Ancestor::checksum);
    if (checksum.empty() || found == others.end()) continue;
    const auto known = time ? time : found->time;
    return {{"checksum", checksum}, {"time", known ? Json(*known) : Json()}};
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
  const Json& time = ancestor["time"];
  return fmt::format(
      "content checksum {}, {}", in_one_line(checksum.substr(0, 12)),
      time.is_null() ? "time unknown" : fmt::format("t = {:.10g} s", time.get<double>()));
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
