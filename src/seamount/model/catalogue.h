// What may grow in a scene and by which rules (P3 sec. 1.3, 1.4.1): materials, and classes of objects. Written by
// people as JSON (docs/guide/ecosystems.md); expressions are text here and compiled by ops/ecosystem/rules.h.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "seamount/model/object_class.h"

namespace seamount {

/// A stock that objects deposit and absorb and that currents and slopes carry (P3 sec. 1.6.1).
struct Material {
  std::string name;
  std::string about;
  double density = 0.0;
  double flow_coupling = 0.0;
  double diffusivity_m2_s = 1.0;
  double decay_1_s = 0.01;
  Colour colour{205, 180, 130};
  bool operator==(const Material&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(&Material::name, "name", "as expressions call it: small letters, digits and _"),
        field(&Material::about, "about", "one line for those who read the catalogue"),
        field(&Material::density, "density", "m/s", between(-100, 100),
              "drift down a slope of 1 (rho of eq. 1.36); 0: slopes do not move it"),
        field(&Material::flow_coupling, "flow_coupling", "", between(-100, 100),
              "share of the current that carries it (nu of eq. 1.36); below 0 against it"),
        field(&Material::diffusivity_m2_s, "diffusivity_m2_s", "m^2/s", between(0, 1e6), "how it spreads by itself"),
        field(&Material::decay_1_s, "decay_1_s", "1/s", between(0, 1e3), "share that is lost in a second"),
        field(&Material::colour, "colour", "on maps"));
  }
};

/// One material turns into another: what `from` loses, `to` gains, times the yield.
struct Transformation {
  std::string from;
  std::string to;
  double rate_1_s = 0.001;
  double yield = 1.0;
  bool operator==(const Transformation&) const = default;

  static constexpr auto fields() {
    return std::tuple(
        field(&Transformation::from, "from", "the material that is used up"),
        field(&Transformation::to, "to", "the material that it becomes"),
        field(&Transformation::rate_1_s, "rate_1_s", "1/s", between(0, 1e3), "share of it that turns in a second"),
        field(&Transformation::yield, "yield", "", between(0, 1e3), "how much comes of one"));
  }
};

/// All of it. Names are unique; what names another thing of the catalogue names one that is there
/// (recipe/catalogue_json.h checks it with places, ops/ecosystem/rules.h for those who build one in C++).
struct Catalogue {
  std::string name;
  std::string about;
  std::vector<Material> materials;
  std::vector<ObjectClass> classes;
  std::vector<Transformation> transformations;
  bool operator==(const Catalogue&) const = default;

  static constexpr auto fields() {
    return std::tuple(field(&Catalogue::name, "name", "of the catalogue"),
                      field(&Catalogue::about, "about", "what it describes"),
                      field(&Catalogue::materials, "materials", "stocks that objects deposit and absorb"),
                      field(&Catalogue::classes, "classes", "kinds of objects, in the order in which they are placed"),
                      field(&Catalogue::transformations, "transformations", "of one material into another"));
  }
};

}  // namespace seamount
