// --profile FILE: properties along the interface, from a table of x.
#pragma once

#include "cli/command_line.hpp"

namespace rupture::tools {

void add_profile_option(po::options_description& options);

/// The parameters of a command line, and the table of --profile, which is read once.
class Profile {
 public:
  /// Throws UsageError, with the file and the row, or Failure if the file cannot be read.
  explicit Profile(const Parsed& parsed);

  /// Sets the parameters: plain values first, then those of the table, then those that --set and
  /// --config give to a part of the interface. Throws UsageError, with the place.
  void apply(Parameters& parameters) const;

  /// An option that may vary along x, of this name: its column, or its own text. Throws UsageError
  /// if it has neither, or is no such text.
  AlongX<double> along_x(const Parameters& parameters, const std::string& option) const;

  struct Column {
    std::string name, unit;  ///< as in the heading
  };
  struct Row {
    int line = 0;
    double x = 0;  ///< [m]
    std::vector<std::string> cells;
  };

 private:
  bool has(std::string_view column) const;
  void read_headings(const std::vector<std::string>& cells);
  void read_row(std::vector<std::string> cells, int line);
  std::string value_at(std::size_t column, std::string_view unit, double x, double rounding) const;
  std::string values_of(std::size_t column, std::string_view unit, const Parameters& p) const;

  const Parsed& parsed_;
  std::string path_;
  std::vector<Column> columns_;  // x is the first; none without --profile
  std::vector<Row> rows_;
};

}  // namespace rupture::tools
