// A program that is one command: CMake says which.
#include "cli/command_line.hpp"

namespace rupture::tools {
extern const Command RUPTURE_PROGRAM;
}

int main(int argc, char** argv) {
  return rupture::tools::run_tool(rupture::tools::RUPTURE_PROGRAM, argc, argv);
}
