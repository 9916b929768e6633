#include "seamount/geom/mesh/terrain_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/mesh/cell_surface.h"
#include "seamount/geom/mesh/water_sheet.h"

namespace seamount::geom {
namespace {

void check_options(const HeightField& heights, const MeshOptions& options) {
  if (heights.width() < 2 || heights.height() < 2)
    throw InvalidArgument("heights", "a mesh needs at least 2 x 2 cells");
  for (const float z : heights.cells())
    if (std::isinf(z)) throw InvalidArgument("heights", "a cell is not finite");
  if (!(options.vertical_scale > 0) || !std::isfinite(options.vertical_scale))
    throw InvalidArgument("vertical_scale", format_number(options.vertical_scale) + " is not above 0");
  if (options.max_triangles < 0) throw InvalidArgument("max_triangles", "is negative");
  if (!(options.max_error_m >= 0) || !std::isfinite(options.max_error_m))
    throw InvalidArgument("max_error_m", "is negative");
  if (!(options.base_m >= 0) || !std::isfinite(options.base_m)) throw InvalidArgument("base_m", "is negative");
}

MeshDomain checked_domain(const HeightField& heights, const MeshOptions& options, const RunContext& run) {
  check_options(heights, options);
  MeshDomain domain(heights, run);
  if (domain.triangles() == 0)
    throw InvalidArgument("heights", "no three neighbouring cells have heights: there is nothing to make a mesh of");
  const int64_t voids = heights.frame().cells() - domain.known_cells();
  if (voids > 0) run.say(fmt::format("{} cells without a height are holes in the mesh", voids));
  if (domain.left_out_cells() > 0)
    run.say(fmt::format("{} cells have a height and too few neighbours with one to be in the mesh",
                        domain.left_out_cells()));
  return domain;
}

/// One level of detail: a mesh of each tile.
class Level {
 public:
  Level(const HeightField& heights, const MeshDomain& domain, const TileCuts& cuts, const TerrainFitOptions& options,
        const std::vector<LatticePoint>& borders, const RunContext& run)
      : heights_(heights), domain_(domain), cuts_(cuts) {
    const bool all = options.max_triangles >= domain.triangles();
    if (options.max_error_m == 0 && (options.max_triangles == 0 || all)) return;
    TerrainFitOptions wanted = options;
    if (all) wanted.max_triangles = 0;
    fit_.emplace(heights, domain, cuts, wanted);
    fit_->refine(borders, run);
  }

  CellMesh tile(int column, int row, const RunContext& run) const {
    return fit_ ? fit_->tile(column, row, run) : every_cell(heights_, domain_, cuts_.box(column, row));
  }

  std::vector<LatticePoint> border_vertices() const {
    if (fit_) return fit_->border_vertices();
    std::vector<LatticePoint> cells;
    const auto take = [&](int x, int y) {
      if (domain_.holds({x, y})) cells.push_back({x, y});
    };
    for (const int y : cuts_.rows)
      for (int x = 0; x < heights_.width(); ++x) take(x, y);
    for (const int x : cuts_.columns)
      for (int y = 0; y < heights_.height(); ++y) take(x, y);
    return cells;
  }

