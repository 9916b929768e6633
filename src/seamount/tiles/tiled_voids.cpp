#include "seamount/tiles/tiled_voids.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/grid/voids.h"
#include "seamount/geom/solve/fill_voids.h"
#include "seamount/recipe/kinds.h"
#include "seamount/tiles/patches.h"
#include "seamount/tiles/tiled_ways.h"

namespace seamount::tiles {
namespace {

using recipe::kinds::Terrain;

constexpr double kBytes = 40;  // of a cell of a window, while it is solved

HeightField heights_of(const StoredRaster& raster, const Rect& rect) { return raster.read(rect).get<Terrain>(); }

TilePatches<Patch> holes_of(const HeightField& heights, const Rect& rect) {
  return find_patches<Patch>(
      heights.frame(), rect, [&](int32_t cell) { return std::isnan(heights.data()[cell]); },
      [](int32_t, int32_t) { return true; });
}

bool on_rim(const Patch& hole, const Rect& rect) {
  const Rect& at = hole.around;
  return at.column == rect.column || at.row == rect.row || at.column + at.width == rect.column + rect.width ||
         at.row + at.height == rect.row + rect.height;
}

/// A hole's own cells and one more on each side where the raster goes on.
Rect window_of_hole(const Patch& hole, const Layout& layout) {
  const Rect& at = hole.around;
  return common({at.column - 1, at.row - 1, at.width + 2, at.height + 2}, {0, 0, layout.width, layout.height});
}

/// The filled window of a hole.
struct Filled {
  Rect window;
  HeightField heights;
};

class VoidFilling {
 public:
  VoidFilling(const World& world, const StoredRaster& from, const RunContext& run)
      : world_(world), from_(from), layout_(from.layout()) {
    for (int tile = 0; tile < layout_.count(); ++tile) {
      look_at(tile);
      run.report(static_cast<double>(tile + 1) / layout_.count());
    }
    if (voids_ == from.frame().cells())
      throw IncompatibleInputs("none of the " + std::to_string(voids_) + " cells has a value");
    across_.join(layout_, [](const Patch&, const Patch&) { return true; });
    for (const Patch& hole : across_.all())
      if (hole.cells > 0) add_window(hole);
    if (geom::filled_as_one(windows_, from.frame().cells()))
      throw NeedsWhole{"holes so many and so long are filled as one"};
  }

  int64_t voids() const { return voids_; }

  HeightField tile(int index, const RunContext& run) {
    const Rect rect = layout_.tile(index);
    HeightField heights = heights_of(from_, rect);
    if (!geom::any_void(heights.cells())) return heights;
    const TilePatches<Patch> holes = holes_of(heights, rect);
    std::vector<const Filled*> of(holes.all.size(), nullptr);
    std::vector<Filled> own(holes.all.size());
    std::vector<size_t> inside;
    int32_t rim = 0;
    for (size_t k = 0; k < holes.all.size(); ++k) {
      if (on_rim(holes.all[k], rect))
        of[k] = &filled_across(across_.whole_of(index, rim++), run);
      else
        inside.push_back(k);
    }
    parallel_blocks(run, static_cast<int64_t>(inside.size()), 1, [&](int64_t i, int64_t) {
      const size_t k = inside[static_cast<size_t>(i)];
      own[k] = filled(holes.all[k], run);
      of[k] = &own[k];
    });
    for (int y = 0; y < rect.height; ++y) {
      for (int x = 0; x < rect.width; ++x) {
        if (holes.of(x, y) < 0) continue;
        const Filled& hole = *of[static_cast<size_t>(holes.of(x, y))];
        heights(x, y) = hole.heights(rect.column + x - hole.window.column, rect.row + y - hole.window.row);
      }
    }
    forget_before(index + 1);
    return heights;
  }

