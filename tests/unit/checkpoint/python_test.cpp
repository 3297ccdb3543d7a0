// Other programs can read our files, and recompute their checksum with h5py alone.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "fixtures.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPython = "/usr/bin/python3";

const fs::path kSources = fs::path(__FILE__).parent_path() / "../../..";

// The ```python block of the page that follows this heading.
std::string python_of(const std::string& page, const std::string& heading) {
  const std::string fence = "```python\n";
  const std::size_t start = page.find(fence, page.find("\n" + heading + "\n")) + fence.size();
  return page.substr(start, page.find("```", start) - start);
}

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string output(4096, '\0');
  output.resize(fread(output.data(), 1, output.size(), pipe.get()));
  return output;
}

bool has_module(const std::string& name) {
  return output_of(std::string(kPython) + " -c 'import " + name + "; print(1)' 2>&1") == "1\n";
}

class Python : public testing::InFolder {
 protected:
  void SetUp() override {
    if (!fs::exists(kSources / "python")) GTEST_SKIP() << "the sources are elsewhere";
    if (!has_module("h5py")) GTEST_SKIP() << kPython << " has no h5py";
    const std::string page = testing::slurp(kSources / "docs/schema.md");
    testing::spill(file("labels.py"), python_of(page, "#### Labels"));
    testing::spill(file("pieces.py"), python_of(page, "#### While it grows"));
  }
  // What a script prints about a file.
  std::string said(const fs::path& script, const char* name) {
    return output_of(fmt::format("PYTHONPATH={}/python {} -B {} {} 2>&1", kSources.string(),
                                 kPython, script.string(), file(name).string()));
  }
  std::string output(const char* script, const char* name) { return said(file(script), name); }
  std::string recomputed(const char* name) {
    return said(kSources / "tests/support/checksum.py", name);
  }
};

// All parameters of laws, and all later ones, are away from their defaults, of which the law uses
// some.
TEST_F(Python, recomputes_the_checksum_under_each_law) {
  for (const Law law : testing::kAllLaws) {
    Checkpoint checkpoint;
    for (const ParameterInfo& info : parameter_table()) {
      if (info.laws.empty() && info.since != Since::later) continue;
      set_parameter(checkpoint.parameters, info.name,
                    info.valid.words.empty() ? "0.01" : info.valid.words.back());
    }
    checkpoint.parameters.law = law;
    checkpoint.state = State(checkpoint.parameters);
    checkpoint.state.u_x(1, 0) = -5e-324;
    const std::string checksum = write_checkpoint(file("x.h5"), checkpoint, IfExists::replace);
    EXPECT_EQ(recomputed("x.h5"), checksum + "\n");
  }
}

TEST_F(Python, recomputes_the_checksum_of_a_file_of_schema_2) {
  const fs::path kept =
      fs::path(__FILE__).parent_path() / "../../compatibility/schema-2/simplified.h5";
  fs::copy_file(kept, file("old.h5"));
  EXPECT_EQ(recomputed("old.h5"), read_file(kept).stored_checksum + "\n");
}

TEST_F(Python, recomputes_the_checksum_of_a_record) {
  RecordWriter out(file("r.h5"), testing::small_parameters(), {}, IfExists::refuse, {}, 4);
  for (int n = 0; n < 10; ++n) out.append(testing::small_sample(5, n));
  const std::string checksum = out.finish();
  EXPECT_EQ(recomputed("r.h5"), checksum + "\n");
}

// Python's xarray finds named dimensions, positions and units: once as docs/schema.md shows it, and
// in all groups.
class Xarray : public Python {
 protected:
  void SetUp() override {
    Python::SetUp();
    if (IsSkipped()) return;
    for (const char* module : {"xarray", "h5netcdf"}) {
      if (!has_module(module)) GTEST_SKIP() << "install python3-" << module << " to run this test";
    }
    RecordWriter out(file("r.h5"), testing::small_parameters(), {}, IfExists::refuse, {}, 4,
                     {.crossing_levels = {0.5}, .fields = Fields::record});
    for (int n = 0; n < 10; ++n) out.append(testing::small_sample(5, n));
    std::vector<float> u_x(20);
    u_x[13] = 0.5F;  // row 2, block 3
    out.append(FieldSample{0.004, 400, u_x, std::vector<float>(20)});
    out.append(std::vector<Rupture>{{200, 0.002, 3}, {300, 0.003, 4, 0.5}});
    out.finish();
  }
  std::string shown(const std::string& group, const std::string& what) {
    testing::spill(file("show.py"),
                   "import sys, warnings, xarray\n"
                   "warnings.simplefilter('error')\n"
                   "d = xarray.open_dataset(sys.argv[1], group='" +
                       group + "', engine='h5netcdf')\nprint(" + what + ")\n");
    return output("show.py", "r.h5");
  }
};

