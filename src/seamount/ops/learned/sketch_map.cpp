#include "seamount/ops/learned/sketch_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::learned {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

void check_size(const Grid<float>* grid, const GridFrame& frame, const char* name) {
  if (grid != nullptr && (grid->width() != frame.width || grid->height() != frame.height))
    throw IncompatibleInputs(std::string(name) + " has another size than the domain");
}

Grid<uint8_t>& begun(Grid<uint8_t>& grid, const GridFrame& frame) {
  if (grid.empty()) grid = Grid<uint8_t>(frame, 0);
  return grid;
}

/// Counts what is drawn beside the domain: all of it is an error, a part of it is said.
class Beside {
 public:
  void count(bool inside) {
    ++drawn_;
    beside_ += !inside;
  }
  void tell(const RunContext& run) const {
    if (beside_ == 0) return;
    if (beside_ == drawn_) throw InvalidArgument("lines", "nothing that is drawn lies in the domain");
    run.say(std::to_string(beside_) + " of " + std::to_string(drawn_) +
            " lines and heights lie beside the domain and are left out");
  }

 private:
  int drawn_ = 0, beside_ = 0;
};

void add_cells(const Grid<float>* field, Grid<uint8_t>& cells, const GridFrame& frame) {
  if (field == nullptr) return;
  begun(cells, frame);
  for (size_t i = 0; i < field->size(); ++i) {
    if (field->data()[i] > 0.5F) cells.data()[i] = 1;
  }
}

/// Reddish pixels are ridges, bluish ones rivers; grey, dark and green ones neither.
void add_picture(const Image& image, SketchMap& map) {
  begun(map.river, map.frame);
  begun(map.ridge, map.frame);
  for (int py = 0; py < image.height; ++py) {
    for (int px = 0; px < image.width; ++px) {
      const Colour c = image.colour(px, py);
      const bool red = c.r > 100 && c.r > 2 * c.g && c.r > 2 * c.b,
                 blue = c.b > 100 && 4 * c.b > 5 * c.g && c.b > 2 * c.r;
      if (!red && !blue) continue;
      const auto x = static_cast<int>((px + 0.5) * map.frame.width / image.width);
      const auto y = static_cast<int>((py + 0.5) * map.frame.height / image.height);
      (red ? map.ridge : map.river)(x, y) = 1;
    }
  }
}

void add_levelset(const SketchInputs& inputs, SketchMap& map) {
  if (inputs.levelset != nullptr) {
    map.level = Grid<int8_t>(map.frame, 0);
    for (size_t i = 0; i < map.level.size(); ++i) {
      const float v = inputs.levelset->data()[i];
      if (!std::isnan(v)) map.level.data()[i] = v > 0.5F ? 1 : -1;
    }
  }
  if (inputs.lines == nullptr || inputs.lines->areas.empty()) return;
  if (map.level.empty()) map.level = Grid<int8_t>(map.frame, -1);
  for (int y = 0; y < map.frame.height; ++y) {
    for (int x = 0; x < map.frame.width; ++x) {
      for (const NamedArea& area : inputs.lines->areas) {
        for (const Polygon& part : area.parts) {
          if (geom::contains(part, {map.frame.x(x), map.frame.y(y)})) map.level(x, y) = 1;
        }
      }
    }
  }
}

void add_known(const SketchInputs& inputs, SketchMap& map, const RunContext& run) {
  if (inputs.terrain == nullptr && inputs.erase != nullptr)
    throw InvalidArgument("erase", "there is no terrain from which it could erase");
  if (inputs.terrain == nullptr) return;
  map.known_m = *inputs.terrain;
  map.known_m.set_frame(map.frame);
  for (size_t i = 0; inputs.erase != nullptr && i < map.known_m.size(); ++i) {
    if (inputs.erase->data()[i] > 0.5F) map.known_m.data()[i] = kNone;
  }
  if (std::none_of(map.known_m.cells().begin(), map.known_m.cells().end(), [](float z) { return std::isnan(z); }))
    run.say("all ground is known and stays: only unknown cells of terrain, and those of erase, are made");
}

