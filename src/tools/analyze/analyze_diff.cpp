// analyze diff: where and by how much two files differ.
#include <fmt/core.h>

#include <algorithm>

#include "analyze/analyze.hpp"
#include "analyze/inputs.hpp"
#include "cli/report.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/compare.hpp"
#include "rupture/checkpoint/file.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

struct Pair {
  Content a, b;
};

/// A dataset that both files hold, under different values.
struct Differing {
  const Difference& difference;
  const Dataset& a;
  const Dataset& b;

  bool is_text() const { return a.type == DataType::text; }
  bool has_ulp() const { return a.type == DataType::float64; }
};

Differing differing(const Pair& pair, const Difference& difference) {
  return {difference, pair.a.at(difference.path), pair.b.at(difference.path)};
}

std::string text_of(const Dataset& dataset) {
  return read_text({{"text", dataset}}, "text");
}

std::string number_text(const Dataset& dataset, std::uint64_t index) {
  return std::visit([](auto number) { return fmt::format("{}", number); },
                    number_at(dataset, index));
}

Json number_json(const Dataset& dataset, std::uint64_t index) {
  return std::visit([](auto number) { return Json(number); }, number_at(dataset, index));
}

std::string pair_text(const Differing& d, std::uint64_t index) {
  return fmt::format("{} and {}", number_text(d.a, index), number_text(d.b, index));
}

/// "[3][17]: 1.5 and 2".
std::string place_text(const Differing& d, std::uint64_t index) {
  return shape_text(indices_at(d.a.shape, index)) + ": " + pair_text(d, index);
}

std::string scalar_text(const Differing& d) {
  const Difference& found = d.difference;
  return fmt::format("{}, {:.3e} absolute, {:.3e} relative{}\n", pair_text(d, 0),
                     found.absolute.value, found.relative.value,
                     d.has_ulp() ? fmt::format(", {} ULP", found.ulp.value) : "");
}

std::string array_text(const Differing& d) {
  const Difference& found = d.difference;
  std::string text = fmt::format("{} of {} differ, the first at {}\n", found.count,
                                 element_count(d.a.shape), place_text(d, found.first));
  text += fmt::format("    largest absolute difference {:.3e} at {}\n", found.absolute.value,
                      place_text(d, found.absolute.index));
  text += fmt::format("    largest relative difference {:.3e} at {}\n", found.relative.value,
                      place_text(d, found.relative.index));
  if (d.has_ulp()) {
    text += fmt::format("    largest difference {} ULP at {}\n", found.ulp.value,
                        place_text(d, found.ulp.index));
  }
  return text;
}

std::string values_text(const Differing& d) {
  if (d.is_text()) {
    return in_one_line(fmt::format("'{}' and '{}'", text_of(d.a), text_of(d.b))) + "\n";
  }
  return d.a.shape.empty() ? scalar_text(d) : array_text(d);
}

std::string change_text(const Pair& pair, const Difference& difference) {
  const std::string& path = difference.path;
  switch (difference.change) {
    case Change::only_in_a:
      return "only in the first file\n";
    case Change::only_in_b:
      return "only in the second file\n";
    case Change::type:
      return fmt::format("types differ: {} and {}\n", type_name(pair.a.at(path).type),
                         type_name(pair.b.at(path).type));
    case Change::shape:
      return fmt::format("shapes differ: {} and {}\n", shape_text(pair.a.at(path).shape),
                         shape_text(pair.b.at(path).shape));
    case Change::values:
      break;
  }
  return values_text(differing(pair, difference));
}

template <class T>
Json largest_json(const Differing& d, const Largest<T>& largest) {
  return {{"largest", largest.value},
          {"index", indices_at(d.a.shape, largest.index)},
          {"a", number_json(d.a, largest.index)},
          {"b", number_json(d.b, largest.index)}};
}