TEST_F(Xarray, opens_the_series_as_the_schema_page_shows) {
  EXPECT_EQ(output("labels.py", "r.h5"), "Frozen({'time': 10, 'x': 5}) N\n-9.125\n");
}

TEST_F(Xarray, finds_dimensions_positions_and_units) {
  EXPECT_EQ(shown("series", "d.pinned.dims, d.F_T.dims, *d.x.values, d.time.dtype"),
            "('time', 'x') ('time',) 0.0 0.01 0.02 0.03 0.04 float64\n");
  EXPECT_EQ(
      shown("series", "d.x.attrs['units'], d.u_x.attrs['long_name'], d.pinned.attrs['units']"),
      "m displacement of the block along x 1\n");
  EXPECT_EQ(shown("series", "*[n for n in d.variables if 'long_name' not in d[n].attrs]"), "\n");
  EXPECT_EQ(shown("ruptures", "dict(d.sizes), d.block.values, d.block.time.item()"),
            "{'time': 1} [3] 0.002\n");
  EXPECT_EQ(shown("crossings", "dict(d.sizes), d.levels.values, d.pinned_below.dims"),
            "{'time': 1, 'levels': 1} [0.5] ('time',)\n");
  EXPECT_EQ(shown("fields",
                  "d.u_z.dims, d.u_z.dtype, d.u_x.sel(time=0.004, z=0.02, "
                  "x=0.03, method='nearest').item(), d.step.values"),
            "('time', 'z', 'x') float32 0.5 [400]\n");
  EXPECT_EQ(recomputed("r.h5"), read_file(file("r.h5")).checksum + "\n");
}

TEST_F(Python, reads_a_record_in_the_making) {
  RecordWriter out(file("r.h5"), testing::small_parameters(), {}, IfExists::refuse, {}, 4);
  for (int n = 0; n < 10; ++n) out.append(testing::small_sample(5, n));
  EXPECT_EQ(output("pieces.py", "r.h5.part"), "8 samples\n");
}

TEST_F(Python, opens_a_record_in_the_making_while_it_is_written) {
  RecordWriter out(file("r.h5"), testing::small_parameters(), {}, IfExists::refuse, {}, 4);
  for (int n = 0; n < 4; ++n) out.append(testing::small_sample(5, n));
  testing::spill(file("first.py"),
                 "import h5py, sys\n"
                 "f = h5py.File(sys.argv[1], 'r')\n"
                 "print(f['parameters/slider/Nx'][()], f['series/time'].shape)\n"
                 "print('rupture finish' in f.attrs['note'].decode())\n");
  EXPECT_EQ(output("first.py", "r.h5.part"), "5 (0,)\nTrue\n");
}

TEST_F(Python, reads_values_units_and_attributes) {
  write_checkpoint(file("x.h5"), testing::small_checkpoint(), IfExists::refuse);
  testing::spill(
      file("show.py"),
      "import h5py, sys\n"
      "f = h5py.File(sys.argv[1])\n"
      "print(f.attrs['format'].decode(), f.attrs['schema_version'])\n"
      "print(f['parameters/slider/L'][()], f['parameters/slider/L'].attrs['unit'].decode())\n"
      "print(f['state/junctions/draws'][4, 2], f['state/u_x'].shape)\n");
  EXPECT_EQ(output("show.py", "x.h5"), "rupture-checkpoint 3\n0.04 m\n402 (4, 5)\n");
}

}  // namespace
}  // namespace rupture
