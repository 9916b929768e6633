#include "seamount/ops/ecosystem/events.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/current/stroke_field.h"

namespace seamount::ecosystem {
namespace {

template <class Event, class Visit>
void each(const Timeline& timeline, Visit visit) {
  for (const SceneEvent& event : timeline)
    if (const auto* found = std::get_if<Event>(&event)) visit(*found);
}

template <class Event>
bool blows(const Event& event, double time) {
  return time >= event.start && time < event.end;
}

/// Calls visit(index, falloff) for the cells within four deviations of a place.
template <class Visit>
void around(const GridFrame& frame, Vec2 place, double radius_m, const RunContext& run, Visit visit) {
  const double reach = 4.0 * radius_m;
  const auto first_row = static_cast<int>(std::clamp(std::floor(frame.row(place.y + reach)), 0.0, frame.height - 1.0));
  const auto last_row = static_cast<int>(std::clamp(std::ceil(frame.row(place.y - reach)), 0.0, frame.height - 1.0));
  const double scale = -0.5 / (radius_m * radius_m);
  parallel_rows(run, frame.width, last_row - first_row + 1, [&](int begin, int end) {
    for (int y = first_row + begin; y < first_row + end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const double dx = frame.x(x) - place.x, dy = frame.y(y) - place.y;
        visit(static_cast<size_t>(y) * static_cast<size_t>(frame.width) + static_cast<size_t>(x),
              std::exp(scale * (dx * dx + dy * dy)));
      }
    }
  });
}

void add_storm(const StormEvent& storm, VectorField& current, const RunContext& run) {
  const double angle = storm.towards_deg * std::numbers::pi / 180.0;
  const Vec2 velocity = storm.speed_m_s * Vec2{std::cos(angle), std::sin(angle)};
  around(current.frame(), storm.place, storm.radius_m, run, [&](size_t i, double share) {
    current.x.cells()[i] += static_cast<float>(share * velocity.x);
    current.y.cells()[i] += static_cast<float>(share * velocity.y);
  });
}

}  // namespace

double water_level_change(const Timeline& timeline, double time) {
  double change = 0.0;
  each<WaterLevelEvent>(timeline, [&](const WaterLevelEvent& event) {
    change += event_progress(event.start, event.end, time) * event.change_m;
  });
  return change;
}

void add_ground_events(const Timeline& timeline, double time, HeightField& heights, const RunContext& run) {
  each<GroundEvent>(timeline, [&](const GroundEvent& event) {
    const double change = event_progress(event.start, event.end, time) * event.change_m;
    if (change == 0.0) return;
    around(heights.frame(), event.place, event.radius_m, run,
           [&](size_t i, double share) { heights.cells()[i] += static_cast<float>(share * change); });
  });
}

void add_event_currents(const Timeline& timeline, double time, VectorField& current, const RunContext& run) {
  each<StormEvent>(timeline, [&](const StormEvent& storm) {
    if (blows(storm, time)) add_storm(storm, current, run);
  });
  std::vector<Stroke> strokes;
  each<CurrentEvent>(timeline, [&](const CurrentEvent& drawn) {
    if (blows(drawn, time)) strokes.push_back({drawn.points, drawn.width_m, drawn.speed_m_s});
  });
  geom::add_strokes(strokes, current, run);
}

bool changes_between(const Timeline& timeline, double from, double to) {
  const auto grows = [&](const auto& event) {
    return event_progress(event.start, event.end, from) != event_progress(event.start, event.end, to);
  };
  bool changes = false;
  each<WaterLevelEvent>(timeline, [&](const auto& event) { changes |= grows(event); });
  each<GroundEvent>(timeline, [&](const auto& event) { changes |= grows(event); });
  each<StormEvent>(timeline, [&](const auto& event) { changes |= blows(event, from) != blows(event, to); });
  each<CurrentEvent>(timeline, [&](const auto& event) { changes |= blows(event, from) != blows(event, to); });
  return changes;
}

}  // namespace seamount::ecosystem
