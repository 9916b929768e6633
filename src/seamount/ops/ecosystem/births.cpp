#include "seamount/ops/ecosystem/births.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "seamount/base/rng.h"
#include "seamount/geom/grid/resample.h"

namespace seamount::ecosystem {
namespace {

struct Box {
  double west, south, east, north;
  double area() const { return std::max(0.0, east - west) * std::max(0.0, north - south); }
};

/// The frame, or the boxes around the regions that the class lives within, cut at the frame.
std::vector<Box> search_boxes(const BirthCall& call) {
  const GridFrame& frame = call.environment.frame;
  const Box whole{frame.west_m, frame.south_m(), frame.east_m(), frame.north_m};
  const std::vector<int>& within = call.rules.classes[static_cast<size_t>(call.of_class)].within;
  if (within.empty()) return {whole};
  std::vector<Box> boxes;
  for (const SceneObject& object : call.scene.objects) {
    if (std::find(within.begin(), within.end(), object.of_class) == within.end()) continue;
    if (!seen_from(call.scene, object, call.window)) continue;
    Box box{whole.east, whole.north, whole.west, whole.south};
    for (const Vec2 p : object.skeleton.points) {
      box.west = std::min(box.west, p.x);
      box.east = std::max(box.east, p.x);
      box.south = std::min(box.south, p.y);
      box.north = std::max(box.north, p.y);
    }
    box = {std::max(box.west, whole.west), std::max(box.south, whole.south), std::min(box.east, whole.east),
           std::min(box.north, whole.north)};
    if (box.area() > 0) boxes.push_back(box);
  }
  return boxes;
}

/// About `count` places, one in each square of a raster over the box.
void scatter(const Box& box, double count, Rng& rng, std::vector<Vec2>& places) {
  const double side = std::sqrt(box.area() / std::max(1.0, count));
  const auto columns = std::max(1L, std::lround((box.east - box.west) / side));
  const auto rows = std::max(1L, std::lround((box.north - box.south) / side));
  const double dx = (box.east - box.west) / static_cast<double>(columns);
  const double dy = (box.north - box.south) / static_cast<double>(rows);
  for (long row = 0; row < rows; ++row) {
    for (long column = 0; column < columns; ++column) {
      const double u = rng.uniform(), v = rng.uniform();
      places.push_back(
          {box.west + (static_cast<double>(column) + u) * dx, box.south + (static_cast<double>(row) + v) * dy});
    }
  }
}

std::vector<Vec2> sample(const BirthCall& call, Seed seed) {
  const std::vector<Box> boxes = search_boxes(call);
  double area = 0.0;
  for (const Box& box : boxes) area += box.area();
  const Placement& placement = call.scene.catalogue.classes[static_cast<size_t>(call.of_class)].placement;
  const double wanted = std::max(static_cast<double>(placement.samples), 8.0 * call.most);
  std::vector<Vec2> places;
  Rng rng(seed.derive("places"));
  for (const Box& box : boxes) scatter(box, wanted * box.area() / area, rng, places);
  return places;
}

/// Places taken so far, found by squares of the spacing.
class Neighbours {
 public:
  explicit Neighbours(double spacing) : spacing_(spacing) {}

  bool free(Vec2 p) const {
    if (spacing_ <= 0) return true;
    const auto [column, row] = square(p);
    for (int64_t y = row - 1; y <= row + 1; ++y) {
      for (int64_t x = column - 1; x <= column + 1; ++x) {
        const auto [first, last] = places_.equal_range(key(x, y));
        for (auto it = first; it != last; ++it)
          if (std::hypot(it->second.x - p.x, it->second.y - p.y) < spacing_) return false;
      }
    }
    return true;
  }
  void take(Vec2 p) {
    if (spacing_ <= 0) return;
    const auto [column, row] = square(p);
    places_.emplace(key(column, row), p);
  }

 private:
  std::pair<int64_t, int64_t> square(Vec2 p) const {
    return {static_cast<int64_t>(std::floor(p.x / spacing_)), static_cast<int64_t>(std::floor(p.y / spacing_))};
  }
  static uint64_t key(int64_t x, int64_t y) {
    return mix_bits(static_cast<uint64_t>(x)) ^ (static_cast<uint64_t>(y) * 0x9e3779b97f4a7c15ULL);
  }

