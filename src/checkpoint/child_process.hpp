// Work that may crash, done in a process of its own.
#pragma once

#include <functional>

namespace rupture {

struct ChildEnd {
  int code = 0;    ///< what its work returned, 0 to 255; kThrew if it threw
  int signal = 0;  ///< that ended it; 0 if none did
  static constexpr int kThrew = 255;
};

/// Runs `work` in a copy of this process, which prints nothing, writes no core, and is ended after
/// four minutes of processor time. Throws MachineFailure if there is none to be had.
ChildEnd in_child_process(const std::function<int()>& work);

}  // namespace rupture