 private:
  const HeightField& heights_;
  const MeshDomain& domain_;
  const TileCuts& cuts_;
  std::optional<TerrainFit> fit_;
};

double rms(const SurfaceError& error) {
  return error.cells > 0 ? std::sqrt(error.square_sum / static_cast<double>(error.cells)) : 0.0;
}

/// "mesh of 400000 triangles, at most 1.8 m from the terrain, 0.2 m rms".
/// `triangles` are those of the ground.
void say_error(const std::string& what, size_t triangles, const SurfaceError& error, const TerrainFitOptions& wanted,
               const RunContext& run) {
  std::string line = fmt::format("{} of {} triangles, ", what, triangles);
  line += error.largest_m > 0
              ? fmt::format("at most {:.3g} m from the terrain, {:.3g} m rms", error.largest_m, rms(error))
              : "exactly the terrain";
  if (wanted.max_error_m > 0 && error.largest_m > wanted.max_error_m)
    line += fmt::format("; max_triangles are too few for a max_error_m of {}", format_number(wanted.max_error_m));
  if (wanted.max_triangles > 0 && triangles > static_cast<size_t>(wanted.max_triangles))
    line += fmt::format("; its borders and the rims of holes need more than {}", wanted.max_triangles);
  run.say(line);
}

float lowest_of(const MeshPart& part) {
  float lowest = std::numeric_limits<float>::infinity();
  for (size_t i = 2; i < part.positions.size(); i += 3) lowest = std::min(lowest, part.positions[i]);
  return lowest;
}

Mesh mesh_of(const CellMesh& cells, const HeightField& heights, const CellBox& box, const MeshOptions& options,
             Vec2 offset, const RunContext& run) {
  const GridFrame& frame = heights.frame();
  const CellPlaces places(frame);
  Mesh mesh{.parts = {surface(cells, heights, options.vertical_scale, places, offset, run)},
            .origin = {frame.west_m + 0.5 * frame.width_m(), frame.north_m - 0.5 * frame.height_m()},
            .crs = frame.crs,
            .vertical_scale = options.vertical_scale,
            .offset = offset,
            .largest_error_m = cells.error.largest_m,
            .rms_error_m = rms(cells.error)};
  if (options.water && options.base_m == 0 && lowest_of(mesh.parts[0]) < 0) {
    if (std::optional<MeshPart> water = water_sheet(heights, options.hollows, places, box, offset))
      mesh.parts.push_back(std::move(*water));
  }
  return mesh;
}

}  // namespace

Mesh make_mesh(const HeightField& heights, const MeshOptions& options, const RunContext& run) {
  const MeshDomain domain = checked_domain(heights, options, run.part(0, 0.1));
  const TileCuts cuts{{0, heights.width() - 1}, {0, heights.height() - 1}};
  const TerrainFitOptions wanted{options.max_triangles, options.max_error_m};
  const Level level(heights, domain, cuts, wanted, {}, run.part(0.1, 0.6));
  const CellMesh cells = level.tile(0, 0, run.part(0.6, 0.8));
  Mesh mesh = mesh_of(cells, heights, cuts.box(0, 0), options, {}, run.part(0.8, 0.9));
  std::string what = "mesh";
  if (options.base_m > 0) {
    const float lowest = lowest_of(mesh.parts[0]);
    const auto floor = static_cast<float>(double{lowest} - options.base_m);
    close_below(mesh.parts[0], cells, domain, CellPlaces(heights.frame()), {},
                std::min(floor, std::nextafter(lowest, -std::numeric_limits<float>::infinity())), run.part(0.9, 1.0));
    what = fmt::format("solid of {} triangles, its ground", mesh.parts[0].triangle_count());
  }
  say_error(what, cells.corners.size() / 3, cells.error, wanted, run);
  run.report(1.0);
  return mesh;
}

void make_mesh_tiles(const HeightField& heights, const MeshOptions& options, const MeshTiling& tiling,
                     const std::function<void(const MeshTile&)>& take, const RunContext& run) {
  if (tiling.across < 1) throw InvalidArgument("tiles", "is below 1");
  if (tiling.levels < 1) throw InvalidArgument("lods", "is below 1");
  if (options.base_m > 0) throw InvalidArgument("base_m", "tiles are open surfaces; it must be 0");
  const MeshDomain domain = checked_domain(heights, options, run.part(0, 0.1));
  const int right = heights.width() - 1, bottom = heights.height() - 1, longer = std::max(right, bottom);
  const auto parts = [&](int steps) {
    return std::clamp(static_cast<int>(std::lround(static_cast<double>(tiling.across) * steps / longer)), 1, steps);
  };
  const TileCuts cuts{even_cuts(right, parts(right)), even_cuts(bottom, parts(bottom))};
  const CellPlaces places(heights.frame());
  TerrainFitOptions wanted{options.max_triangles, options.max_error_m};
  std::vector<LatticePoint> borders;
  for (int k = 0; k < tiling.levels; ++k) {
    const RunContext part = run.part(0.1 + 0.9 * k / tiling.levels, 0.1 + 0.9 * (k + 1) / tiling.levels);
    const Level level(heights, domain, cuts, wanted, borders, part.part(0, 0.5));
    if (k == 0) borders = level.border_vertices();
    SurfaceError error;
    size_t triangles = 0;
    for (int row = 0; row < cuts.down(); ++row) {
      for (int column = 0; column < cuts.across(); ++column) {
        run.check_cancelled();
        const CellMesh cells = level.tile(column, row, {.threads = run.threads});
        if (cells.corners.empty()) continue;
        error.add(cells.error);
        triangles += cells.corners.size() / 3;
        const CellBox box = cuts.box(column, row);
        const Vec2 middle{places.x(0.5 * (box.first.x + box.last.x)), places.y(0.5 * (box.first.y + box.last.y))};
        take({column, row, k, mesh_of(cells, heights, box, options, middle, {.threads = run.threads})});
      }
    }
    say_error(fmt::format("level {}: {} x {} tiles", k, cuts.across(), cuts.down()), triangles, error, wanted, run);
    const int64_t before = wanted.max_triangles > 0 ? wanted.max_triangles : domain.triangles();
    if (options.max_error_m == 0 || options.max_triangles > 0) wanted.max_triangles = std::max<int64_t>(1, before / 4);
    wanted.max_error_m *= 2;
    part.report(1.0);
  }
}

}  // namespace seamount::geom
