// Descriptors of hydrology.describe that are distributions: of cells, of bearings, of the distances between peaks.
#pragma once

#include "seamount/ops/hydrology/descriptor_parts.h"

namespace seamount::hydrology {

/// A distribution of cells and how it is shown.
struct CellDistribution {
  const char *name, *title, *unit, *meaning, *axis;
  Distribution Survey::*of;
  bool logarithmic = false;  ///< it holds log10 of the values
};

Descriptor describe_cells(const Surveys& surveys, const CellDistribution& what);
Descriptor describe_hypsometry(const Surveys& surveys);
Descriptor describe_aspect(const Surveys& surveys);
Descriptor describe_isolation(const Surveys& surveys);

}  // namespace seamount::hydrology
