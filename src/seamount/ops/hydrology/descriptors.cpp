#include "seamount/ops/hydrology/descriptors.h"

#include <array>
#include <string>

#include "seamount/ops/hydrology/describe_curves.h"
#include "seamount/ops/hydrology/describe_distributions.h"
#include "seamount/ops/hydrology/describe_networks.h"

namespace seamount::hydrology {

std::vector<Measure> make_settings(const std::vector<Survey>& surveys, const SurveyPlan& plan) {
  std::vector<Measure> settings = {{"cell", "m", {}},
                                   {"land", "m2", {}},
                                   {"channel", "m2", {}},
                                   {"min_prominence", "m", {}},
                                   {"relief_window", "m", {}}};
  for (const Survey& one : surveys) {
    const std::array values = {one.cell_m, one.land_m2, plan.channel_m2, plan.min_prominence_m, one.relief_window_m};
    for (size_t i = 0; i < values.size(); ++i) settings[i].values.push_back(values[i]);
  }
  return settings;
}

std::vector<Descriptor> make_descriptors(const std::vector<Survey>& surveys, const SurveyPlan& plan) {
  constexpr const char* kOverDeviation = " Distance: Wasserstein of the distributions, over the reference's deviation.";
  const auto distribution = [&](const char* name, const char* title, const char* unit, const std::string& meaning,
                                const char* axis, Distribution Survey::*of, bool logarithmic = false) {
    const std::string full = meaning + kOverDeviation;
    return describe_cells(surveys, {name, title, unit, full.c_str(), axis, of, logarithmic});
  };
  return {distribution("elevation", "Elevation", "m", "Height above sea level.", "elevation (m)", &Survey::elevation),
          describe_hypsometry(surveys),
          distribution("slope", "Slope", "deg", "Steepness.", "slope (deg)", &Survey::slope),
          describe_aspect(surveys),
          distribution("curvature", "Curvature", "1/m", "Mean curvature, positive on crests, negative in hollows.",
                       "curvature (1/m)", &Survey::curvature),
          distribution("local_relief", "Local relief", "m", "Highest less lowest height in a square around each cell.",
                       "relief (m)", &Survey::relief),
          distribution("drainage_area", "Drainage area", "m2", "Ground whose water passes through a cell, as log10.",
                       "drainage area (m2)", &Survey::area, true),
          describe_slope_area(surveys),
          describe_strahler(surveys),
          describe_ridges(surveys),
          describe_prominence(surveys, plan),
          describe_isolation(surveys),
          describe_roughness(surveys)};
}

}  // namespace seamount::hydrology
