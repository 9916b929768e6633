#include "seamount/ops/reef/habitat.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "seamount/geom/contour/contour.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/scalar/spline.h"
#include "seamount/model/same_size.h"
#include "seamount/ops/reef/pieces.h"

namespace seamount::reef {
namespace {

constexpr int kMostCells = 4096;

std::string place_text(Vec2 p) {
  return "(" + format_number(std::round(p.x)) + ", " + format_number(std::round(p.y)) + ")";
}

/// "bounds.low_m -40 m, bounds.high_m any".
std::string window_text(const BoundParams& bounds) {
  const std::string low = bounds.low_m ? format_number(*bounds.low_m) + " m" : "any";
  const std::string high = bounds.high_m ? format_number(*bounds.high_m) + " m" : "any";
  return "bounds.low_m " + low + ", bounds.high_m " + high;
}

void check_size(const ScalarField* field, const HeightField& terrain, const char* name) {
  if (field != nullptr) check_same_size(name, field->frame(), terrain.frame());
}

ScalarField on_lattice(const ScalarField& field, const HeightField& terrain, const GridFrame& lattice,
                       const RunContext& run) {
  if (field.frame() == terrain.frame()) return geom::resample(field, lattice, run);
  ScalarField placed = field;
  placed.set_frame(terrain.frame());
  return geom::resample(placed, lattice, run);
}

/// Collects kernels, each once and in the habitat.
class Kernels {
 public:
  explicit Kernels(const Grid<uint8_t>& habitat) : habitat_(habitat), taken_(habitat.frame(), 0) {}

  bool within(Vec2 p) const {
    const GridFrame& f = habitat_.frame();
    return p.x >= f.west_m && p.x <= f.east_m() && p.y >= f.south_m() && p.y <= f.north_m;
  }
  LatticeCell cell_at(Vec2 p) const {
    const GridFrame& f = habitat_.frame();
    return {std::clamp(static_cast<int>(std::lround(f.column(p.x))), 0, f.width - 1),
            std::clamp(static_cast<int>(std::lround(f.row(p.y))), 0, f.height - 1)};
  }
  /// False where the place is outside or no habitat.
  bool add(Vec2 p) { return within(p) && add(cell_at(p)); }
  bool add(LatticeCell s) {
    if (habitat_(s.x, s.y) == 0) return false;
    if (taken_(s.x, s.y) == 0) {
      taken_(s.x, s.y) = 1;
      cells_.push_back(s);
    }
    return true;
  }
  /// No colony will settle around that place.
  void keep_free(Vec2 p) {
    if (within(p)) free_.push_back(cell_at(p));
  }
  const std::vector<LatticeCell>& cells() const { return cells_; }

  /// Clears the habitat around free places but for the kernels.
  void clear_free(Grid<uint8_t>& habitat) const {
    constexpr int kReach = 2;
    for (const LatticeCell s : free_) {
      for (int y = std::max(0, s.y - kReach); y <= std::min(habitat.height() - 1, s.y + kReach); ++y) {
        for (int x = std::max(0, s.x - kReach); x <= std::min(habitat.width() - 1, s.x + kReach); ++x)
          if (taken_(x, y) == 0) habitat(x, y) = 0;
      }
    }
  }

