// Values of options: how they are declared, and numbers such as times and lengths.
#pragma once

#include <boost/optional.hpp>
#include <boost/program_options.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rupture::tools {

namespace po = boost::program_options;

/// The kind of value that an option takes, as --help and --describe say it.
struct ValueKind {
  std::string kind;        ///< number, integer, choice, text, parameter, input file or output file
  std::string name;        ///< such as T or FILE; of a choice its words, as in uniform|bell
  std::string unit = {};   ///< of numbers: SI, "1" for none
  std::string holds = {};  ///< of files, such as "record"
  bool is_in_rebuild = false;  ///< it changes what is written: the file keeps it (run/rebuild.hpp)
  bool (*is_other)(std::string_view) = nullptr;  ///< of numbers: what may stand in their place
};

/// Values for the declarations of options; like those of po::value() they belong to their option.
/// Numbers with a unit may be given in another that in_unit() knows: 10ms is 0.01.
po::typed_value<double>* seconds();
po::typed_value<boost::optional<double>>* seconds_or(const std::string& without);  ///< or no value
po::typed_value<std::vector<double>>* list_of_seconds();
po::typed_value<std::string>* seconds_or_condition();  ///< dynamics/condition.hpp
po::typed_value<double>* number(const std::string& name, const std::string& unit = "1");
po::typed_value<std::string>* number_along_x(
    const std::string& name);  ///< or many, set_parameter()
po::typed_value<int>* integer(const std::string& name);
po::typed_value<std::string>* seed();
po::typed_value<std::string>* one_of(const std::string& words);  ///< such as "uniform|bell"
po::typed_value<std::string>* text(const std::string& name);
po::typed_value<std::vector<std::string>>* assignments();
po::typed_value<std::string>* input_file(const std::string& holds);
po::typed_value<std::string>* output_file(const std::string& holds);

/// The word for options that belong to the command that makes a file anew; without a value, a flag.
template <class T>
po::typed_value<T>* in_rebuild(po::typed_value<T>* value) {
  dynamic_cast<ValueKind&>(*value).is_in_rebuild = true;
  return value;
}
po::value_semantic* in_rebuild();
bool is_in_rebuild(const po::option_description& option);

/// The value of a time, a length or the like. Throws UsageError unless it is finite and >= 0.
double non_negative(const po::variables_map& values, const std::string& option);
double non_negative(double value, const std::string& option);
std::optional<double> optional_non_negative(const po::variables_map& values,
                                            const std::string& option);

/// A whole number. Throws UsageError beyond these limits.
int int_between(const po::variables_map& values, const std::string& option, int least, int most);

/// A pinned fraction, or several with commas between them. Throw UsageError unless they are > 0 and
/// <= 1.
double fraction(const po::variables_map& values, const std::string& option);
std::vector<double> fractions(const po::variables_map& values, const std::string& option);

}  // namespace rupture::tools
