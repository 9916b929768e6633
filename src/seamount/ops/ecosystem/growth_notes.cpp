#include "seamount/ops/ecosystem/growth_notes.h"

#include <cmath>
#include <string>

#include "seamount/base/text.h"

namespace seamount::ecosystem {
namespace {

std::string place_text(Vec2 p) {
  return "(" + format_number(std::round(p.x * 10) / 10) + ", " + format_number(std::round(p.y * 10) / 10) + ")";
}

std::string short_text(double value) {
  if (value == 0.0 || !std::isfinite(value)) return format_number(value);
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3);
  return format_number(std::round(value / unit) * unit);
}

/// Why a class is not there, or not as often as wanted.
std::string reason(const ObjectClass& of, const History& history) {
  if (history.wrong_cell)
    return "its placement asks for cells of " + format_number(of.placement.finest_cell_m) + " to " +
           format_number(of.placement.coarsest_cell_m) + " m";
  if (history.prospects.asked == 0) return "there is none of the regions that it lives within";
  if (!history.prospects.largest) return "no place is allowed, or the fitness has no value anywhere";
  if (*history.prospects.largest <= of.birth)
    return "the largest fitness found was " + short_text(*history.prospects.largest) + " at " +
           place_text(history.prospects.where) + ", it is born above " + format_number(of.birth);
  if (history.born == 0 && history.unfitted > 0) return "no skeleton could grow where it is fit";
  if (history.died > 0) return std::to_string(history.died) + " died of " + std::to_string(history.born) + " born";
  return "there was no room left, or the iterations ended";
}

}  // namespace

void say_what_became(const Scene& scene, std::span<const History> histories, std::span<const int> wanted, int window,
                     const RunContext& run) {
  std::vector<int> living(histories.size(), 0);
  for (const SceneObject& object : scene.objects)
    if (object.window == window) ++living[static_cast<size_t>(object.of_class)];
  for (size_t c = 0; c < histories.size(); ++c) {
    const ObjectClass& of = scene.catalogue.classes[c];
    const History& history = histories[c];
    const bool asked = history.prospects.asked > 0 || history.wrong_cell;
    if (wanted[c] >= 0 && living[c] < wanted[c]) {
      run.say(of.name + ": " + std::to_string(living[c]) + " of " + std::to_string(wanted[c]) +
              " wanted: " + reason(of, history));
    } else if (asked && history.born == 0 && living[c] == 0 && !history.wrong_cell) {
      run.say(of.name + ": none was born: " + reason(of, history));
    }
    if (history.prospects.without_value > 0) {
      run.say(of.name + ": its fitness has no value at " + std::to_string(history.prospects.without_value) + " of " +
              std::to_string(history.prospects.asked) + " places, such as " + place_text(*history.prospects.no_number) +
              "; nothing is born there");
    }
  }
}

}  // namespace seamount::ecosystem
