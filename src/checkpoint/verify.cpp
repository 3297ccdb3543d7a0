#include "rupture/checkpoint/verify.hpp"

#include <string_view>

#include "context.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/laws.hpp"

namespace rupture {
namespace {

// The parameters and the states of all laws, for their units.
Content parameters_and_states() {
  Content all = parameters_content(Parameters{});
  for (const std::string_view law : law_names()) {
    Parameters parameters;
    set_parameter(parameters, "junctions.law", std::string(law));
    State state(parameters);
    state.clock.origin_step = 1;
    all.merge(state_content(state));
  }
  return all;
}

// Other programs lose the attribute when they replace a dataset. What it says is known.
void add_missing_units(Content& content) {
  const Content known = parameters_and_states();
  for (auto& [path, dataset] : content) {
    if (!dataset.unit.empty()) continue;
    const auto found = known.find(path);
    dataset.unit = found == known.end() ? "1" : found->second.unit;
  }
}

// What follows is not the run that wrote the file.
Content without_run(Content content) {
  std::erase_if(content, [](const auto& item) { return item.first.starts_with("/run/"); });
  return content;
}

Content checked_checkpoint(Content content, const ProvenanceEntry& entry) {
  add_missing_units(content);
  Checkpoint checkpoint = checkpoint_from(content);
  checkpoint.provenance.push_back(entry);
  return checkpoint_content(checkpoint);
}

Content checked_record(Content content, const ProvenanceEntry& entry) {
  auto chain = record_from({FileKind::record, "", "", content}).provenance;
  chain.push_back(entry);
  Content sealed = provenance_content(chain);
  sealed.merge(content);
  return sealed;
}

}  // namespace

ContentFile verify_file(const std::filesystem::path& path, Opening opening) {
  ContentFile file = read_file(path, opening);
  naming(path, [&] {
    if (file.kind == FileKind::open_record) {
      throw Failure("an unfinished record cannot be verified: its run has not ended");
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
  return naming(file.name, [&] {
    return file.kind == FileKind::checkpoint ? checked_checkpoint(without_run(file.content), entry)
                                             : checked_record(without_run(file.content), entry);
  });
}

}  // namespace rupture
