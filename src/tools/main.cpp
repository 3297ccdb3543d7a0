// A program that is one command: CMake says which. It does without the header of the command line,
// which takes longer to compile than all else here.
namespace rupture::tools {
struct Command;
extern const Command RUPTURE_PROGRAM;
int run_tool(const Command& command, int argc, const char* const* argv);
}  // namespace rupture::tools

int main(int argc, char** argv) {
  return rupture::tools::run_tool(rupture::tools::RUPTURE_PROGRAM, argc, argv);
}
