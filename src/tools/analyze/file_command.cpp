#include "analyze/file_command.hpp"

namespace rupture::tools {
namespace {

constexpr const char* kFiles = "file";

}  // namespace

Parsed parse_file_command(int argc, const char* const* argv, const std::string& name,
                          const std::string& arguments, const std::string& purpose,
                          const po::options_description& options) {
  return parse(argc, argv,
               {"analyze " + name, "analyze " + name + " " + arguments + " [options]", purpose},
               options, kFiles, UsesParameters::no);
}

std::vector<std::string> files_of(const Parsed& parsed) {
  if (parsed.values.count(kFiles) == 0) return {};
  auto files = parsed.values[kFiles].as<std::vector<std::string>>();
  refuse_empty_names(files);
  return files;
}

std::string file_of(const Parsed& parsed) {
  return single_input(parsed.values, kFiles, "a file");
}

}  // namespace rupture::tools
