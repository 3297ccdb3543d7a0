// --resume: by what a run knows its files; what it does with them is in tables/resume.txt.
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/checkpoint/verify.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

using Resume = ToolTest;

constexpr const char* kRun =
    "load --config small.ini -o x.h5 --until 4e-4 --checkpoint-every 1e-4 --record r.h5 "
    "--record-every 3e-5";

TEST_F(Resume, knows_its_checkpoints_by_their_id) {
  output_of(kRun);
  for (const char* later : {"x.h5", "x-t0.000400000.h5"}) fs::remove(path(later));
  Checkpoint foreign = read_checkpoint(path("x-t0.000300000.h5"));
  EXPECT_EQ(foreign.run->id.size(), 64U);
  EXPECT_EQ(foreign.run->id, read_checkpoint(path("x-t0.000100000.h5")).run->id);
  foreign.run->id = std::string(64, '0');
  write_checkpoint(path("x-t0.000300000.h5"), foreign, IfExists::replace);
  EXPECT_NE(output_of(std::string(kRun) + " --resume --force").find("resuming from x-t0.000200000"),
            std::string::npos);
}

TEST_F(Resume, knows_its_record_by_the_id_of_the_run_and_the_intervals) {
  output_of(std::string(kRun) + " --fields 1e-4");
  const std::string id = read_checkpoint(path("x.h5")).run->id;
  EXPECT_EQ(read_record(path("r.h5")).run, (RecordedRun{id, 3e-5, 1e-4}));
  EditedFile edited;
  edited.kind = FileKind::record;
  edited.content = read_content(path("r.h5"));
  EXPECT_FALSE(checked_content(edited, {}).contains("/run/id")) << "it is not the run's any more";
}

}  // namespace
}  // namespace rupture::testing
