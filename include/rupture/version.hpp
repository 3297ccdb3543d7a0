// What was built. Both are in a source of their own, which CMake writes before each build: a commit
// recompiles nothing else.
#pragma once

namespace rupture {

extern const char* const version;  ///< such as "1.2.0"
extern const char* const commit;   ///< of the sources; ends with "-dirty" if they were changed

}  // namespace rupture