 private:
  const Grid<uint8_t>& habitat_;
  Grid<uint8_t> taken_;
  std::vector<LatticeCell> cells_, free_;
};

void add_points(const Polyline& points, const BoundParams& bounds, const HeightField& ground, Kernels& kernels) {
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec2 place = points[i];
    const std::string which = "place " + std::to_string(i + 1) + " at " + place_text(place) + " m ";
    const GridFrame& f = ground.frame();
    if (!kernels.within(place))
      throw InvalidArgument("starts.points", which + "lies outside the terrain, which spans " +
                                                 place_text({f.west_m, f.south_m()}) + " to " +
                                                 place_text({f.east_m(), f.north_m}));
    if (kernels.add(place)) continue;
    const LatticeCell s = kernels.cell_at(place);
    throw InvalidArgument("starts.points",
                          which + "lies outside the habitat: the ground is at " +
                              format_number(std::round(ground(s.x, s.y) * 10.0F) / 10.0) + " m there (" +
                              window_text(bounds) +
                              "), or it is within bounds.margin_m of the edge; move it or widen the habitat");
  }
}

/// Starts growth along the covered share of a line's segments, between which passes stay free; true if any place was
/// in the habitat.
bool add_line(const Polyline& line, double lattice_m, const StartParams& p, Rng rng, Kernels& kernels) {
  const double step = 0.5 * lattice_m;
  bool any = false;
  double covered = -1.0, segment = 0.0;  // metres left of the covered part, and of the whole segment
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 a = line[i], d = line[i + 1] - a;
    const double length = std::sqrt(dot(d, d));
    const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int j = 0; j < steps; ++j) {
      if (segment <= 0.0) {
        segment = p.segment_m * rng.uniform(0.5, 1.5);
        covered = p.line_cover >= 1.0 ? segment : segment * std::min(1.0, p.line_cover * rng.uniform(0.8, 1.2));
      }
      const Vec2 place = a + (static_cast<double>(j) / steps) * d;
      if (covered > 0.0) any = kernels.add(place) || any;
      if (covered < -lattice_m && segment > lattice_m) kernels.keep_free(place);
      segment -= length / steps;
      covered -= length / steps;
    }
  }
  return any;
}

void add_lines(const StartParams& p, const Drawing* drawing, const HeightField& ground, const std::string& window,
               Seed seed, Kernels& kernels) {
  const double lattice_m = ground.cell_m();
  if (!p.line.empty()) {
    if (p.line.size() < 2) throw InvalidArgument("starts.line", "has one point; a line needs two");
    const Polyline smooth = geom::sample_catmull_rom(p.line, 0.5 * lattice_m);
    if (!add_line(smooth, lattice_m, p, Rng(seed.derive("reef.line")), kernels))
      throw InvalidArgument("starts.line", "no covered part of it lies in the habitat (" + window + ")");
  }
  if (p.contour_m) {
    bool any = false;
    uint64_t index = 0;
    for (const Polyline& contour : geom::trace_lines(ground, *p.contour_m)) {
      if (geom::line_length(contour) < 6.0 * lattice_m) continue;
      any = add_line(contour, lattice_m, p, Rng(seed.derive("reef.contour", index++)), kernels) || any;
    }
    if (!any)
      throw InvalidArgument("starts.contour_m", "the terrain has no contour at " + format_number(*p.contour_m) +
                                                    " m in the habitat (" + window + ")");
  }
  if (drawing == nullptr) return;
  bool any = false;
  uint64_t index = 0;
  for (const ValuedLine& line : drawing->lines) {
    Polyline points = line.points;
    if (line.closed && !points.empty()) points.push_back(points.front());
    any = add_line(points, lattice_m, p, Rng(seed.derive("reef.drawn_line", index++)), kernels) || any;
  }
  for (const NamedArea& area : drawing->areas) {
    const Grid<uint8_t> cells = geom::rasterise(area.parts, ground.frame());
    for (int y = 0; y < cells.height(); ++y) {
      for (int x = 0; x < cells.width(); ++x) {
        if (cells(x, y) != 0) any = kernels.add(LatticeCell{x, y}) || any;
      }
    }
  }
  if (!any) throw InvalidArgument("drawing", "nothing of it lies in the habitat (" + window + ")");
}

/// First colonies around a place, as many as reefs differ in age: one of n times the size for n of the size.
void add_patch(LatticeCell first, const Grid<uint8_t>& where, Rng& rng, Kernels& kernels) {
  constexpr double kMost = 60.0;
  std::vector<LatticeCell> patch = {first};
  kernels.add(first);
  const auto size = static_cast<size_t>(std::min(kMost, 1.0 / (1.0 - rng.uniform())));
  for (size_t tries = 0; patch.size() < size && tries < 4 * size; ++tries) {
    const LatticeCell from = patch[static_cast<size_t>(rng.integer(0, static_cast<int>(patch.size()) - 1))];
    const LatticeCell next{from.x + rng.integer(-1, 1), from.y + rng.integer(-1, 1)};
    if (!where.contains(next.x, next.y) || where(next.x, next.y) == 0) continue;
    if (kernels.add(next)) patch.push_back(next);
  }
}

