// What commands of records have in common: the window or event that they measure, and by which
// criteria.
#pragma once

#include "cli/command_line.hpp"
#include "rupture/analysis/front.hpp"
#include "rupture/checkpoint/record.hpp"

namespace rupture::tools {

/// A record, and how it is to be measured.
struct RecordCommand {
  po::variables_map values;
  Record record;
  double from = 0, to = 0;  ///< window of time that counts [s]
};

void add_window_options(po::options_description& options);

/// Reads the record. The window is the whole record unless --from and --to were given. The record's
/// ruptures are those that --ruptured-below asks for, if the command has it. Throws UsageError if
/// the window is empty, beside the record or given with --event, Failure if the record cannot be
/// read, holds no samples or not these ruptures.
RecordCommand record_of(const Parsed& parsed);

void add_quiet_time_option(po::options_description& options);

/// Adds --event, --from, --to and --quiet-time.
void add_event_options(po::options_description& options);

/// When the window begins in which ruptures count [s].
double first_moment(const RecordCommand& command);

/// Time without ruptures that separates events [s].
double quiet_time(const RecordCommand& command);

/// How an event ends in a window.
struct EventEnd {
  double silence = 0;     ///< from its last rupture to the end of the window [s]
  double quiet_time = 0;  ///< after which it is over [s]
  bool is_over = true;
  std::string_view window = "record";  ///< what begins and ends
};

/// The block ruptures of one event, as find_events() splits them, in a window of time.
struct ChosenEvent {
  std::span<const Rupture> ruptures;  ///< empty if nothing ruptured
  double from = 0, to = 0;            ///< those at later times do not count [s]
  std::size_t in_window = 1;          ///< events from --from to --to; 1 if --event names it
  EventEnd end = {};
};

/// The event that --event names, or the only one between --from and --to. Of a prepared interface,
/// recorded since it was prepared, it is the one that the trigger started, even if others follow.
/// Throws UsageError if --event names none, Failure if none spans the interface or several are in
/// the window: first ruptures of several events make no front.
ChosenEvent choose_event(const RecordCommand& command);

/// --slow-below, --skip-below-x, --stencil, --line and --ruptured-below, by which record_of() goes.
void add_criteria_options(po::options_description& options);

/// The criteria that the options ask for. By default, --skip-below-x is the centre of the first
/// stencil that is free of the trigger region on an interface that `prepare` made, and kLoadingZone
/// on others. Throws UsageError for a criterion that this record cannot meet.
FrontCriteria criteria(const RecordCommand& command);
Quantity criteria_quantity(const FrontCriteria& criteria);

Front front_of(const RecordCommand& command, const ChosenEvent& event);

}  // namespace rupture::tools