/// Low ground and relief of what was drawn with heights, or usual ones.
void settle_scale(const SketchParams& params, SketchMap& map, const RunContext& run) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto see = [&](float z) {
    low = std::min(low, static_cast<double>(z));
    high = std::max(high, static_cast<double>(z));
  };
  for (size_t i = 0; i < map.cue.size(); ++i) {
    if (map.cue.data()[i] != 0) see(map.cue_m.data()[i]);
  }
  size_t known = 0;
  for (const float z : map.known_m.cells()) {
    if (std::isnan(z)) continue;
    see(z);
    ++known;
  }
  const double width = std::max(map.frame.width_m(), map.frame.height_m());
  const double usual = std::clamp(22 * std::pow(width, 0.45), 30.0, 4500.0);  // 1.4 km over 10 km, 2.3 km over 30 km
  const bool given = high >= low;
  if (known * 10 >
      static_cast<size_t>(map.frame.cells())) {  // a tenth and more of the ground is known: the rest is like it
    map.low_m = params.low_m.value_or(low);
    map.relief_m = params.relief_m.value_or(std::max(1.05 * (high - map.low_m), 1.0));
    return;
  }
  map.low_m = params.low_m.value_or(given ? std::min(low, high - 0.4 * std::min(usual, std::abs(high))) : 0.0);
  if (params.relief_m) {
    map.relief_m = *params.relief_m;
  } else {
    map.relief_m = given && high - map.low_m > 0.2 * usual ? 1.05 * (high - map.low_m) : usual;
    char text[120];
    std::snprintf(text, sizeof text, "relief_m is not given: ground rises about %.0f m above %.0f m", map.relief_m,
                  map.low_m);
    run.say(text);
  }
}

}  // namespace

bool draw_cells(const Polyline& line, Grid<uint8_t>& cells) {
  bool inside = false;
  const GridFrame& frame = cells.frame();
  for (size_t i = 0; i + 1 < std::max<size_t>(line.size(), 2) && i < line.size(); ++i) {
    const Vec2 from = line[i], to = line[std::min(i + 1, line.size() - 1)];
    const double columns = frame.column(to.x) - frame.column(from.x), rows = frame.row(to.y) - frame.row(from.y);
    const double longest = std::max(std::abs(columns), std::abs(rows));
    if (!(longest < 1e7)) throw InvalidArgument("lines", "a line reaches farther than ten million cells");
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * longest)));
    for (int s = 0; s <= steps; ++s) {
      const double t = static_cast<double>(s) / steps;
      const double column = frame.column(from.x) + t * columns, row = frame.row(from.y) + t * rows;
      if (column < -0.5 || row < -0.5 || column >= frame.width - 0.5 || row >= frame.height - 0.5) continue;
      cells(static_cast<int>(std::floor(column + 0.5)), static_cast<int>(std::floor(row + 0.5))) = 1;
      inside = true;
    }
  }
  return inside;
}

bool put_height(Vec2 place, double height_m, SketchMap& map) {
  const double column = map.frame.column(place.x), row = map.frame.row(place.y);
  if (!(column > -0.5 && row > -0.5 && column < map.frame.width - 0.5 && row < map.frame.height - 0.5)) return false;
  begun(map.cue, map.frame);
  if (map.cue_m.empty()) map.cue_m = ScalarField(map.frame, 0.0F);
  const int x = static_cast<int>(std::lround(column)), y = static_cast<int>(std::lround(row));
  map.cue(x, y) = 1;
  map.cue_m(x, y) = static_cast<float>(height_m);
  return true;
}

SketchMap map_of(const SketchInputs& inputs, const SketchParams& params, const GridFrame& frame,
                 const RunContext& run) {
  for (const auto& [grid, name] : {std::pair{inputs.river, "river"},
                                   {inputs.ridge, "ridge"},
                                   {inputs.levelset, "levelset"},
                                   {inputs.terrain, "terrain"},
                                   {inputs.erase, "erase"}})
    check_size(grid, frame, name);
  SketchMap map;
  map.frame = frame;
  Beside beside;
  for (const SketchedLine& line : params.rivers) beside.count(draw_cells(line.points, begun(map.river, frame)));
  for (const SketchedLine& line : params.ridges) beside.count(draw_cells(line.points, begun(map.ridge, frame)));
  for (const SketchedHeight& h : params.heights) beside.count(put_height({h.x_m, h.y_m}, h.height_m, map));
  if (inputs.lines != nullptr) {
    for (const ValuedLine& line : inputs.lines->lines) {
      if (line.value != 0 && line.value != 1)
        throw InvalidArgument("lines",
                              "a line has the value " + std::to_string(line.value) + ": 0 is a river, 1 a ridge");
      beside.count(draw_cells(line.points, begun(line.value == 0 ? map.river : map.ridge, frame)));
    }
    for (const ValuedPoint& point : inputs.lines->points) beside.count(put_height(point.place, point.value, map));
  }
  beside.tell(run);
  if (inputs.image != nullptr) add_picture(*inputs.image, map);
  add_cells(inputs.river, map.river, frame);
  add_cells(inputs.ridge, map.ridge, frame);
  add_levelset(inputs, map);
  add_known(inputs, map, run);
  settle_scale(params, map, run);
  return map;
}

}  // namespace seamount::learned
