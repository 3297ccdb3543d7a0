// analyze diff: where and by how much two files differ.
#include <fmt/core.h>

#include <algorithm>

#include "analyze/analyze.hpp"
#include "analyze/diff_summary.hpp"
#include "cli/text.hpp"

namespace rupture::tools {
namespace {

/// The values of both files at one element of a dataset.
Json element_json(const Dataset& a, const Dataset& b, std::uint64_t index) {
  const auto number = [&](const Dataset& dataset) {
    return std::visit([](auto value) { return Json(value); }, number_at(dataset, index));
  };
  return {{"index", indices_at(a.shape, index)}, {"a", number(a)}, {"b", number(b)}};
}

/// Members of `json` that tell how the values of a dataset differ.
void add_values(Json& json, const Difference& difference, const Dataset& a, const Dataset& b) {
  json["count"] = difference.count;
  if (a.type == DataType::text) {
    for (const auto& [name, dataset] : {std::pair{"a", &a}, std::pair{"b", &b}}) {
      json[name] = read_text({{"text", *dataset}}, "text");
    }
    return;
  }
  const auto add_largest = [&](const char* name, const auto& largest) {
    json[name]["largest"] = largest.value;
    json[name].update(element_json(a, b, largest.index));
  };
  json["first"] = element_json(a, b, difference.first);
  add_largest("absolute", difference.absolute);
  add_largest("relative", difference.relative);
  if (a.type == DataType::float64) add_largest("ulp", difference.ulp);
}

Json difference_json(const Pair& pair, const Difference& difference) {
  const std::string& path = difference.path;
  const Change change = difference.change;
  Json json = {{"path", path}, {"change", name_of(change)}};
  if (change == Change::type || change == Change::shape) {
    for (const auto& [name, content] : {std::pair{"a", &pair.a}, std::pair{"b", &pair.b}}) {
      const Dataset& dataset = content->at(path);
      json[name] = {{"type", type_name(dataset.type)}, {"shape", dataset.shape}};
    }
  }
  if (change == Change::values) add_values(json, difference, pair.a.at(path), pair.b.at(path));
  return json;
}

// --- the text, from the JSON

std::string number_text(const Json& number) {
  return number.is_number_float() ? fmt::format("{}", number.get<double>()) : number.dump();
}

std::string pair_text(const Json& element) {
  return fmt::format("{} and {}", number_text(element["a"]), number_text(element["b"]));
}

/// "[3][17]: 1.5 and 2".
std::string place_text(const Json& element) {
  return shape_text(element["index"]) + ": " + pair_text(element);
}

std::string scalar_text(const Json& json) {
  const double absolute = json["absolute"]["largest"], relative = json["relative"]["largest"];
  return fmt::format(
      "{}, {:.3e} absolute, {:.3e} relative{}\n", pair_text(json["first"]), absolute, relative,
      json.contains("ulp") ? fmt::format(", {} ULP", json["ulp"]["largest"].dump()) : "");
}

std::string array_text(const Json& json, std::uint64_t elements) {
  std::string text = fmt::format("{} of {} differ, the first at {}\n", json["count"].dump(),
                                 elements, place_text(json["first"]));
  for (const char* name : {"absolute", "relative"}) {
    text += fmt::format("    largest {} difference {:.3e} at {}\n", name,
                        json[name]["largest"].get<double>(), place_text(json[name]));
  }
  if (!json.contains("ulp")) return text;
  return text + fmt::format("    largest difference {} ULP at {}\n", json["ulp"]["largest"].dump(),
                            place_text(json["ulp"]));
}

/// What follows the path of a dataset.
std::string difference_text(const Json& json, const Pair& pair) {
  const std::string change = json["change"];
  if (change == "only_in_a") return "only in the first file\n";
  if (change == "only_in_b") return "only in the second file\n";
  if (change != "values") {
    const auto told = [&](const Json& dataset) {
      return change == "type" ? dataset["type"].get<std::string>() : shape_text(dataset["shape"]);
    };
    return fmt::format("{}s differ: {} and {}\n", change, told(json["a"]), told(json["b"]));
  }
  if (!json.contains("first")) {
    const std::string a = json["a"], b = json["b"];
    return in_one_line(fmt::format("'{}' and '{}'", a, b)) + "\n";
  }
  const Shape& shape = pair.a.at(json["path"]).shape;
  return shape.empty() ? scalar_text(json) : array_text(json, element_count(shape));
}

std::string datasets_text(const Json& json, const Pair& pair) {
  const Json& differences = json["differences"];
  std::string text;
  for (const Json& difference : differences) {
    text += in_one_line(difference["path"]) + ": " + difference_text(difference, pair);
  }
  return text +
         fmt::format("{} of {} datasets differ\n", differences.size(), json["datasets"].dump());
}

std::string report_text(const Json& json, const Pair& pair, bool all) {
  if (json["equal"]) return "equal\n";
  return times_text(json["time"]) + (all ? datasets_text(json, pair) : summary_text(json));
}

int compare(const Parsed& parsed) {
  const auto files = files_of(parsed);
  if (files.size() != 2) throw UsageError("diff compares two files (got {})", files.size());
  const ContentFile a = read_file(files[0]), b = read_file(files[1]);
  if ((a.kind == FileKind::checkpoint) != (b.kind == FileKind::checkpoint)) {
    throw Failure("{} is {}, but {} is {}: give two files of the same kind", files[0],
                  kind_text(a.kind), files[1], kind_text(b.kind));
  }
  const Pair pair = {checksummed_part(a.content), checksummed_part(b.content)};
  const auto differences = diff(pair.a, pair.b);
  const auto added = std::ranges::count(differences, Change::only_in_b, &Difference::change);
  Json json = {{"equal", differences.empty()},
               {"datasets", std::ssize(pair.a) + added},  // that at least one of the files holds
               {"time", times_json(a, b)},
               {"differences", Json::array()}};
  for (const auto& d : differences) json["differences"].push_back(difference_json(pair, d));
  const bool all = parsed.values.count("all") > 0;
  if (!all) json.update(summary_json(a, b, pair));
  say("{}",
      parsed.values.count("json") > 0 ? json_text(json) + "\n" : report_text(json, pair, all));
  return differences.empty() ? kDone : kFailed;
}

}  // namespace

constinit const Command diff_command = {
    "analyze diff A B",
    "file",
    "where and by how much two files differ",
    R"(Compares the parameters and the state of two checkpoints, or the series of two records. Like the
content checksum, it ignores parameters that the interface law does not use. It prints the
times of states if they differ, which parameters differ, the last file that both come from and
its time, and how much else differs: of records, from which sample on. With --all it prints for each dataset how many values differ,
the first of them, and the largest difference: absolute, relative and in units in the last
place (ULP), each with its place, [row][column], and the values in A and B.
Exit code 0: equal, 1: different.)",
    {[](po::options_description& options) {
       options.add_options()("all", "print each dataset that differs");
     },
     add_json_option},
    compare};

}  // namespace rupture::tools
