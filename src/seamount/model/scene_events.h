// What happens to a scene from outside while it grows (P3 sec. 1.7.2, Algorithm 4). Times are iterations; what an event
// does grows linearly from its start to its end and stays, but for storms and currents, which blow in between only.
#pragma once

#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"

namespace seamount {

/// Share of an event that has happened at a time; 1 from the end on.
constexpr double event_progress(double start, double end, double time) {
  if (time <= start) return 0.0;
  return time >= end ? 1.0 : (time - start) / (end - start);
}

struct WaterLevelEvent {
  static constexpr std::string_view kTool = "water_level", kAbout = "the sea rises or falls (eq. 1.56)";
  double start = 0.0;
  double end = 1.0;
  double change_m = 0.0;
  bool operator==(const WaterLevelEvent&) const = default;

  static constexpr auto fields() {
    return std::tuple(field(&WaterLevelEvent::start, "start", "", at_least(0), "iteration at which it begins"),
                      field(&WaterLevelEvent::end, "end", "", at_least(0), "iteration at which it is over"),
                      field(&WaterLevelEvent::change_m, "change_m", "m", between(-20000, 20000), "below 0: it falls"));
  }
};

struct GroundEvent {
  static constexpr std::string_view kTool = "ground", kAbout = "the ground sinks or rises around a place (eq. 1.57)";
  double start = 0.0;
  double end = 1.0;
  Vec2 place;
  double change_m = 0.0;
  double radius_m = 1000.0;
  bool operator==(const GroundEvent&) const = default;

  static constexpr auto fields() {
    return std::tuple(field(&GroundEvent::start, "start", "", at_least(0), "iteration at which it begins"),
                      field(&GroundEvent::end, "end", "", at_least(0), "iteration at which it is over"),
                      field(&GroundEvent::place, "place", "of the strongest change"),
                      field(&GroundEvent::change_m, "change_m", "m", between(-20000, 20000), "there; below 0 it sinks"),
                      field(&GroundEvent::radius_m, "radius_m", "m", between(1e-3, 1e7), "deviation of the falloff"));
  }
};

struct StormEvent {
  static constexpr std::string_view kTool = "storm", kAbout = "a storm drives the water around a place (sec. 1.7.2)";
  double start = 0.0;
  double end = 1.0;
  Vec2 place;
  double speed_m_s = 3.0;
  double towards_deg = 0.0;
  double radius_m = 1000.0;
  bool operator==(const StormEvent&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(&StormEvent::start, "start", "", at_least(0), "iteration at which it begins"),
        field(&StormEvent::end, "end", "", at_least(0), "iteration from which it is over"),
        field(&StormEvent::place, "place", "its centre"),
        field(&StormEvent::speed_m_s, "speed_m_s", "m/s", between(0, 100),
              "of the water that it drives, at the centre"),
        field(&StormEvent::towards_deg, "towards_deg", "deg", between(-360, 360), "where to: 0 east, 90 north"),
        field(&StormEvent::radius_m, "radius_m", "m", between(1e-3, 1e7), "deviation of the falloff"));
  }
};

struct CurrentEvent {
  static constexpr std::string_view kTool = "current", kAbout = "a drawn current (sec. 1.7.1)";
  double start = 0.0;
  double end = 1e9;
  Polyline points;
  double speed_m_s = 1.0;
  double width_m = 100.0;
  bool operator==(const CurrentEvent&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(&CurrentEvent::start, "start", "", at_least(0), "iteration at which it begins"),
        field(&CurrentEvent::end, "end", "", at_least(0), "iteration from which it is over"),
        field(&CurrentEvent::points, "points", "a spline through at least two points, in its direction"),
        field(&CurrentEvent::speed_m_s, "speed_m_s", "m/s", between(-100, 100), "on the stroke; below 0 against it"),
        field(&CurrentEvent::width_m, "width_m", "m", between(1e-3, 1e7), "deviation of the falloff across it"));
  }
};

using SceneEvent = std::variant<WaterLevelEvent, GroundEvent, StormEvent, CurrentEvent>;
using Timeline = std::vector<SceneEvent>;

}  // namespace seamount
