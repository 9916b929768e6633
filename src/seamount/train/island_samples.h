// Training pairs of islands: label map and height field.
//
// Source: P0 sec. 1.5, Algorithm 3, eq. 1.16 to 1.18, and the augmentations of sec. 1.5.1. A sample is a function of
// (seed, index) alone: IslandSample holds every number that was drawn, so that any sample can be made again without the
// others.
#pragma once

#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount::train {

/// What all samples of a set share.
struct IslandSetParams {
  int size = 256;
  double width_m = 20480;
  int levels = 4;
  double low_m = -1600;
  double high_m = 2400;
  double several = 0.3;

  static constexpr auto fields() {
    using P = IslandSetParams;
    return std::tuple(
        field(&P::size, "size", "", between(16, 4096), "cells a side of each sample"),
        field(&P::width_m, "width_m", "m", between(100, 1e6), "width of the ground that a sample shows"),
        field(&P::levels, "levels", "", between(1, 64), "levels of subsidence that each island is made for"),
        field(&P::low_m, "low_m", "m", between(-12000, 0), "height of code 0 in the height images"),
        field(&P::high_m, "high_m", "m", between(1, 9000), "height of code 65535"),
        field(&P::several, "several", "", between(0, 1), "share of samples with several islands (copy and paste)"));
  }
};

/// One island before augmentation: everything that Algorithm 3 draws at random.
struct IslandDraw {
  double index = 0;  ///< of the island; the levels of subsidence share it
  std::vector<PolarOutline> outlines;
  Curve profile;
  Curve resistance;
  std::vector<Stroke> strokes;
  int radial_count = 0;
  double radial_width_m = 100;
  double radial_strength_m = 0;
  double relief = 0;
  double valley_spacing_m = 1000;

  static constexpr auto fields() {
    using P = IslandDraw;
    return std::tuple(
        field(&P::index, "index", "number of the island, from which its noise follows"),
        field(&P::outlines, "outlines", "m", at_least(0), "r(theta) = r* + noise for each outline (eq. 1.16)"),
        field(&P::profile, "profile", "m", between(-12000, 12000), "profile times noise (eq. 1.17)"),
        field(&P::resistance, "resistance", "", between(0, 1), "resistance times noise (eq. 1.18)"),
        field(&P::strokes, "strokes", "random strokes of wind"),
        field(&P::radial_count, "radial_count", "", between(0, 1000), "radial strokes (fig. 1.38)"),
        field(&P::radial_width_m, "radial_width_m", "m", between(0.1, 1e5), "their width"),
        field(&P::radial_strength_m, "radial_strength_m", "m", between(0, 1e5), "their strength"),
        field(&P::relief, "relief", "", between(0, 2), "depth of valleys"),
        field(&P::valley_spacing_m, "valley_spacing_m", "m", between(1, 1e6), "distance between valleys"));
  }
};

/// Where and how islands come to lie in a sample (sec. 1.5.1).
struct Augmentation {
  Polyline places;  ///< one per island
  std::vector<double> turns_deg;
  std::vector<double> scales;
  bool flip = false;  ///< west and east exchanged before turning
  int shift_x = 0;    ///< wrapping translation, in cells
  int shift_y = 0;

  static constexpr auto fields() {
    using P = Augmentation;
    return std::tuple(
        field(&P::places, "places", "where each island's centre lies"),
        field(&P::turns_deg, "turns_deg", "deg", between(-360, 360), "how far each is turned"),
        field(&P::scales, "scales", "", between(0.05, 5), "how much each is scaled"),
        field(&P::flip, "flip", "mirrored"),
        field(&P::shift_x, "shift_x", "", between(-65536, 65536), "wrapping translation in cells, eastwards"),
        field(&P::shift_y, "shift_y", "", between(-65536, 65536), "wrapping translation in cells, southwards"));
  }
};

struct IslandSample {
  uint64_t index = 0;
  double subsidence = 0;
  std::vector<IslandDraw> islands;
  Augmentation augmentation;
};

struct IslandPair {
  HeightField terrain;
  LabelMap labels;
};

/// A profile or resistance times noise around 1 (eq. 1.17, 1.18): f(x) (1 + amplitude eta(x)), clamped to [low, high],
/// at every tenth of a region; values rounded to thousandths. eta is broad (two octaves): finer noise would ring the
/// island with terraces.
Curve times_noise(const Curve& curve, double amplitude, double low, double high, Seed seed);

/// Draws everything for sample `index` of a set. Throws InvalidArgument for params out of range.
IslandSample draw_island_sample(const IslandSetParams& params, uint64_t index, Seed seed);

/// Makes a sample. `terrain` is in metres, `labels` the regions before subsidence, which the image's value carries (P0
/// sec. 1.5). The islands of a sample overlap by at most 0.1 of intersection over union, counted where they are not
/// abyss; those that would are left out, so `sample` says afterwards what is in the picture. About 15 ms of CPU time at
/// 256 x 256 and island.
IslandPair make_island_pair(const IslandSetParams& params, IslandSample& sample, Seed seed, const RunContext& run);

/// Intersection over union of what is not abyss.
double overlap(const LabelMap& a, const LabelMap& b);

/// Cells moved by (shift_x, shift_y), wrapping around the borders.
template <class T>
Grid<T> wrapped(const Grid<T>& grid, int shift_x, int shift_y) {
  Grid<T> out(grid.frame());
  const auto wrap = [](int v, int size) { return (v % size + size) % size; };
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x)
      out(wrap(x + shift_x, grid.width()), wrap(y + shift_y, grid.height())) = grid(x, y);
  }
  return out;
}

}  // namespace seamount::train
