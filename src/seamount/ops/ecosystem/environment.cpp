#include "seamount/ops/ecosystem/environment.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/solve/screened_distance.h"
#include "seamount/ops/ecosystem/events.h"
#include "seamount/ops/ecosystem/ground.h"
#include "seamount/ops/ecosystem/materials.h"
#include "seamount/ops/ecosystem/water.h"

namespace seamount::ecosystem {
namespace {

std::string frame_text(const GridFrame& frame) {
  return std::to_string(frame.width) + " x " + std::to_string(frame.height) + " cells of " +
         format_number(frame.cell_m) + " m from " + format_number(frame.west_m) + " east and " +
         format_number(frame.north_m) + " north " +
         (frame.crs.empty() ? "of no coordinate system" : "of " + frame.crs.substr(0, frame.crs.find('[')));
}

bool encloses(const GridFrame& outer, const GridFrame& inner) {
  const double slack = 1e-6 * outer.cell_m;
  return inner.west_m >= outer.west_m - slack && inner.east_m() <= outer.east_m() + slack &&
         inner.south_m() >= outer.south_m() - slack && inner.north_m <= outer.north_m + slack;
}

/// The finest coarser frame around a window.
int parent_of(const Scene& scene, int window) {
  const GridFrame& own = frame_of(scene, window);
  int parent = 0;
  for (size_t w = 1; w <= scene.windows.size(); ++w) {
    const GridFrame& frame = scene.windows[w - 1].frame;
    if (static_cast<int>(w) == window || frame.cell_m <= own.cell_m || !encloses(frame, own)) continue;
    if (frame.cell_m < frame_of(scene, parent).cell_m) parent = static_cast<int>(w);
  }
  return parent;
}

/// A field of the coarser frame at the cells of a finer one.
ScalarField continued(const ScalarField& field, const GridFrame& frame, const RunContext& run) {
  ScalarField made(frame);
  const GridFrame& from = field.frame();
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const double row = std::clamp(from.row(frame.y(y)), 0.0, from.height - 1.0);
      for (int x = 0; x < frame.width; ++x)
        made(x, y) = geom::sample_bilinear(field, std::clamp(from.column(frame.x(x)), 0.0, from.width - 1.0), row);
    }
  });
  return made;
}

std::shared_ptr<const Environment::Around> environment_around(const Scene& scene, const Rules& rules, const Site& site,
                                                              int window, double time, const RunContext& run) {
  const Environment parent = make_environment(scene, rules, site, parent_of(scene, window), time, run);
  const GridFrame& frame = frame_of(scene, window);
  Environment::Around around{{continued(parent.current.x, frame, run), continued(parent.current.y, frame, run)}, {}};
  for (const ScalarField& material : parent.materials) around.materials.push_back(continued(material, frame, run));
  return std::make_shared<const Environment::Around>(std::move(around));
}

/// What of some objects has an effect.
template <class Choose>
Digest digest_of(const Scene& scene, Choose choose) {
  Hasher hasher;
  for (const SceneObject& object : scene.objects) {
    if (!choose(object)) continue;
    hasher.number(static_cast<uint64_t>(object.of_class)).number(std::bit_cast<uint64_t>(object.size));
    hasher.number(object.skeleton.points.size()).bytes(std::as_bytes(std::span(object.skeleton.points)));
  }
  return hasher.digest();
}

/// Of a class, on a frame (P3 eq. 1.39), falling off over a few cells.
ScalarField screened_distance_to(const geom::SkeletonIndex& index, const GridFrame& frame, const RunContext& run) {
  constexpr double kLength = 4.0;  // cells
  Grid<uint8_t> covered(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<Vec2> places(static_cast<size_t>(frame.width));
    std::vector<uint8_t> inside(places.size()), near(places.size());
    RunContext serial;
    serial.threads = 1;
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) places[static_cast<size_t>(x)] = {frame.x(x), frame.y(y)};
      index.inside(places, {}, inside, serial);
      index.any_within(places, {}, std::sqrt(0.5) * frame.cell_m, near, serial);
      for (size_t i = 0; i < places.size(); ++i) covered.row(y)[i] = inside[i] != 0 || near[i] != 0 ? 1 : 0;
    }
  });
  ScalarField distance = geom::screened_distance(covered, kLength * frame.cell_m, run);
  const auto far = static_cast<float>(std::hypot(frame.width_m(), frame.height_m()));
  for (float& d : distance.cells()) d = std::min(d, far);
  return distance;
}

}  // namespace

