// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// One row per dataset of a record; its writer and its reader go by these rows.
#pragma once

#include <tuple>

#include "rupture/checkpoint/record.hpp"

namespace rupture::record_layout {

inline constexpr const char* kSeriesGroup = "/series/";
inline constexpr const char* kRupturesGroup = "/ruptures/";
inline constexpr const char* kCrossingsGroup = "/crossings/";
inline constexpr const char* kCrossingLevels = "/crossings/levels";  // those asked for

/// A dataset with a row per sample: one value, or one per interface block.
template <class InSample, class InRecord>
struct Series {
  const char* path;
  const char* unit;
  InSample Sample::*in_sample;
  InRecord Record::*in_record;
};
template <class InSample, class InRecord>
Series(const char*, const char*, InSample Sample::*, InRecord Record::*)
    -> Series<InSample, InRecord>;

inline constexpr std::tuple kSeries = {
    Series{"/series/time", "s", &Sample::time, &Record::time},
    Series{"/series/step", "1", &Sample::step, &Record::step},
    Series{"/series/F_T", "N", &Sample::F_T, &Record::F_T},
    Series{"/series/x_drive", "m", &Sample::x_drive, &Record::x_drive},
    Series{"/series/pinned", "1", &Sample::pinned, &Record::pinned},
    Series{"/series/p", "N", &Sample::p, &Record::p},
    Series{"/series/tau", "N", &Sample::tau, &Record::tau},
    Series{"/series/u_x", "m", &Sample::u_x, &Record::u_x},
};

/// A dataset with one value per rupture, or per crossing of another pinned fraction.
template <class T>
struct OfRupture {
  const char* path;
  const char* unit;
  T Rupture::*member;
};
template <class T>
OfRupture(const char*, const char*, T Rupture::*) -> OfRupture<T>;

inline constexpr std::tuple kRuptures = {
    OfRupture{"/ruptures/step", "1", &Rupture::step},
    OfRupture{"/ruptures/time", "s", &Rupture::time},
    OfRupture{"/ruptures/block", "1", &Rupture::block},
};

inline constexpr std::tuple kCrossings = {
    OfRupture{"/crossings/step", "1", &Rupture::step},
    OfRupture{"/crossings/time", "s", &Rupture::time},
    OfRupture{"/crossings/block", "1", &Rupture::block},
    OfRupture{"/crossings/pinned_below", "1", &Rupture::pinned_below},
};

/// Calls `use` with each row of a table above.
template <class Table, class Use>
void for_each(const Table& table, const Use& use) {
  std::apply([&](const auto&... row) { (use(row), ...); }, table);
}

}  // namespace rupture::record_layout
