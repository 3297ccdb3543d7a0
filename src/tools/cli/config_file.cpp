#include "cli/config_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

/// The parameter that an option sets: --set, --seed, or in an INI file a name of no option.
std::optional<ParameterChange> change_by(const po::option& option, const std::string& where) {
  const std::string value = option.value.empty() ? "" : option.value.front();
  if (option.string_key == "seed") return ParameterChange{"numerics.seed", value, where};
  if (option.unregistered) return ParameterChange{option.string_key, value, where};
  if (option.string_key != "set") return std::nullopt;
  const auto equals = value.find('=');
  if (equals == std::string::npos) {
    throw UsageError(fmt::format("{}--set {} has no '=': write --set NAME=VALUE", where, value));
  }
  return ParameterChange{value.substr(0, equals), value.substr(equals + 1), where};
}

void add_once(ParameterChange change, ParameterChanges& changes) {
  const auto is_same = [&](const auto& other) { return other.name == change.name; };
  if (std::any_of(changes.begin(), changes.end(), is_same)) {
    throw UsageError(fmt::format("{}{} is given twice: give it once", change.where, change.name));
  }
  changes.push_back(std::move(change));
}

/// The text of an INI file, without a byte order mark.
std::string config_text(const std::string& path) {
  constexpr std::size_t longest = 100'000;  // bytes
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) {
    throw Failure(fmt::format(
        "cannot read the configuration file {}; give the path of a readable INI file", path));
  }
  std::string text(longest + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > longest) {
    throw Failure(fmt::format(
        "the configuration file {} is longer than {} bytes; give the path of an INI file", path,
        longest));
  }
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

/// What a line of an INI file gives in the group that is open, or none; it may open another one.
std::vector<po::option> options_in(std::string line, std::string& group,
                                   const po::options_description& options) {
  if (const auto begin = line.find_first_not_of(" \t"); line.substr(0, 1 + begin).ends_with('[')) {
    group = std::exchange(line, "");
  }
  std::istringstream lines(group + "\n" + line);
  return po::parse_config_file(lines, options, /*allow_unregistered=*/true).options;
}

}  // namespace

ParameterChanges changes_by(const po::parsed_options& given) {
  ParameterChanges changes;
  for (const po::option& option : given.options) {
    if (auto change = change_by(option, "")) add_once(*std::move(change), changes);
  }
  return changes;
}

ParameterChanges read_config(const std::string& path, const po::options_description& options,
                             po::variables_map& values) {
  std::istringstream lines(config_text(path));
  ParameterChanges changes;
  po::parsed_options known(&options);
  std::string group, line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string where = fmt::format("{}:{}: ", path, number);
    try {
      for (const po::option& option : options_in(line, group, options)) {
        if (auto change = change_by(option, where)) {
          add_once(*std::move(change), changes);
        } else {
          known.options.push_back(option);
          po::variables_map so_far;  // an impossible value, or a second one, throws
          po::store(known, so_far);
        }
      }
    } catch (const po::invalid_syntax& error) {
      throw UsageError(
          fmt::format("{}{}; write lines NAME = VALUE and [GROUP]", where, error.what()));
    } catch (const po::error& error) {
      throw po::error(where + error.what());
    }
  }
  po::store(known, values);
  return changes;
}

}  // namespace rupture::tools
