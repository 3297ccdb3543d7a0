// One row per dataset of a record, by which its writer and its reader go; and what it holds
// besides.
#pragma once

#include <tuple>

#include "rupture/checkpoint/record_content.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::record_layout {

inline constexpr const char* kSeriesGroup = "/series/";
inline constexpr const char* kRupturesGroup = "/ruptures/";
inline constexpr const char* kCrossingsGroup = "/crossings/";
inline constexpr const char* kFieldsGroup = "/fields/";
inline constexpr const char* kCrossingLevels = "/crossings/levels";  // those asked for

/// A dataset with a row per sample of the series or of the fields, per rupture, or per crossing of
/// another pinned fraction.
template <class Member, class InRecord = std::nullptr_t>
struct Column {
  const char* path;
  const char* unit;
  const char* long_name;         // in the words of CF: what a plot writes along its axis
  Member member;                 // of what is appended
  InRecord in_record = nullptr;  // of series: the member of Record
};
template <class Member, class InRecord = std::nullptr_t>
Column(const char*, const char*, const char*, Member, InRecord = nullptr)
    -> Column<Member, InRecord>;

inline constexpr std::tuple kSeries = {
    Column{"/series/time", "s", "time", &Sample::time, &Record::time},
    Column{"/series/step", "1", "time step", &Sample::step, &Record::step},
    Column{"/series/F_T", "N", "driving force", &Sample::F_T, &Record::F_T},
    Column{"/series/x_drive", "m", "position of the driving point", &Sample::x_drive,
           &Record::x_drive},
    Column{"/series/pinned", "1", "pinned junctions of the block", &Sample::pinned,
           &Record::pinned},
    Column{"/series/p", "N", "normal force on the block", &Sample::p, &Record::p},
    Column{"/series/tau", "N", "friction force on the block, towards -x", &Sample::tau,
           &Record::tau},
    Column{"/series/u_x", "m", "displacement of the block along x", &Sample::u_x, &Record::u_x},
};

inline constexpr std::tuple kRuptures = {
    Column{"/ruptures/step", "1", "time step of the rupture", &Rupture::step},
    Column{"/ruptures/time", "s", "time of the rupture", &Rupture::time},
    Column{"/ruptures/block", "1", "block, from 0 at the driven side", &Rupture::block},
};

inline constexpr std::tuple kCrossings = {
    Column{"/crossings/step", "1", "time step of the crossing", &Rupture::step},
    Column{"/crossings/time", "s", "time of the crossing", &Rupture::time},
    Column{"/crossings/block", "1", "block, from 0 at the driven side", &Rupture::block},
    Column{"/crossings/pinned_below", "1", "pinned fraction that the block fell below",
           &Rupture::pinned_below},
};

inline constexpr std::tuple kFields = {
    Column{"/fields/step", "1", "time step", &FieldSample::step},
    Column{"/fields/time", "s", "time", &FieldSample::time},
    Column{"/fields/u_x", "m", "displacement of the block along x", &FieldSample::u_x},
    Column{"/fields/u_z", "m", "displacement of the block along z", &FieldSample::u_z},
};

/// The values of a row of such a dataset, and their type.
template <class T>
std::span<const T> values_of(const T& value) {
  return {&value, 1};
}
template <class T>
std::span<const T> values_of(const std::vector<T>& values) {
  return values;
}
DataType type_of(const auto& entry) {
  return kDataTypeOf<typename decltype(values_of(entry))::value_type>;
}

/// Shape of so many rows of such a dataset: a value per row,
Shape shape_of(const auto&, std::uint64_t rows, const Parameters&) {
  return {rows};
}
/// one per interface block,
template <class T>
Shape shape_of(const std::vector<T>&, std::uint64_t rows, const Parameters& p) {
  return {rows, static_cast<std::uint64_t>(p.Nx)};
}
/// or one per block of the slider.
inline Shape shape_of(const std::vector<float>&, std::uint64_t rows, const Parameters& p) {
  return {rows, static_cast<std::uint64_t>(p.Nz), static_cast<std::uint64_t>(p.Nx)};
}

/// The values along a dimension: where the blocks are, which follows from the parameters and is
/// there for other programs, or the pinned fractions whose crossings are recorded.
struct Scale {
  const char* path;
  const char* unit;
  const char* long_name;
  std::vector<double> (*of)(const Parameters&) = nullptr;
};
inline constexpr std::tuple kScales = {
    Scale{"/series/x", "m", "position of the block along x", block_positions},
    Scale{"/fields/x", "m", "position of the block along x", block_positions},
    Scale{"/fields/z", "m", "height of the block above the interface", block_heights},
    Scale{kCrossingLevels, "1", "pinned fraction"},
};

/// Calls `use` with each row of a table above.
void for_each(const auto& table, const auto& use) {
  std::apply([&](const auto&... row) { (use(row), ...); }, table);
}

/// Calls `use` with the row of each dataset that a record may hold besides parameters and
/// provenance.
void for_each_dataset(const auto& use) {
  for_each(std::tie(kSeries, kRuptures, kCrossings, kFields, kScales),
           [&](const auto& table) { for_each(table, use); });
}

}  // namespace rupture::record_layout

namespace rupture {

/// Where the blocks are: datasets for the groups of `record` that need them.
Content record_positions(const Parameters& parameters, const Content& record);

/// Labels of all datasets of a record that have any.
Labels record_labels(const Content& record);

}  // namespace rupture
