#include "cli/option_values.hpp"

#include <algorithm>
#include <boost/any.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <cmath>
#include <type_traits>

#include "cli/text.hpp"
#include "rupture/dynamics/condition.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/parameters.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture::tools {
namespace {

/// The value, which `given` holds for the option, if it is a pinned fraction.
double pinned_fraction(double value, const auto& given, const std::string& option) {
  if (value > 0.0 && value <= 1.0) return value;
  throw UsageError("--{} must be a pinned fraction, above 0 and at most 1 (got {})", option, given);
}

/// Refuses an option's value; `reason` goes behind the name of the option.
[[noreturn]] void refuse(const std::string& reason) {
  throw po::error_with_option_name("%canonical_option% " + reason);
}

/// The word of a number without its unit.
std::string plain_number(const std::string& word, const std::string& unit) {
  const auto number = in_unit(word, unit);
  if (!number) refuse(fmt::format("{} is not a number{}", word, units_taken(unit)));
  double value = 0.0;
  if (!boost::conversion::try_lexical_convert(*number, value)) {
    refuse(fmt::format("{} is too large", word));
  }
  const bool is_zero = number->find_first_of("123456789") >= number->find_first_of("eE");
  if (value == 0.0 && !is_zero) refuse(fmt::format("{} is too small: give 0 instead", word));
  return *number;
}

/// The words as typed, or for numbers with a unit their plain numbers.
template <class T>
std::vector<std::string> plain(std::vector<std::string> words, const ValueKind& kind) {
  for (std::string& word : words) {
    const bool is_other = kind.is_other != nullptr && kind.is_other(word);
    if (kind.kind == "number" && !is_other) word = plain_number(word, kind.unit);
    if (kind.kind == "input file" && word.empty()) {
      refuse("needs the path of a file (got an empty name)");
    }
    const auto choices = split(kind.name, '|');
    if (kind.kind == "choice" && std::ranges::count(choices, word) == 0) {
      refuse(fmt::format("must be {} (got {})", alternatives(choices), word));
    }
    if constexpr (std::is_same_v<T, int>) {
      if (int value = 0; !boost::conversion::try_lexical_convert(word, value)) {
        refuse(fmt::format("must be a whole number of at most 9 digits (got {})", word));
      }
    }
  }
  return words;
}

template <class T>
class DescribedValue : public po::typed_value<T>, public ValueKind {
 public:
  explicit DescribedValue(ValueKind declared)
      : po::typed_value<T>(nullptr), ValueKind(std::move(declared)) {
    const bool has_unit = !unit.empty() && unit != "1";
    this->value_name(has_unit ? fmt::format("{} [{}]", name, unit) : name);
  }

  void xparse(boost::any& value, const std::vector<std::string>& words) const override {
    po::typed_value<T>::xparse(value, plain<T>(words, *this));
  }
};

template <class T>
po::typed_value<T>* described(ValueKind kind) {
  return new DescribedValue<T>(std::move(kind));
}

class Flag : public po::untyped_value, public ValueKind {
 public:
  Flag() : po::untyped_value(true), ValueKind{"flag", ""} { is_in_rebuild = true; }
};

}  // namespace

po::value_semantic* in_rebuild() {
  return new Flag();
}

bool is_in_rebuild(const po::option_description& option) {
  const auto* const kind = dynamic_cast<const ValueKind*>(option.semantic().get());
  return kind != nullptr && kind->is_in_rebuild;
}

po::typed_value<double>* seconds() {
  return number("T", "s");
}

po::typed_value<boost::optional<double>>* seconds_or(const std::string& without) {
  return described<boost::optional<double>>({"number", "T", "s"})
      ->implicit_value(boost::none, without);
}

po::typed_value<std::vector<double>>* list_of_seconds() {
  return described<std::vector<double>>({"number", "T...", "s"})->multitoken();
}

po::typed_value<std::string>* seconds_or_condition() {
  return described<std::string>({"number", "T/CONDITION", "s", "", false, is_condition});
}

po::typed_value<double>* number(const std::string& name, const std::string& unit) {
  return described<double>({"number", name, unit});
}

po::typed_value<std::string>* number_along_x(const std::string& name) {
  return described<std::string>({"number", name, "1", "", false, is_along_x});
}

po::typed_value<int>* integer(const std::string& name) {
  return described<int>({"integer", name, "1"});
}

po::typed_value<std::string>* seed() {
  return described<std::string>({"integer", "N", "1"});
}

po::typed_value<std::string>* one_of(const std::string& words) {
  return described<std::string>({"choice", words});
}

po::typed_value<std::string>* text(const std::string& name) {
  return described<std::string>({"text", name});
}

po::typed_value<std::vector<std::string>>* assignments() {
  return described<std::vector<std::string>>({"parameter", "NAME=VALUE"})->composing();
}

po::typed_value<std::string>* input_file(const std::string& holds) {
  return described<std::string>({"input file", "FILE", "", holds});
}

po::typed_value<std::string>* output_file(const std::string& holds) {
  return described<std::string>({"output file", "FILE", "", holds});
}

double non_negative(const po::variables_map& values, const std::string& option) {
  return non_negative(values[option].as<double>(), option);
}

double non_negative(double value, const std::string& option) {
  if (!std::isfinite(value)) throw UsageError("--{} must be finite (got {})", option, value);
  if (value >= 0.0) return value;
  throw UsageError("--{} must be 0 or more (got {})", option, value);
}

std::optional<double> optional_non_negative(const po::variables_map& values,
                                            const std::string& option) {
  if (values.count(option) == 0) return std::nullopt;
  return non_negative(values, option);
}

int int_between(const po::variables_map& values, const std::string& option, int least, int most) {
  const int value = values[option].as<int>();
  if (value >= least && value <= most) return value;
  throw UsageError("--{} must be from {} to {} (got {})", option, least, most, value);
}

double fraction(const po::variables_map& values, const std::string& option) {
  const auto value = values[option].as<double>();
  return pinned_fraction(value, value, option);
}

std::vector<double> fractions(const po::variables_map& values, const std::string& option) {
  const auto& text = values[option].as<std::string>();
  std::vector<double> result;
  for (const std::string& word : split(text + ",", ',')) {  // an empty text is refused as well
    double value = 0.0;
    if (!boost::conversion::try_lexical_convert(word, value)) value = 0.0;  // no fraction
    result.push_back(pinned_fraction(value, text, option));
  }
  return result;
}

}  // namespace rupture::tools