void add_random(int count, const Grid<uint8_t>& where, const std::string& name, Seed seed, Kernels& kernels) {
  std::vector<LatticeCell> places;
  for (int y = 0; y < where.height(); ++y) {
    for (int x = 0; x < where.width(); ++x) {
      if (where(x, y) != 0) places.push_back({x, y});
    }
  }
  if (places.empty()) throw InvalidArgument(name, "no lattice cell of it lies in the habitat");
  Rng rng(seed.derive("reef.random_kernels"));
  for (int i = 0; i < count; ++i)
    add_patch(places[static_cast<size_t>(rng.integer(0, static_cast<int>(places.size()) - 1))], where, rng, kernels);
}

/// The strip along the edge that stays free: at least margin_m wide, up to twice that with bays, so that no reef ends
/// in a straight line.
class Margin {
 public:
  Margin(const GridFrame& frame, double margin_m, Seed seed)
      : frame_(frame), margin_m_(margin_m), seed_(seed.derive("reef.margin")) {}

  bool holds(int x, int y) const {
    if (margin_m_ <= 0) return false;
    const double px = frame_.x(x), py = frame_.y(y);
    const double inside =
        std::min({px - frame_.west_m, frame_.east_m() - px, py - frame_.south_m(), frame_.north_m - py});
    if (inside < margin_m_ || inside > 2.0 * margin_m_) return inside < margin_m_;
    const geom::Fbm bays{.wavelength_m = 5.0 * margin_m_, .octaves = 3};
    return inside < margin_m_ * std::clamp(1.5 + 1.4 * geom::fbm(seed_, bays, px, py), 1.0, 2.0);
  }

 private:
  GridFrame frame_;
  double margin_m_;
  Seed seed_;
};

[[noreturn]] void throw_no_ground(const BoundParams& p, bool floorless) {
  throw InvalidArgument(
      p.low_m ? "bounds.low_m" : "bounds.high_m",
      "no sea floor lies between them (" + window_text(p) + "), which is where corals have light" +
          (floorless ? "; the sea of this terrain is 0 m everywhere, as elevation models of land give it: "
                       "terrain.sea_floor gives it a floor"
                     : "; bounds.light_depth_m or bounds.low_m make the habitat deeper"));
}

Grid<uint8_t> suitable_cells(const HeightField& ground, const ScalarField* share, bool floorless, double margin_m,
                             const BoundParams& p, Seed seed) {
  if (p.low_m && p.high_m && *p.low_m >= *p.high_m)
    throw InvalidArgument("bounds.low_m", format_number(*p.low_m) + " is not below bounds.high_m");
  Grid<uint8_t> habitat(ground.frame(), 0);
  const Margin margin(ground.frame(), margin_m, seed);
  int64_t free = 0, masked = 0, cells = 0;
  for (int y = 0; y < ground.height(); ++y) {
    for (int x = 0; x < ground.width(); ++x) {
      if (margin.holds(x, y)) continue;
      ++free;
      if (share != nullptr && (*share)(x, y) < 0.5F) continue;
      ++masked;
      const double z = ground(x, y);
      if (!(z >= p.low_m.value_or(-1e9) && z <= p.high_m.value_or(1e9))) continue;  // NaN is not
      habitat(x, y) = 1;
      ++cells;
    }
  }
  if (free == 0)
    throw InvalidArgument("bounds.margin_m", format_number(margin_m) + " m leaves nothing of a terrain of " +
                                                 format_number(ground.frame().width_m()) + " x " +
                                                 format_number(ground.frame().height_m()) + " m; give a smaller one");
  if (masked == 0) throw InvalidArgument("habitat", "the mask has no lattice cell: it is nowhere 0.5 over lattice_m");
  if (cells == 0) throw_no_ground(p, floorless);
  return habitat;
}

