// What the words and functions of expressions mean, for people: references are made of it.
#pragma once

#include <array>
#include <string_view>

namespace seamount::ecosystem {

struct WordHelp {
  std::string_view word;
  std::string_view meaning;
};

inline constexpr std::array kWordHelp = {
    WordHelp{"height", "metres over the water level"},
    WordHelp{"depth", "metres under the water level"},
    WordHelp{"ground", "metres over z = 0"},
    WordHelp{"slope_deg", "slope of the ground, degrees"},
    WordHelp{"gradient_x", "rise over run of the ground towards east"},
    WordHelp{"gradient_y", "rise over run of the ground towards north"},
    WordHelp{"current", "speed of the water, m/s"},
    WordHelp{"current_x", "its component towards east"},
    WordHelp{"current_y", "its component towards north"},
    WordHelp{"x", "metres east"},
    WordHelp{"y", "metres north"},
    WordHelp{"age", "iterations since birth; 0 for what is not born yet"},
    WordHelp{"iteration", "iterations done, of the scene or the window"},
    WordHelp{"water_level", "metres over z = 0"},
    WordHelp{"MATERIAL", "concentration of the material of that name"},
    WordHelp{
        "distance(CLASS)",
        "metres to the nearest object of a class; 0 within a region; the diagonal of the frame where there is none"},
    WordHelp{"border(CLASS)", "the same, but to the outline within regions as well"},
    WordHelp{"inside(CLASS)", "1 within a region of the class, else 0"},
    WordHelp{"normal_x(CLASS)", "east component of the unit vector from the nearest one to the place; 0 without one"},
    WordHelp{"normal_y(CLASS)", "its north component"},
    WordHelp{"curvature(CLASS)",
             "1/m, of the nearest curve or outline at its nearest point; above 0 where a region bulges"},
    WordHelp{
        "screened(CLASS)",
        "distance as a field that spreads from the class and decays tells it (P3 eq. 1.39): smooth where the exact one "
        "has creases, itself included; larger beside single points"},
    WordHelp{"noise(METRES)", "gradient noise of that wavelength, about -1 to 1, of the scene's seed"},
};

inline constexpr std::array kFunctionHelp = {
    WordHelp{"+ - * / ^", "as usual; -a^2 is -(a^2)"},
    WordHelp{"< <= > >= == !=", "1 where it holds, else 0"},
    WordHelp{"&& || !", "and, or, not of what is 0 and what is not"},
    WordHelp{"a ? b : c", "b where a is not 0, else c"},
    WordHelp{"min(a, b, ...) max(a, b, ...)", "the least and the largest"},
    WordHelp{"clamp(a, low, high)", "a, but not below low nor above high"},
    WordHelp{"ramp(a, from, to)", "0 at from, 1 at to, straight between; from may be above to"},
    WordHelp{"step(a, from, to)", "the same, smoothly"},
    WordHelp{"bell(a, centre, width)", "1 at the centre, falling off as a Gaussian of that deviation"},
    WordHelp{"abs sqrt exp log log10 sin cos tan floor round sign", "of one number; angles in radians"},
    WordHelp{"atan2(y, x) pow(a, b)", "of two"},
    WordHelp{"pi", "3.14159..."},
};

}  // namespace seamount::ecosystem
