// What was measured on one terrain, or on two side by side, for people (pages with plots) and programs (numbers by
// name).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace seamount {

/// A number of every subject, in the report's order. Not a number: it is not defined there.
struct Measure {
  std::string name;  ///< "mean", "bifurcation_ratio"
  std::string unit;  ///< "m", "deg", "1/m"; empty: a plain number
  std::vector<double> values;
};

enum class PlotKind { histogram, curve, bars };

/// One subject's part of a plot. Histogram: x holds the middles of bins of one width; bars: y over whole numbers.
struct PlotLine {
  std::vector<double> x, y;
};

struct Plot {
  PlotKind kind = PlotKind::curve;
  std::string x_title, y_title;
  bool log_x = false, log_y = false;  ///< then all values are above 0
  std::vector<PlotLine> lines;        ///< one for every subject
};

/// One property of a terrain.
struct Descriptor {
  std::string name;     ///< "slope"
  std::string title;    ///< "Slope"
  std::string meaning;  ///< what it is and how the distance is defined, in a sentence or two
  Plot plot;
  std::vector<Measure> measures;
  std::optional<double>
      distance;  ///< between the two subjects; 0: the same. Nothing: there is one subject, or none is defined
};

struct Report {
  std::string title;
  std::vector<std::string> subjects;  ///< one, or two: the terrain and its reference
  std::vector<Descriptor> descriptors;
  std::vector<Measure> settings = {};  ///< what the numbers rest on and can be had again with: cell size, thresholds
};

}  // namespace seamount