 private:
  /// Finds a tile's holes; those that may go on beside it are kept.
  void look_at(int tile) {
    const Rect rect = layout_.tile(tile);
    const HeightField heights = heights_of(from_, rect);
    if (!geom::any_void(heights.cells())) return across_.add_tile({}, {});
    const TilePatches<Patch> holes = holes_of(heights, rect);
    std::vector<Patch> kept;
    std::vector<int32_t> number(holes.all.size(), -1);
    for (size_t k = 0; k < holes.all.size(); ++k) {
      voids_ += holes.all[k].cells;
      if (on_rim(holes.all[k], rect)) {
        number[k] = static_cast<int32_t>(kept.size());
        kept.push_back(holes.all[k]);
      } else {
        add_window(holes.all[k]);
      }
    }
    std::vector<int32_t> of_rim = patches_of_rim(holes, layout_, tile);
    for (int32_t& hole : of_rim)
      if (hole >= 0) hole = number[static_cast<size_t>(hole)];
    across_.add_tile(kept, kept.empty() ? std::vector<int32_t>() : std::move(of_rim));
  }

  void add_window(const Patch& hole) {
    windows_ += geom::hole_window(hole.around.width, hole.around.height);
    const Rect window = window_of_hole(hole, layout_);
    if (!world_.fits(kBytes * static_cast<double>(window.cells()), {window.width, window.height}))
      throw NeedsWhole{"a hole of " + std::to_string(hole.around.width) + " x " + std::to_string(hole.around.height) +
                       " cells is filled as a whole"};
  }

  Filled filled(const Patch& hole, const RunContext& run) const {
    const Rect window = window_of_hole(hole, layout_);
    Filled made{window, heights_of(from_, window)};
    const RunContext quiet{run.threads, {}, run.cancelled, {}};
    const int64_t first = int64_t{hole.first.row - window.row} * window.width + hole.first.column - window.column;
    geom::fill_hole(made.heights, first, quiet);
    return made;
  }

  const Filled& filled_across(int32_t hole, const RunContext& run) {
    const auto known = filled_.find(hole);
    if (known != filled_.end()) return known->second;
    const Patch& patch = across_.all()[static_cast<size_t>(hole)];
    double bytes = kBytes * static_cast<double>(window_of_hole(patch, layout_).cells());
    for (const auto& [other, kept] : filled_) bytes += sizeof(float) * static_cast<double>(kept.window.cells());
    const Rect window = window_of_hole(patch, layout_);
    world_.check_fits(bytes, "holes that reach over several tiles", "are kept until they are written",
                      {window.width, window.height});
    return filled_.emplace(hole, filled(patch, run)).first->second;
  }

  /// Lets go of holes of which no tile from `tile` on has a part.
  void forget_before(int tile) {
    std::erase_if(filled_, [&](const auto& item) {
      const Rect& at = across_.all()[static_cast<size_t>(item.first)].around;
      const int last =
          (at.row + at.height - 1) / layout_.size * layout_.columns() + (at.column + at.width - 1) / layout_.size;
      return last < tile;
    });
  }

  const World& world_;
  const StoredRaster& from_;
  const Layout& layout_;
  int64_t voids_ = 0, windows_ = 0;
  JoinedPatches<Patch> across_;
  std::map<int32_t, Filled> filled_;  ///< of those across tiles, by their places in all()
};

}  // namespace

int64_t fill_tiled_voids(const World& world, const StoredRaster& from, const StoredRaster& to, const RunContext& run) {
  VoidFilling filling(world, from, run.part(0.0, 0.3));
  const RunContext writing = run.part(0.3, 1.0), quiet{run.threads, {}, run.cancelled, {}};
  const int count = from.layout().count();
  for (int tile = 0; tile < count; ++tile) {
    run.check_cancelled();
    if (!to.has(tile)) to.write(tile, recipe::Value::of<Terrain>(filling.tile(tile, quiet)));
    writing.report(static_cast<double>(tile + 1) / count);
  }
  return filling.voids();
}

}  // namespace seamount::tiles
