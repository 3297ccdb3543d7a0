#include "rupture/checkpoint/checkpoint.hpp"

#include "checkpoint/content/context.hpp"
#include "checkpoint/content/state_content.hpp"

namespace rupture {

Content checkpoint_content(const Checkpoint& checkpoint) {
  refuse_other_parameters(checkpoint.state, checkpoint.parameters);
  Content content = parameters_content(checkpoint.parameters);
  content.merge(state_content(checkpoint.state));
  content.merge(provenance_content(checkpoint.provenance));
  if (checkpoint.run) content.merge(run_content(*checkpoint.run));
  if (!checkpoint.alarm.empty()) content[kAlarmPath] = make_text(checkpoint.alarm);
  return content;
}

std::string write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint,
                             IfExists if_exists) {
  return write_content(path, FileKind::checkpoint, checkpoint_content(checkpoint), if_exists);
}

Checkpoint checkpoint_from(const Content& content) {
  Checkpoint checkpoint;
  checkpoint.parameters = read_parameters(content);
  checkpoint.state = read_state(content, checkpoint.parameters);
  checkpoint.provenance = read_provenance(content);
  checkpoint.run = read_run(content, checkpoint.parameters, checkpoint.state.step);
  if (content.contains(kAlarmPath)) checkpoint.alarm = read_text(content, kAlarmPath);
  refuse_others(content, "", checkpoint_content(checkpoint),
                "is not part of a checkpoint: use a newer rupture, or remove it if another "
                "program added it");
  return checkpoint;
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  const ContentFile file = read_file(path, FileKind::checkpoint);
  Checkpoint checkpoint = naming(path, [&] { return checkpoint_from(file.content); });
  checkpoint.checksum = file.checksum;
  return checkpoint;
}

void refuse_state_of_alarm(const Checkpoint& checkpoint, const std::filesystem::path& path,
                           std::string_view otherwise) {
  if (checkpoint.alarm.empty()) return;
  throw Failure(
      "an alarm stopped a run in the state of {}, which means nothing (see rupture analyze show): "
      "start from an earlier checkpoint{}",
      path.string(), otherwise);
}

}  // namespace rupture
