#include "seamount/ops/contour/edit/edit_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/text.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/move/drag.h"
#include "seamount/ops/contour/move/fading.h"
#include "seamount/ops/contour/move/move.h"
#include "seamount/ops/contour/move/places.h"
#include "seamount/ops/contour/move/roughen.h"
#include "seamount/ops/contour/move/smooth.h"
#include "seamount/ops/contour/move/squeeze.h"

namespace seamount::contour {
namespace {

constexpr double kMostSteps = 20000.0;
constexpr double kEdge = 0.1;         ///< of a step: P2 sec. 5.2
constexpr double kTolerance = 0.005;  ///< of a step: what thinning may change

/// Two decimals are enough to type in again; rounded towards 0, so that they do work.
std::string rounded_down(double strength) { return format_number(std::trunc(strength * 1000.0) / 1000.0); }

/// The parameter that says how much a tool moves, for messages.
struct Amount {
  const char* tool;
  const char* field;
  double value;  ///< at the strength that is asked for
};

/// Says what was limited, or refuses.
void move_or_refuse(const Amount& amount, const PlaneMap& map, double strength, ContourSet& set,
                    const ToolContext& context) {
  const Moved result = move_contours(set.contours, map, strength, context.run);
  if (result.crossing) {
    const std::string where = "contours would cross at " + place_text(*result.crossing);
    const std::string given = std::string(amount.field) + " = " + format_number(amount.value);
    const std::string possible = rounded_down(amount.value * (result.strength / strength));
    if (context.on_crossing == OnCrossing::refuse)
      throw InvalidArgument(context.name + "." + amount.field,
                            where + " with " + given + "; nothing crosses up to " + possible);
    context.run.say(context.name + " (" + amount.tool + "): " + where + " with " + given + "; applied with " +
                    possible);
  }
}

void check_stroke(const Polyline& stroke, size_t least, const GridFrame& frame, const std::string& name) {
  check_inside(stroke, frame, name + ".stroke");
  size_t different = stroke.empty() ? 0 : 1;
  for (size_t i = 1; i < stroke.size(); ++i) different += stroke[i] == stroke[i - 1] ? 0 : 1;
  if (different < least)
    throw InvalidArgument(name + ".stroke", "has " + std::to_string(different) +
                                                (least == 1 ? " points" : " different points") +
                                                "; it needs at least " + std::to_string(least));
}

double drag_step(const WarpTool& tool, const Displacement& displacement, const std::string& name) {
  const double longest = 2.0 * tool.radius_m / displacement.steepest_fall();
  if (tool.step_m && *tool.step_m > longest)
    throw InvalidArgument(name + ".step_m", format_number(*tool.step_m) + " would fold space: a drag of radius " +
                                                format_number(tool.radius_m) + " m is one to one up to steps of " +
                                                rounded_down(longest) + " m");
  const double step = tool.step_m.value_or(0.5 * longest);
  const double length = geom::line_length(tool.stroke);
  if (length > kMostSteps * step)
    throw InvalidArgument(name + ".radius_m", format_number(tool.radius_m) + " is too small for a stroke of " +
                                                  format_number(std::round(length)) + " m; from " +
                                                  format_number(std::ceil(length / kMostSteps / step * tool.radius_m)) +
                                                  " m on it would do");
  return step;
}

}  // namespace

void apply(const WarpTool& tool, ContourSet& set, const ToolContext& context) {
  check_stroke(tool.stroke, 2, set.frame, context.name);
  const Displacement displacement = tool.profile.knots.empty()
                                        ? Displacement(tool.k)
                                        : Displacement(tool.profile, (context.name + ".profile").c_str());
  const double step = drag_step(tool, displacement, context.name);
  const Drag drag(tool.stroke, tool.radius_m, step, displacement);
  const PlaneMap map{
      drag.reach(), kEdge * step, kTolerance * step, [&](const geom::Box& box) { return drag.touches(box); },
      [&](double strength, std::span<Vec2> places, const RunContext& run) { drag.move(strength, places, run); }};
  move_or_refuse({"warp", "strength", tool.strength}, map, tool.strength, set, context);
}

void apply(const SlopeTool& tool, ContourSet& set, const ToolContext& context) {
  check_stroke(tool.stroke, 1, set.frame, context.name);
  const double length = geom::line_length(tool.stroke);
  if (length > kMostSteps * 0.05 * tool.radius_m)
    throw InvalidArgument(context.name + ".radius_m", format_number(tool.radius_m) + " is too small for a curve of " +
                                                          format_number(std::round(length)) + " m");
  const Squeeze squeeze(tool.stroke, tool.radius_m, tool.k);
  constexpr double kEdgeOfRadius = 0.04;
  const PlaneMap map{
      squeeze.reach(), kEdgeOfRadius * tool.radius_m, kEdgeOfRadius * kEdge * tool.radius_m,
      [&](const geom::Box& box) { return squeeze.touches(box); },
      [&](double strength, std::span<Vec2> places, const RunContext& run) { squeeze.move(strength, places, run); }};
  move_or_refuse({"slope", "strength", tool.strength}, map, tool.strength, set, context);
}

void apply(const SmoothTool& tool, ContourSet& set, const ToolContext& context) {
  const std::vector<size_t> chosen = select(set, tool.select, context.name + ".select");
  const Smoothed result = smooth_contours(set, chosen, {tool.radius_m, tool.strength, tool.rounds}, context.run);
  if (result.where) {
    const std::string where = "contours would cross near " + place_text(*result.where);
    if (context.on_crossing == OnCrossing::refuse)
      throw InvalidArgument(context.name + ".radius_m",
                            where + "; " + std::to_string(result.limited) +
                                " points have too little room to be smoothed this much; a smaller radius would do");
    context.run.say(context.name + " (smooth): " + where + "; " + std::to_string(result.limited) +
                    " points were smoothed by less");
  }
}

namespace {

/// 1 in the middle, smoothly 0 at the border of the areas and of the frame.
ScalarField weight_within(const std::vector<Polygon>& within, const GridFrame& domain, double fade_m,
                          const RunContext& run) {
  const GridFrame frame = fading_frame(domain, fade_m, 1024);
  if (within.empty())
    return fading_weight(frame, fade_m, run, [](int, int) { return std::numeric_limits<double>::infinity(); });
  const ScalarField outside = geom::signed_distance(within, frame, run);
  return fading_weight(frame, fade_m, run, [&](int x, int y) { return -static_cast<double>(outside(x, y)); });
}

constexpr double kEdgeOfWave = 0.1;

double length_of(const ContourSet& set) {
  double length = 0.0;
  for (const Contour& contour : set.contours) length += geom::ring_length(contour.ring);
  return length;
}

void say_or_refuse(const ToolContext& context, const char* field, const std::string& why, const std::string& applied) {
  if (context.on_crossing == OnCrossing::refuse) throw InvalidArgument(context.name + "." + field, why);
  context.run.say(context.name + " (fractalize): " + why + "; applied with " + applied);
}

/// The shape that is asked for, less what would stir contours or take for ever.
Roughness bounded_shape(const FractalizeTool& tool, const ContourSet& set, double weight_slope,
                        const ToolContext& context) {
  constexpr double kMostMoves = 3e7;
  Roughness shape{tool.amplitude_m, tool.wavelength_m, tool.octaves, tool.gain};
  const double length = length_of(set);
  const double most = std::min(most_amplitude_m(shape), tool.fade_m);
  if (shape.amplitude_m > most) {
    say_or_refuse(context, "amplitude_m",
                  format_number(tool.amplitude_m) + " would stir contours: waves of " +
                      format_number(tool.wavelength_m) + " m that fade over " + format_number(tool.fade_m) +
                      " m may displace them by " + rounded_down(most) + " m",
                  rounded_down(most));
    shape.amplitude_m = most;
  }
  const auto moves = [&] {
    const double points = length / (kEdgeOfWave * shape.wavelength_m) * std::pow(2.0, shape.octaves - 1);
    return points * roughen_parts(shape, weight_slope);
  };
  while (shape.octaves > 1 && moves() > kMostMoves) --shape.octaves;
  if (moves() > kMostMoves)
    throw InvalidArgument(context.name + ".wavelength_m",
                          format_number(tool.wavelength_m) + " is too short for " +
                              format_number(std::round(length / 1000.0)) +
                              " km of contours and this amplitude; about " +
                              format_number(std::ceil(tool.wavelength_m * moves() / kMostMoves)) + " m would do");
  if (shape.octaves < tool.octaves)
    say_or_refuse(context, "octaves",
                  std::to_string(tool.octaves) + " octaves, waves down to " +
                      format_number(tool.wavelength_m * std::pow(2.0, 1 - tool.octaves)) + " m, take too many points",
                  std::to_string(shape.octaves));
  return shape;
}

}  // namespace

void apply(const FractalizeTool& tool, ContourSet& set, const ToolContext& context) {
  for (const Polygon& polygon : tool.within) {
    if (const auto defect = geom::find_defect(polygon)) throw InvalidArgument(context.name + ".within", *defect);
    check_inside(polygon.outer, set.frame, context.name + ".within");
  }
  if (tool.amplitude_m == 0.0) return;
  const ScalarField weight = weight_within(tool.within, set.frame, tool.fade_m, context.run);
  const double slope = 1.5 / std::max(tool.fade_m, 2.0 * weight.cell_m());
  const Roughen roughen(bounded_shape(tool, set, slope, context), weight, slope, context.seed);
  const GridFrame& frame = weight.frame();
  const geom::Box reach{{frame.west_m, frame.south_m()}, {frame.east_m(), frame.north_m}};
  const double edge = kEdgeOfWave * roughen.shortest_wavelength_m();
  const PlaneMap map{
      reach, edge, kEdge * edge, [](const geom::Box&) { return true; },
      [&](double strength, std::span<Vec2> places, const RunContext& run) { roughen.move(strength, places, run); }};
  move_or_refuse({"fractalize", "amplitude_m", tool.amplitude_m}, map, 1.0, set, context);
}

}  // namespace seamount::contour
