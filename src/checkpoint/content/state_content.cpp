#include "checkpoint/content/state_content.hpp"

#include "checkpoint/content/context.hpp"
#include "checkpoint/content/layout.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/laws.hpp"

namespace rupture {
namespace {

struct FieldRow : Row<double> {
  Field State::*field;
};

constexpr const char* kLattice = "[Nz][Nx]";
constexpr std::array<FieldRow, 6> kFields = {{
    {{"/state/u_x", "m", kLattice}, &State::u_x},
    {{"/state/u_z", "m", kLattice}, &State::u_z},
    {{"/state/v_x", "m/s", kLattice}, &State::v_x},
    {{"/state/v_z", "m/s", kLattice}, &State::v_z},
    {{"/state/f_x", "N", kLattice}, &State::f_x},
    {{"/state/f_z", "N", kLattice}, &State::f_z},
}};

constexpr std::int64_t kLastStep = std::int64_t{1} << 53U;  // beyond it times are not exact

constexpr const char* kSprings = "[Nx][S]";
constexpr Row<std::int64_t> kStep = {"/state/step", "1"};
constexpr Row<std::int64_t> kClockStep = {"/state/clock/origin_step", "1"};
constexpr Row<double> kClockTime = {"/state/clock/origin_time", "s"};
constexpr Row<std::int64_t> kOriginStep = {"/state/drive/origin_step", "1"};
constexpr Row<double> kOriginPosition = {"/state/drive/origin_position", "m"};
constexpr Row<double> kAttachment = {"/state/junctions/attachment", "m", kSprings};
constexpr Row<std::uint8_t> kSlipping = {"/state/junctions/slipping", "1", kSprings};
constexpr Row<double> kRepinTime = {"/state/junctions/repin_time", "s", kSprings};
constexpr Row<std::uint32_t> kDraws = {"/state/junctions/draws", "1", kSprings};

Shape shape_of(Eigen::Index rows, Eigen::Index columns) {
  return {static_cast<std::uint64_t>(rows), static_cast<std::uint64_t>(columns)};
}

template <class T>
Dataset array_dataset(const RowMajorArray<T>& array, std::string_view unit) {
  return make_array(std::span(array.data(), static_cast<std::size_t>(array.size())),
                    shape_of(array.rows(), array.cols()), unit);
}

template <class T>
void put(Content& content, const Row<T>& row, const RowMajorArray<T>& array) {
  content[row.path] = array_dataset(array, row.unit);
}

// Reads a dataset of the shape that the array has.
template <class Array>
void read(const Content& content, const std::string& path, Array&& array) {
  using T = typename std::remove_reference_t<Array>::Scalar;
  const auto values = read_array<T>(content, path, shape_of(array.rows(), array.cols()));
  array = RowMajorArray<T>::Map(values.data(), array.rows(), array.cols());
}

// A pinned junction has no repin time: stored as 0, in memory `never`.
double stored_repin_time(double repin_time) {
  return repin_time == Junctions::never ? 0.0 : repin_time;
}

double repin_time_from(std::uint8_t slipping, double stored, Eigen::Index block,
                       Eigen::Index junction) {
  const bool pinned_as_written = slipping == 0 && stored == 0.0;
  const bool slipping_as_written = slipping == 1 && stored >= 0.0 && is_slipping(stored);
  if (!pinned_as_written && !slipping_as_written) {
    fail(
        "junction {} of block {} has {} = {} and {} = {} s; expected 0 and 0 s if it is pinned, 1 "
        "and a time if it is slipping",
        junction, block, kSlipping.path, slipping, kRepinTime.path, stored);
  }
  return pinned_as_written ? Junctions::never : stored;
}

void read_repin_times(const Content& content, RowMajorArray<double>& repin_time) {
  RowMajorArray<std::uint8_t> slipping(repin_time.rows(), repin_time.cols());
  read(content, kSlipping.path, slipping);
  read(content, kRepinTime.path, repin_time);
  for (Eigen::Index i = 0; i < repin_time.rows(); ++i) {
    for (Eigen::Index j = 0; j < repin_time.cols(); ++j) {
      repin_time(i, j) = repin_time_from(slipping(i, j), repin_time(i, j), i, j);
    }
  }
}

std::string path_of(const SpringMemory& memory) {
  return fmt::format("/state/junctions/{}", memory.name);
}

void check_memory(const SpringMemory& memory, double repin_time, double remembered,
                  Eigen::Index block, Eigen::Index junction) {
  const bool slips_as_written = repin_time == Junctions::unknown && remembered != 0.0;
  if (!(remembered < memory.minimum) && (!is_slipping(repin_time) || slips_as_written)) return;
  fail(
      "junction {} of block {} has {} = {} s and {} = {} {}; expected 0 s and{} another value than "
      "0 if it is slipping",
      junction, block, kRepinTime.path, stored_repin_time(repin_time), path_of(memory), remembered,
      memory.unit, memory.minimum == 0.0 ? ", never below 0," : "");
}

void read_memory(const Content& content, const LawInfo& law, Junctions& junctions) {
  if (!law.memory) return;
  auto& array = junctions.*law.memory->array;
  read(content, path_of(*law.memory), array);
  for (Eigen::Index i = 0; i < array.rows(); ++i) {
    for (Eigen::Index j = 0; j < array.cols(); ++j) {
      check_memory(*law.memory, junctions.repin_time(i, j), array(i, j), i, j);
    }
  }
}

std::int64_t read_step(const Content& content, const Row<std::int64_t>& row, std::int64_t last) {
  const std::int64_t step = value_of(content, row);
  if (step < 0 || step > last) {
    fail("{} = {}; expected 0 or more and at most {}", row.path, step, last);
  }
  return step;
}

// The origin of the clock, which only a state has whose dt was changed.
Clock read_clock(const Content& content, std::int64_t step) {
  if (!content.contains(kClockStep.path) && !content.contains(kClockTime.path)) return {};
  const Clock clock = {read_step(content, kClockStep, step), value_of(content, kClockTime)};
  if (clock.origin_time > 0.0) return clock;
  fail("{} = {} s; expected a time above 0", kClockTime.path, clock.origin_time);
}

}  // namespace

Content state_content(const State& state) {
  Content content;
  put(content, kStep, state.step);
  if (state.clock != Clock{}) {
    put(content, kClockStep, state.clock.origin_step);
    put(content, kClockTime, state.clock.origin_time);
  }
  put(content, kOriginStep, state.drive.origin_step);
  put(content, kOriginPosition, state.drive.origin_position);
  for (const FieldRow& row : kFields) {
    put<double>(content, row, (state.*row.field).blocks());
  }

  const Junctions& junctions = state.junctions;
  const RowMajorArray<std::uint8_t> slipping =
      junctions.repin_time.unaryExpr(&is_slipping).cast<std::uint8_t>();
  put(content, kAttachment, junctions.attachment);
  put(content, kSlipping, slipping);
  put<double>(content, kRepinTime, junctions.repin_time.unaryExpr(&stored_repin_time));
  put(content, kDraws, junctions.draws);
  for (const LawInfo& law : law_table()) {
    if (!law.memory || (junctions.*law.memory->array).size() == 0) continue;
    content[path_of(*law.memory)] = array_dataset(junctions.*law.memory->array, law.memory->unit);
  }
  return content;
}

State read_state(const Content& content, const Parameters& parameters) {
  expect(content, kRepinTime.path, DataType::float64,
         shape_of(parameters.Nx, springs_per_block(parameters)));
  expect(content, kFields[0].path, DataType::float64, shape_of(parameters.Nz, parameters.Nx));
  State state(parameters);
  state.step = read_step(content, kStep, kLastStep);
  state.clock = read_clock(content, state.step);
  state.drive.origin_step = read_step(content, kOriginStep, state.step);
  state.drive.origin_position = value_of(content, kOriginPosition);
  for (const FieldRow& row : kFields) read(content, row.path, (state.*row.field).blocks());
  read(content, kAttachment.path, state.junctions.attachment);
  read_repin_times(content, state.junctions.repin_time);
  read(content, kDraws.path, state.junctions.draws);
  read_memory(content, law_info(parameters.law), state.junctions);
  expect_as_written(content, state_content(state));
  return state;
}

DatasetInfos state_datasets() {
  DatasetInfos all = {kStep,       kClockStep, kClockTime, kOriginStep, kOriginPosition,
                      kAttachment, kSlipping,  kRepinTime, kDraws};
  all.insert(all.end(), kFields.begin(), kFields.end());
  for (const LawInfo& law : law_table()) {
    if (law.memory)
      all.push_back({path_of(*law.memory), "float64", kSprings, std::string(law.memory->unit)});
  }
  return all;
}

}  // namespace rupture
