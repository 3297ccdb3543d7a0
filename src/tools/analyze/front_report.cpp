#include "analyze/front_report.hpp"

#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

std::string stretch_text(double limit, const SlowStretch& slow, double c_s) {
  std::string text = fmt::format(
      "below c_s/{:.3g} over {} stencil{} with centres from x = {:.4f} m to {:.4f} m", 1.0 / limit,
      slow.stencils, slow.stencils == 1 ? "" : "s", slow.x_from, slow.x_to);
  if (slow.duration()) text += fmt::format(" for {:.3g} ms", *slow.duration() * 1e3);
  text += fmt::format(", median {:.3g} m/s (c_s/{:.0f})", slow.speed, c_s / slow.speed);
  if (slow.mean_speed()) text += fmt::format(", length/duration {:.3g} m/s", *slow.mean_speed());
  return text;
}

std::string slow_text(const Front& front, double c_s) {
  if (front.slow) return stretch_text(front.criteria.slow_below, *front.slow, c_s);
  const char* const text = front.type == FrontType::slow
                               ? "below c_s/{:.3g} only where it runs backwards"
                               : "no slow stretch below c_s/{:.3g}";
  return fmt::format(fmt::runtime(text), 1.0 / front.criteria.slow_below);
}

/// What the window does not show of the event.
std::string hidden_text(const Front& front, const EventEnd& end) {
  std::string text;
  if (const auto before = front.line.ruptured_before(); before > 0) {
    text += fmt::format("{} block{} had ruptured before the {} begins\n", before,
                        before == 1 ? "" : "s", end.window);
  }
  if (!end.is_over) {
    text += fmt::format(
        "the {} ends {:.3g} ms after the last rupture; an event is over after {:g} ms\n",
        end.window, end.silence * 1e3, end.quiet_time * 1e3);
  }
  return text;
}

/// How far events are apart, where t_R varies much along the interface; else nothing.
std::string apart_text(const Parameters& p, double quiet) {
  const double shortest = p.t_R.smallest(), longest = p.t_R.largest();
  if (longest < 2.0 * shortest) return "";
  return fmt::format(
      "t_R varies along x, from {:g} to {:g} ms; a pause of {:g} ms separates events (default: 5 "
      "times the median; --quiet-time)\n",
      shortest * 1e3, longest * 1e3, quiet * 1e3);
}

}  // namespace

Quantities hidden_quantities(const Front& front, const EventEnd& end) {
  const bool has_event = front.type != FrontType::none;
  return {
      {"ruptured_before", "1", "blocks that had ruptured in the event before the window begins",
       static_cast<std::int64_t>(front.line.ruptured_before())},
      {"is_over", "", "whether nothing ruptured for quiet_time after the event; null without one",
       if_known(has_event, end.is_over)},
      {"silence", "s", "from the last rupture of the event to the end of the window",
       if_known(has_event, std::optional(end.silence))},
      {"quiet_time", "s", "time without ruptures after which an event is over", end.quiet_time},
  };
}

Quantity type_quantity(const Front& front) {
  const bool known = front.type != FrontType::unfinished;
  return {"type", "", "none, arrested, slow or fast; null: the event is not over, and may span",
          if_known(known, std::string(front_type_name(front.type)))};
}

Quantity stretch_quantity(const std::string& key, const std::optional<SlowStretch>& slow) {
  const SlowStretch s = slow.value_or(SlowStretch{});
  const auto known = [&](double value) { return slow ? std::optional(value) : std::nullopt; };
  const Quantities rows = {
      {"x_from", "m", "centre of the first slow stencil", known(s.x_from)},
      {"x_to", "m", "centre of the last slow stencil", known(s.x_to)},
      {"t_from", "s", "time at which the slow stretch begins", known(s.t_from)},
      {"t_to", "s", "time at which the slow stretch ends", known(s.t_to)},
      {"duration", "s", "duration of the slow stretch, of three stencils or more", s.duration()},
      {"speed", "m/s", "median front speed in the slow stretch", known(s.speed)},
      {"slowest", "m/s", "smallest front speed in the slow stretch", known(s.slowest)},
      {"stencils", "1", "slow stencils in it", known(static_cast<double>(s.stencils))},
      {"mean_speed", "m/s", "length of the slow stretch over its duration", s.mean_speed()},
      {"fast_before", "m/s", "median front speed before the slow stretch", s.fast_before},
      {"fast_after", "m/s", "median front speed after the slow stretch", s.fast_after},
  };
  return {key, "", "", Group{rows, slow.has_value()}};
}

std::string kind_name(const Front& front) {
  return front.fast_slow_fast == Answer::yes ? "fast-slow-fast"
                                             : std::string(front_type_name(front.type));
}

std::string kind_text(const Front& front, double c_s) {
  if (front.fast_slow_fast == Answer::yes) return stretch_text(kSlowInWords, *front.in_words, c_s);
  return slow_text(front, c_s);
}

std::string front_text(const Front& front, const Parameters& p, const ChosenEvent& event) {
  const double c_s = shear_wave_speed(p);
  const std::string hidden = hidden_text(front, event.end) + apart_text(p, event.end.quiet_time);
  if (front.type == FrontType::none) {
    return fmt::format("no front: {} ruptured from t = {:.7g} s to {:.7g} s\n{}",
                       front.line.ruptured_before() > 0 ? "no other block" : "nothing", event.from,
                       event.to, hidden);
  }
  const std::string others =
      event.in_window > 1
          ? fmt::format("; event 0 of {}, started by the trigger (see analyze events)",
                        event.in_window)
          : "";
  const std::string type =
      fmt::format("type {}: {}\n", front_type_name(front.type), slow_text(front, c_s));
  return fmt::format("{} front; {}{}\n{}{}", kind_name(front), kind_text(front, c_s), others,
                     front.fast_slow_fast == Answer::yes ? type : "", hidden);
}

std::string events_text(const Parameters& p, const std::vector<Event>& events, double quiet) {
  const Event &first = events.front(), &last = events.back();
  return hidden_text(first.front, {}) +
         hidden_text({}, {last.silence, quiet, last.front.line.is_over}) + apart_text(p, quiet);
}

}  // namespace rupture::tools