/// The terrain as it is for growth, on the lattice: what is dry is land.
HeightField ground_on(const HeightField& terrain, const Grid<uint8_t>* dry, const GridFrame& lattice,
                      const RunContext& run) {
  if (dry == nullptr || dry->empty()) return geom::resample(terrain, lattice, run);
  constexpr float kLand_m = 1.0F;
  HeightField ground = terrain;
  for (size_t i = 0; i < ground.size(); ++i)
    if (dry->cells()[i] != 0) ground.cells()[i] = kLand_m;
  return geom::resample(ground, lattice, run);
}

}  // namespace

double default_lattice_m(const GridFrame& frame) {
  constexpr double kFine_m = 70.0, kCellsASide = 2048.0;
  return std::max({kFine_m, frame.cell_m, std::max(frame.width_m(), frame.height_m()) / kCellsASide});
}

BoundParams bounds_in_light(BoundParams bounds) {
  constexpr double kAwash_m = -0.5;
  if (!bounds.low_m && bounds.high_m.value_or(0.0) <= -bounds.light_depth_m)
    throw InvalidArgument("bounds.high_m", format_number(*bounds.high_m) +
                                               " m lies in the dark, below bounds.light_depth_m (" +
                                               format_number(bounds.light_depth_m) +
                                               " m): raise one of them, or give bounds.low_m as well");
  if (!bounds.low_m) bounds.low_m = -bounds.light_depth_m;
  if (!bounds.high_m) bounds.high_m = kAwash_m;
  return bounds;
}

GridFrame lattice_frame(const GridFrame& frame, double lattice_m) {
  GridFrame lattice = frame;
  const double columns = std::max(1.0, std::round(frame.width_m() / lattice_m));
  const double rows = std::max(1.0, std::round(frame.height_m() / lattice_m));
  if (columns > kMostCells || rows > kMostCells)
    throw InvalidArgument(
        "lattice_m", format_number(lattice_m) + " m gives " + format_number(std::max(columns, rows)) +
                         " cells a side; at most 4096 are possible, so take at least " +
                         format_number(std::ceil(std::max(frame.width_m(), frame.height_m()) / kMostCells)) + " m");
  lattice.width = static_cast<int>(columns);
  lattice.height = static_cast<int>(rows);
  lattice.cell_m = lattice_m;
  lattice.west_m = frame.west_m + 0.5 * (frame.width_m() - lattice.width_m());
  lattice.north_m = frame.north_m - 0.5 * (frame.height_m() - lattice.height_m());
  return lattice;
}

Habitat find_habitat(const HeightField& terrain, const HabitatInputs& in, double lattice_m, double margin_m,
                     const StartParams& starts, const BoundParams& bounds, Seed seed, const RunContext& run) {
  check_size(in.habitat, terrain, "habitat");
  check_size(in.start, terrain, "start");
  Habitat out;
  out.lattice = lattice_frame(terrain.frame(), lattice_m);
  const bool floorless = in.dry != nullptr && !in.dry->empty();
  const HeightField ground = ground_on(terrain, in.dry, out.lattice, run);
  ScalarField share;
  if (in.habitat != nullptr) share = on_lattice(*in.habitat, terrain, out.lattice, run);
  out.suitable = suitable_cells(ground, in.habitat != nullptr ? &share : nullptr, floorless, margin_m, bounds, seed);
  Kernels kernels(out.suitable);
  add_points(starts.points, bounds, ground, kernels);
  add_lines(starts, in.drawing, ground, window_text(bounds), seed, kernels);
  if (in.start != nullptr) {
    const ScalarField where = on_lattice(*in.start, terrain, out.lattice, run);
    Grid<uint8_t> cells = out.suitable;
    for (size_t i = 0; i < cells.size(); ++i) cells.cells()[i] &= where.cells()[i] >= 0.5F ? 1 : 0;
    add_random(std::max(1, starts.random), cells, "start", seed, kernels);
  } else if (starts.random > 0) {
    add_random(starts.random, out.suitable, "starts.random", seed, kernels);
  }
  kernels.clear_free(out.suitable);
  out.kernels = kernels.cells().empty() ? starts_of_pieces(out.suitable, seed) : kernels.cells();
  return out;
}

}  // namespace seamount::reef