const GridFrame& frame_of(const Scene& scene, int window) {
  if (window == 0) return scene.frame;
  if (window < 0 || window > static_cast<int>(scene.windows.size()))
    throw InvalidArgument("window", std::to_string(window) + " is none of the scene's " +
                                        std::to_string(scene.windows.size()) + " windows");
  return scene.windows[static_cast<size_t>(window - 1)].frame;
}

bool seen_from(const Scene& scene, const SceneObject& object, int window) {
  if (object.window == window || object.window == 0) return true;
  return window != 0 && encloses(frame_of(scene, object.window), frame_of(scene, window)) &&
         frame_of(scene, object.window).cell_m > frame_of(scene, window).cell_m;
}

bool changes_surroundings(const ObjectClass& of) {
  return !of.deposits.empty() || !of.absorbs.empty() || of.height.shape != HeightShape::none || !of.currents.empty();
}

void index_objects(const Scene& scene, const Rules& rules, int window, Environment& environment,
                   const RunContext& run) {
  const size_t count = scene.catalogue.classes.size();
  std::vector<std::vector<Skeleton>> skeletons(count);
  std::vector<std::vector<int32_t>> owners(count);
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    if (!seen_from(scene, object, window)) continue;
    skeletons[static_cast<size_t>(object.of_class)].push_back(object.skeleton);
    owners[static_cast<size_t>(object.of_class)].push_back(static_cast<int32_t>(i));
  }
  environment.of_class.clear();
  for (size_t c = 0; c < count; ++c) environment.of_class.emplace_back(skeletons[c], owners[c]);
  environment.screened.assign(count, {});
  for (size_t c = 0; c < count; ++c) {
    if (rules.screened[c])
      environment.screened[c] = screened_distance_to(environment.of_class[c], environment.frame, run);
  }
}

Environment make_environment(const Scene& scene, const Rules& rules, const Site& site, int window, double time,
                             const RunContext& run, Environment before) {
  if (site.ground.frame() != scene.frame)
    throw IncompatibleInputs("the objects grew on another ground: theirs has " + frame_text(scene.frame) +
                             ", this one " + frame_text(site.ground.frame()));
  if (site.current != nullptr && site.current->frame() != scene.frame)
    throw IncompatibleInputs("the current lies elsewhere than the ground: " + frame_text(site.current->frame()) +
                             ", the ground " + frame_text(scene.frame));
  Environment environment;
  environment.frame = frame_of(scene, window);
  environment.window = window;
  environment.water_level_m = scene.surroundings.water_level_m + water_level_change(scene.timeline, time);
  environment.height = ground_with_objects(scene, site, window, time, environment.water_level_m, run);
  const auto level = static_cast<float>(environment.water_level_m);
  for (float& z : environment.height.cells()) z -= level;
  environment.time = time;
  const bool same_time = before.frame == environment.frame && !before.height.empty() &&
                         !changes_between(scene.timeline, before.time, time);
  if (window != 0) {
    const int parent = parent_of(scene, window);
    environment.around_of = digest_of(scene, [&](const auto& object) { return seen_from(scene, object, parent); });
    environment.around = same_time && before.around_of == environment.around_of
                             ? before.around
                             : environment_around(scene, rules, site, window, time, run);
  }
  environment.water_of = digest_of(scene, [&](const SceneObject& object) {
    return object.window == window && !scene.catalogue.classes[static_cast<size_t>(object.of_class)].currents.empty();
  });
  const bool same_flow = same_time && before.water_of == environment.water_of && before.around == environment.around &&
                         before.height == environment.height;
  environment.current = same_flow ? std::move(before.current)
                                  : current_of(scene, site, environment.height, window, time,
                                               environment.around ? &environment.around->current : nullptr, run);
  if (!same_flow) before.materials.clear();
  bring_to_rest(scene, rules, window, before, environment, run);
  index_objects(scene, rules, window, environment, run);
  return environment;
}

}  // namespace seamount::ecosystem
