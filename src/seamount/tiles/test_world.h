// What tests of runs in tiles share.
#pragma once

#include <fstream>
#include <sstream>
#include <string>

#include "seamount/recipe/recipe.h"

namespace seamount::tiles {

inline std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// 380 x 295 cells of hills and a mask of what is steep, with these outputs (a JSON list).
inline recipe::Recipe small_world(const std::string& outputs) {
  return recipe::parse_recipe(R"({"seamount": 1, "seed": 4,
  "domain": {"width_m": 9000, "height_m": 7000, "cell_m": 23.7},
  "steps": [
    {"id": "hills", "op": "terrain.noise", "params": {"wavelength_m": 2500, "height_m": 900, "base_m": -120}},
    {"id": "steep", "op": "terrain.mask", "params": {"criteria": [{"tool": "slope", "low_deg": 14, "scale_m": 150}]}}],
  "outputs": )" + outputs + "}",
                              "world.json", "");
}

}  // namespace seamount::tiles
