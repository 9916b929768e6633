// What is drawn over a map: lakes, rivers by their order, ridges, peaks with their heights, currents as arrows,
// environmental objects.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/image.h"
#include "seamount/model/scene.h"
#include "seamount/model/vector_field.h"
#include "seamount/ops/render/map_furniture.h"

namespace seamount::render {

/// Drawings in the terrain's coordinates, as the operators of hydrology make them; null: none. Areas of lakes are
/// filled; lines are as wide as their attribute `order` (or their value) says; of peaks those get their height (the
/// attribute `height_m`, or the value) that find room for it, from the most prominent (`prominence_m`) on.
struct MapDrawings {
  const Drawing* lakes = nullptr;
  const Drawing* rivers = nullptr;
  const Drawing* ridges = nullptr;
  const Drawing* peaks = nullptr;
  const VectorField* current = nullptr;  ///< on the terrain's cells, without unknown ones
  const seamount::Scene* objects = nullptr;
  const ScalarField* lake = nullptr;  ///< on the terrain's cells: metres of standing water, tinted by its depth
};

/// Draws the drawings, neither the current (map_arrows.h), the objects (map_objects.h) nor the water (map.cpp), into
/// the box of the picture that `frame` is shown in; `unit` in pixels is the size of text. Throws IncompatibleInputs for
/// a drawing in another coordinate system than the frame, where both have one.
void draw_drawings(Image& image, const Box& box, const GridFrame& frame, const MapDrawings& drawings, double unit,
                   const RunContext& run);

}  // namespace seamount::render
