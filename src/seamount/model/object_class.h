// A class of environmental objects (P3 sec. 1.3.2): its skeleton, where it lives, and what it does to its surroundings.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "seamount/model/class_effects.h"
#include "seamount/model/skeleton.h"
#include "seamount/model/thing_params.h"

namespace seamount {

/// Which of the sampled places a class takes.
enum class Pick : unsigned char { best, weighted };

template <>
struct Choices<Pick> {
  static constexpr std::array<std::string_view, 2> names = {"best", "weighted"};
};

/// How new objects of a class come into being (P3 sec. 1.5.1).
struct Placement {
  int per_iteration = 1;
  int most = 1000;
  double spacing_m = 0.0;
  int samples = 4096;
  Pick pick = Pick::best;
  std::vector<std::string> within;
  std::vector<std::string> outside;
  double finest_cell_m = 0.0;
  double coarsest_cell_m = 1e9;
  bool reinsert = true;
  bool operator==(const Placement&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(&Placement::per_iteration, "per_iteration", "", between(0, 1e6),
              "at most so many are born in an iteration; the paper's is 1, a grove or a colony takes thousands"),
        field(&Placement::most, "most", "", between(0, 1e7), "at most so many live at a time"),
        field(&Placement::spacing_m, "spacing_m", "m", between(0, 1e7),
              "least distance to others of the class at birth"),
        field(&Placement::samples, "samples", "", between(1, 1e7), "places that the fitness is asked at"),
        field(&Placement::pick, "pick",
              "best: the fittest places first; weighted: by lot, in proportion to the fitness over its threshold"),
        field(&Placement::within, "within", "it lives only within objects of one of these classes"),
        field(&Placement::outside, "outside", "it lives only outside the objects of all these classes"),
        field(&Placement::finest_cell_m, "finest_cell_m", "m", between(0, 1e9),
              "it is not placed on grids of finer cells: large things belong to the coarse view"),
        field(&Placement::coarsest_cell_m, "coarsest_cell_m", "m", between(0, 1e9),
              "it is not placed on grids of coarser cells: small things wait for a window"),
        field(&Placement::reinsert, "reinsert", "one that dies is tried again elsewhere in the next iteration"));
  }
};

/// Size of an object, and how its skeleton is fitted (P3 sec. 1.5.2; weights as in eq. 1.27-1.33).
struct Shape {
  double size_m = 1.0;
  double length_m = 100.0;
  double area_m2 = 10000.0;
  double variation = 0.2;
  double internal = 1.0;
  double external = 1.0;
  double target = 1.0;
  double gradient = 0.0;
  double inside = 1.0;
  double border = 0.0;
  int steps = 60;
  bool operator==(const Shape&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(&Shape::size_m, "size_m", "m", between(1e-4, 1e6), "points: diameter of what stands there"),
        field(&Shape::length_m, "length_m", "m", between(1e-3, 1e7), "curves: target length (L of eq. 1.30)"),
        field(&Shape::area_m2, "area_m2", "m^2", between(1e-6, 1e13), "regions: target area (A of eq. 1.33)"),
        field(&Shape::variation, "variation", "", between(0, 2), "deviation of the logarithm of size, length, area"),
        field(&Shape::internal, "internal", "", between(0, 1e3), "weight of tension and stiffness (eq. 1.28)"),
        field(&Shape::external, "external", "", between(0, 1e3),
              "weight of the fitting field along a curve (eq. 1.29)"),
        field(&Shape::target, "target", "", between(0, 1e3), "weight of the target length or area"),
        field(&Shape::gradient, "gradient", "", between(-1e3, 1e3),
              "curves: weight of running along the gradient (eq. 1.31); below 0 across it"),
        field(&Shape::inside, "inside", "", between(-1e3, 1e3), "regions: weight of the inside (lambda 1 of eq. 1.32)"),
        field(&Shape::border, "border", "", between(-1e3, 1e3), "regions: weight of the border (lambda 2)"),
        field(&Shape::steps, "steps", "", between(0, 1e5), "of fitting in an iteration"));
  }
};

/// One class. Expressions are over the words of ops/ecosystem/rules.h.
struct ObjectClass {
  std::string name;
  std::string about;
  SkeletonKind skeleton = SkeletonKind::point;
  std::string fitness;
  std::string fitting;
  double birth = 0.0;
  double death = 0.0;
  Shape shape;
  Placement placement;
  std::vector<Exchange> deposits;
  std::vector<Exchange> absorbs;
  HeightEffect height;
  std::vector<CurrentEffect> currents;
  LabelEffect label;
  std::vector<ThingParams> things;
  double things_spacing_m = 0.0;
  Colour colour{200, 90, 60};
  bool operator==(const ObjectClass&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(&ObjectClass::name, "name", "as expressions call it: small letters, digits and _"),
        field(&ObjectClass::about, "about", "one line for those who read the catalogue"),
        field(&ObjectClass::skeleton, "skeleton", "point, curve or region"),
        field(&ObjectClass::fitness, "fitness", "expression: how well a place suits it"),
        field(&ObjectClass::fitting, "fitting", "expression that its skeleton climbs; empty: the fitness"),
        field(&ObjectClass::birth, "birth", "", Range{}, "it is born only where the fitness is above this"),
        field(&ObjectClass::death, "death", "", Range{}, "it dies once its fitness is below this"),
        field(&ObjectClass::shape, "shape", "its size, and how its skeleton is fitted"),
        field(&ObjectClass::placement, "placement", "how many are born, and where they may be"),
        field(&ObjectClass::deposits, "deposits", "materials that it gives to its surroundings"),
        field(&ObjectClass::absorbs, "absorbs", "materials that it takes from its surroundings"),
        field(&ObjectClass::height, "height", "what it does to the ground"),
        field(&ObjectClass::currents, "currents", "what it does to the current"),
        field(&ObjectClass::label, "label", "which region of a label map it is"),
        field(&ObjectClass::things, "things", "what stands there in three dimensions; of several one each by lot"),
        field(&ObjectClass::things_spacing_m, "things_spacing_m", "m", between(0, 1e5),
              "curves and regions: distance of the things along and within them; 0: none stand there"),
        field(&ObjectClass::colour, "colour", "on maps"));
  }
};

}  // namespace seamount
