// What the descriptors of hydrology.describe are put together from.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "seamount/model/report.h"
#include "seamount/ops/hydrology/survey.h"

namespace seamount::hydrology {

/// Of the terrain and, where there is one, the reference.
using Surveys = std::vector<Survey>;

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A number of every subject that has land; not a number for one that has none.
Measure measure(const Surveys& surveys, const std::string& name, const char* unit,
                const std::function<double(const Survey&)>& value);

/// Are there two to compare, both with land?
bool comparable(const Surveys& surveys);

/// The distance that a number is; nothing where it is not defined.
std::optional<double> defined(double distance);

/// A count on the survey's land as a number per 100 km2 of it.
double per_100_km2(double count, const Survey& survey);

/// Least-squares slope of log y over log x for x in [low, high]. Not a number from fewer than two points.
double log_slope(const PlotLine& line, double low, double high);

}  // namespace seamount::hydrology
