#include "rupture/checkpoint/verify.hpp"

#include "checkpoint/content/context.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"

namespace rupture {

ContentFile verify_file(const std::filesystem::path& path) {
  ContentFile file = read_file(path);
  naming(path, [&] {
    if (file.kind == FileKind::open_record) {
      throw Failure(
          "an unfinished record cannot be verified: its run is still going on or was killed; "
          "rupture finish {} -o NEW.h5 makes a record of it",
          path.string());
    }
    if (file.kind == FileKind::record) {
      record_from(file);
    } else {
      checkpoint_from(file.content);
    }
  });
  return file;
}

Content checked_content(const EditedFile& file, const ProvenanceEntry& entry) {
  Content content = file.content;  // what follows is not the run that wrote the file
  std::erase_if(content, [](const auto& item) { return item.first.starts_with("/run/"); });
  return naming(file.name, [&] {
    if (file.kind == FileKind::checkpoint) {
      Checkpoint checkpoint = checkpoint_from(content);
      checkpoint.provenance.push_back(entry);
      return checkpoint_content(checkpoint);
    }
    Record record = record_from({FileKind::record, "", content});
    record.provenance.push_back(entry);
    Content sealed = provenance_content(record.provenance);
    sealed.merge(parameters_content(record.parameters));
    sealed.merge(content);
    return sealed;
  });
}

}  // namespace rupture