  double spacing_;
  std::unordered_multimap<uint64_t, Vec2> places_;
};

/// Indices in the order in which they are tried: fittest first, or by lot in proportion to `over` (Efraimidis and
/// Spirakis 2006).
std::vector<size_t> order(const std::vector<double>& over, Pick pick, Seed seed) {
  std::vector<double> keys(over.size());
  for (size_t i = 0; i < over.size(); ++i) {
    if (pick == Pick::best) {
      keys[i] = over[i];
    } else {
      Rng rng(seed.derive("lot", i));
      keys[i] = over[i] > 0 ? std::log(1.0 - rng.uniform()) / over[i] : -1e300;
    }
  }
  std::vector<size_t> indices;
  for (size_t i = 0; i < over.size(); ++i)
    if (over[i] > 0) indices.push_back(i);
  std::stable_sort(indices.begin(), indices.end(), [&](size_t a, size_t b) { return keys[a] > keys[b]; });
  return indices;
}

double focus_at(const Mask& focus, Vec2 at) {
  const GridFrame& frame = focus.frame();
  return geom::sample_bilinear(focus, std::clamp(frame.column(at.x), 0.0, frame.width - 1.0),
                               std::clamp(frame.row(at.y), 0.0, frame.height - 1.0));
}

}  // namespace

void Prospects::add(const Prospects& other) {
  asked += other.asked;
  without_value += other.without_value;
  if (other.largest && (!largest || *other.largest > *largest)) {
    largest = other.largest;
    where = other.where;
  }
  if (!no_number) no_number = other.no_number;
}

std::vector<bool> allowed_places(const Rules& rules, const Environment& environment, int of_class,
                                 std::span<const Vec2> places, const RunContext& run) {
  const ClassRules& of = rules.classes[static_cast<size_t>(of_class)];
  std::vector<bool> allowed(places.size(), of.within.empty());
  std::vector<uint8_t> inside(places.size());
  const auto ask = [&](int other) { environment.of_class[static_cast<size_t>(other)].inside(places, {}, inside, run); };
  for (const int other : of.within) {
    ask(other);
    for (size_t i = 0; i < places.size(); ++i) allowed[i] = allowed[i] || inside[i] != 0;
  }
  for (const int other : of.outside) {
    ask(other);
    for (size_t i = 0; i < places.size(); ++i) allowed[i] = allowed[i] && inside[i] == 0;
  }
  return allowed;
}

std::vector<Vec2> birth_places(const BirthCall& call, Prospects& prospects, const RunContext& run) {
  const auto index = static_cast<size_t>(call.of_class);
  const ObjectClass& of = call.scene.catalogue.classes[index];
  const Seed seed = Seed{call.scene.seed}
                        .derive("births", static_cast<uint64_t>(iterations_in(call.scene, call.window)))
                        .derive(of.name, static_cast<uint64_t>(call.window));
  const std::vector<Vec2> places = sample(call, seed);
  std::vector<double> fitness(places.size());
  Survey(call.scene, call.environment, run).ask(call.rules.classes[index].fitness, {places}, fitness);
  const std::vector<bool> allowed = allowed_places(call.rules, call.environment, call.of_class, places, run);

  Prospects found;
  found.asked = places.size();
  for (size_t i = 0; i < places.size(); ++i) {
    if (!std::isfinite(fitness[i])) {
      ++found.without_value;
      if (!found.no_number) found.no_number = places[i];
      fitness[i] = of.birth;
      continue;
    }
    if (call.focus != nullptr) fitness[i] *= focus_at(*call.focus, places[i]);
    if (!allowed[i]) {
      fitness[i] = of.birth;
      continue;
    }
    if (!found.largest || fitness[i] > *found.largest) {
      found.largest = fitness[i];
      found.where = places[i];
    }
  }
  prospects.add(found);

  std::vector<double> over(places.size());
  for (size_t i = 0; i < places.size(); ++i) over[i] = fitness[i] - of.birth;
  Neighbours taken(of.placement.spacing_m);
  for (const SceneObject& object : call.scene.objects) {
    if (object.of_class != call.of_class || !seen_from(call.scene, object, call.window)) continue;
    for (const Vec2 p : object.skeleton.points) taken.take(p);
  }
  std::vector<Vec2> chosen;
  for (const size_t i : order(over, of.placement.pick, seed)) {
    if (static_cast<int>(chosen.size()) >= call.most) break;
    if (!taken.free(places[i])) continue;
    taken.take(places[i]);
    chosen.push_back(places[i]);
  }
  return chosen;
}

}  // namespace seamount::ecosystem
