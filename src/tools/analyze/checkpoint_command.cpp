#include "analyze/checkpoint_command.hpp"

#include "cli/quantity.hpp"

namespace rupture::tools {

CheckpointCommand read_checkpoint_command(int argc, const char* const* argv,
                                          const std::string& name, const std::string& purpose,
                                          po::options_description& options) {
  add_format_options(options);
  Parsed parsed =
      parse(argc, argv, {"analyze " + name, "analyze " + name + " CHECKPOINT [options]", purpose},
            options, "checkpoint", UsesParameters::no);
  const auto path = single_input(parsed.values, "checkpoint", "a checkpoint");
  return {std::move(parsed), read_checkpoint(path)};
}

}  // namespace rupture::tools