Json change_json(const Pair& pair, const Difference& difference) {
  const std::string& path = difference.path;
  Json json = {{"path", path}, {"change", name_of(difference.change)}};
  if (difference.change == Change::type || difference.change == Change::shape) {
    for (const auto& [name, content] : {std::pair{"a", &pair.a}, std::pair{"b", &pair.b}}) {
      const Dataset& dataset = content->at(path);
      json[name] = {{"type", type_name(dataset.type)}, {"shape", dataset.shape}};
    }
  }
  if (difference.change != Change::values) return json;
  const Differing d = differing(pair, difference);
  json["count"] = difference.count;
  if (d.is_text()) {
    json.update({{"a", text_of(d.a)}, {"b", text_of(d.b)}});
    return json;
  }
  json["first"] = {{"index", indices_at(d.a.shape, difference.first)},
                   {"a", number_json(d.a, difference.first)},
                   {"b", number_json(d.b, difference.first)}};
  json["absolute"] = largest_json(d, difference.absolute);
  json["relative"] = largest_json(d, difference.relative);
  if (d.has_ulp()) json["ulp"] = largest_json(d, difference.ulp);
  return json;
}

/// Number of datasets that at least one of the files holds.
std::size_t dataset_count(const Pair& pair, const std::vector<Difference>& differences) {
  const auto added = std::count_if(differences.begin(), differences.end(),
                                   [](const auto& d) { return d.change == Change::only_in_b; });
  return pair.a.size() + static_cast<std::size_t>(added);
}

std::string report_text(const Pair& pair, const std::vector<Difference>& differences,
                        std::size_t cut) {
  std::string text;
  for (const auto& difference : differences) {
    text += in_one_line(difference.path) + ": " + change_text(pair, difference);
  }
  if (cut > 0) text += fmt::format("{} arrays were compared in the rows that both have\n", cut);
  if (differences.empty()) return text + "equal\n";
  return text + fmt::format("{} of {} datasets differ\n", differences.size(),
                            dataset_count(pair, differences));
}

int compare(const Parsed& parsed) {
  const auto files = files_of(parsed);
  if (files.size() != 2) {
    throw UsageError(fmt::format("two files are needed; got {}", files.size()));
  }
  const ContentFile a = read_file(files[0]), b = read_file(files[1]);
  if ((a.kind == FileKind::checkpoint) != (b.kind == FileKind::checkpoint)) {
    throw Failure(fmt::format("{} is {}, but {} is {}: give two files of the same kind", files[0],
                              kind_text(a.kind), files[1], kind_text(b.kind)));
  }
  Pair pair = {checksummed_part(a.content), checksummed_part(b.content)};
  const std::size_t cut = parsed.values.count("common") > 0 ? keep_common_rows(pair.a, pair.b) : 0;
  const auto differences = diff(pair.a, pair.b);
  if (parsed.values.count("json") > 0) {
    Json json = {{"equal", differences.empty()},
                 {"datasets", dataset_count(pair, differences)},
                 {"cut", cut},
                 {"differences", Json::array()}};
    for (const auto& d : differences) json["differences"].push_back(change_json(pair, d));
    say("{}\n", json_text(json));
  } else {
    say("{}", report_text(pair, differences, cut));
  }
  return differences.empty() ? kDone : kFailed;
}

}  // namespace

constinit const Command diff_command = {
    "analyze diff A B",
    "file",
    "where and by how much two files differ",
    R"(Compares the parameters and the state of two checkpoints, or the series of two records, dataset
by dataset. Like the content checksum, it ignores parameters that the interface law does not
use. It prints how many values differ, the first of them, and the largest difference: absolute,
relative and in units in the last place (ULP), each with its place, [row][column], and the
values in A and B. Exit code 0: equal, 1: different.)",
    {[](po::options_description& options) {
       options.add_options()("common",
                             "if one record is longer, compare only the rows that both have");
     },
     add_json_option},
    compare};

}  // namespace rupture::tools
