// Parameters of contour.grow (grow.h).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"

namespace seamount::contour {

enum class ProbabilityKind { uniform, noise };

struct GrowParams {
  std::vector<RegionOutline> outlines;
  FilePath regions;
  std::string feature;
  std::string layer;
  std::string height_field;
  std::string crs;
  std::vector<RiverLine> rivers;
  bool darkest_is_land = false;
  std::optional<double> irregularity;
  std::optional<double> spacing_m;
  int particles = 50000;
  ProbabilityKind probability = ProbabilityKind::noise;
  FilePath probability_picture;
  std::optional<double> feature_m;
  int octaves = 5;
  double exponent = 2.0;

  static constexpr auto fields() {
    using P = GrowParams;
    return std::tuple(
        field(
            &P::outlines, "outlines", "m", between(-12000, 9000),
            "nested regions, each with a name, a ring, the height of its outline if wanted, and whether it is a basin"),
        field(&P::regions, "regions",
              "the regions instead as a GeoJSON, GeoPackage, Shapefile or SVG, or as a picture whose grey levels are "
              "nested "
              "regions"),
        field(&P::feature, "feature", "only the areas of this name in the file `regions`"),
        field(&P::layer, "layer", "layer of the file `regions`; empty: the first with areas or lines"),
        field(&P::height_field, "height_field",
              "field of the file `regions` with the heights of outlines; empty: one named like a height"),
        field(&P::crs, "crs",
              "coordinate system of the file `regions` where it says none or a wrong one: EPSG:32627, or local for "
              "metres"),
        field(&P::rivers, "rivers",
              "rivers from source to mouth, each with its bed at all points, at source and mouth, at the mouth, or "
              "none, and the width of its valley floor"),
        field(&P::darkest_is_land, "darkest_is_land",
              "the darkest grey of a picture is the lowest region instead of the world outside"),
        field(&P::irregularity, "irregularity", "", between(0, 1),
              "detail given to outlines drawn with few points: round corners, bays and headlands smaller than their "
              "sides; 0 keeps every point; absent: 0.4 where `outlines` are given, else 0"),
        field(&P::spacing_m, "spacing_m", "m", between(1e-3, 1e6),
              "least distance between nodes; absent: what gives `particles`"),
        field(&P::particles, "particles", "", between(1, 16e6),
              "number of nodes in the regions, within a few per cent; more where regions are too small for so few"),
        field(&P::probability, "probability",
              "where growth runs ahead and cuts valleys: uniform: nowhere, rings that follow the outline; noise: along "
              "fractal noise; the input 'probability' replaces it"),
        field(&P::probability_picture, "probability_picture",
              "the probability as a picture laid over the domain, black 0 to white 1"),
        field(&P::feature_m, "feature_m", "m", between(1e-3, 1e7),
              "size of the noise's largest forms; absent: a third of the regions' size"),
        field(&P::octaves, "octaves", "", between(1, 16), "layers of detail of the noise, each of half the size"),
        field(&P::exponent, "exponent", "", between(0.05, 20),
              "power to which probabilities are raised: higher values carve narrower, deeper valleys"));
  }
};

}  // namespace seamount::contour

template <>
struct seamount::Choices<seamount::contour::ProbabilityKind> {
  static constexpr std::array<std::string_view, 2> names = {"uniform", "noise"};
};
