#include <fmt/format.h>

#include "context.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/error.hpp"

namespace rupture {

ContentFile verify_file(const std::filesystem::path& path, Opening opening) {
  ContentFile file = read_file(path, opening);
  naming(path, [&] {
    switch (file.kind) {
      case FileKind::checkpoint:
        checkpoint_from(file.content);
        return;
      case FileKind::record:
        record_from(file);
        return;
      case FileKind::open_record:
        throw Failure("an unfinished record cannot be verified: its run has not ended");
    }
    throw Failure("a file of this kind cannot be verified by this build");
  });
  return file;
}

}  // namespace rupture
