// Registration of the hydrology family.
#include "seamount/ops/hydrology/describe.h"
#include "seamount/ops/hydrology/fill.h"
#include "seamount/ops/hydrology/flow.h"
#include "seamount/ops/hydrology/lakes.h"
#include "seamount/ops/hydrology/rivers.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Field, kinds::Terrain;

const char* const kHeights = "heights in metres";

std::tuple<HeightField, ScalarField, Drawing> fill(const hydrology::FillParams& params, const Call& call,
                                                   const HeightField& terrain) {
  hydrology::Filled made = hydrology::fill(terrain, params, call.run);
  return {std::move(made.terrain), std::move(made.change_m), std::move(made.lakes)};
}

std::tuple<HeightField, ScalarField, ScalarField, ScalarField, ScalarField, Drawing> flow(
    const hydrology::FlowParams& params, const Call& call, const HeightField& terrain, const ScalarField* sinks) {
  hydrology::Flow made = hydrology::flow(terrain, sinks, params, call.run);
  return {std::move(made.terrain),       std::move(made.cells),  std::move(made.area_m2),
          std::move(made.direction_deg), std::move(made.basins), std::move(made.catchments)};
}

std::tuple<HeightField, ScalarField, ScalarField, Drawing> lakes(const hydrology::LakesParams& params, const Call& call,
                                                                 const HeightField& terrain,
                                                                 const ScalarField* runoff) {
  hydrology::Lakes made = hydrology::lakes(terrain, runoff, params, call.run);
  return {std::move(made.surface), std::move(made.depth_m), std::move(made.sinks), std::move(made.lakes)};
}

/// Where rivers end besides sea and edge.
OptionalIn<Field> sinks_in() {
  return with_voids(optional_in<Field>("sinks", "flow ends where it is above 0: the closed lakes of hydrology.lakes"));
}

std::tuple<Report, Drawing> describe(const hydrology::DescribeParams& params, const Call& call,
                                     const HeightField& terrain, const HeightField* reference) {
  hydrology::Described made = hydrology::describe(terrain, reference, params, call.run);
  return {std::move(made.report), std::move(made.peaks)};
}

void add_networks(Registry& registry) {
  registry.add(make_operator<hydrology::RiversParams>(
      {.name = "hydrology.rivers",
       .revision = 3,
       .summary = "The river network as lines with stream order, discharge and width",
       .source = "Strahler 1957; Leopold and Maddock 1953"},
      inputs(with_voids(in<Terrain>("terrain", kHeights)), sinks_in()),
      outputs(out<kinds::Drawing>(
          "rivers", "lines downstream with order, length_m, area_m2, discharge_m3_s, width_m and fall_m")),
      [](const hydrology::RiversParams& params, const Call& call, const HeightField& terrain,
         const ScalarField* sinks) { return hydrology::rivers(terrain, sinks, params, call.run); }));
  registry.add(make_operator<hydrology::RidgesParams>(
      {.name = "hydrology.ridges",
       .revision = 3,
       .summary = "The network of ridges as lines: the rivers of the inverted terrain",
       .source = "P1 sec. 5.1"},
      inputs(with_voids(in<Terrain>("terrain", kHeights))),
      outputs(out<kinds::Drawing>("ridges", "lines uphill with order, length_m, area_m2 and rise_m")),
      [](const hydrology::RidgesParams& params, const Call& call, const HeightField& terrain) {
        return hydrology::ridges(terrain, params, call.run);
      }));
}

}  // namespace

void add_hydrology_operators(Registry& registry) {
  registry.add(make_operator<hydrology::FillParams>(
      {.name = "hydrology.fill",
       .revision = 3,
       .summary = "A terrain without depressions: filled to their outlets, or breached; and the lakes",
       .source = "Barnes, Lehman and Mulla 2014; Lindsay and Dhun 2015",
       .in_tiles = "over their borders, but for breaching"},
      inputs(with_voids(in<Terrain>("terrain", kHeights))),
      outputs(out<Terrain>("terrain", "heights from which water runs off everywhere"),
              out<Field>("change", "metres by which it was raised (positive) or cut"),
              out<kinds::Drawing>("lakes", "areas with level_m, depth_m, area_m2 and volume_m3")),
      fill));
  registry.add(make_operator<hydrology::LakesParams>(
      {.name = "hydrology.lakes",
       .summary = "Lakes as a climate leaves them, with outlet and without: inflow against evaporation",
       .source = "Barnes, Callaghan and Wickert 2020"},
      inputs(with_voids(in<Terrain>("terrain", kHeights)),
             optional_in<Field>("runoff", "rain that runs off each cell in a year, in mm")),
      outputs(out<Terrain>("surface", "heights of the ground and of the lakes' surfaces"),
              out<Field>("lake", "metres of water over the ground; 0 where there is no lake"),
              out<Field>("sinks", "1 where flow ends: in closed lakes, and on the lowest ground of dry depressions"),
              out<kinds::Drawing>(
                  "lakes", "areas with level_m, depth_m, area_m2, volume_m3, closed, inflow_m3_s, outflow_m3_s")),
      lakes));
  registry.add(make_operator<hydrology::FlowParams>(
      {.name = "hydrology.flow",
       .revision = 3,
       .summary = "Where water runs and how much gathers: one neighbour, two or all (D8, D-infinity, multiple)",
       .source = "O'Callaghan and Mark 1984; Tarboton 1997; Holmgren 1994",
       .in_tiles = "over their borders, with d8 and without sinks"},
      inputs(with_voids(in<Terrain>("terrain", kHeights)), sinks_in()),
      outputs(out<Terrain>("terrain", "heights with depressions filled"),
              out<Field>("cells", "cells that drain through each cell, itself included"),
              out<Field>("area", "the same in square metres"),
              out<Field>("direction", "bearing of the flow in degrees clockwise from north; -1 where it ends"),
              out<Field>("basins", "number of the catchment, 1 the largest; 0 for open water"),
              out<kinds::Drawing>("catchments", "areas of the larger catchments with area_m2, mouth_x and mouth_y")),
      flow));
  add_networks(registry);
  registry.add(make_operator<hydrology::DescribeParams>(
      {.name = "hydrology.describe",
       .revision = 3,
       .summary = "What a terrain is like in numbers and curves, and how far it is from a reference",
       .source = "P2 sec. 6.5; Argudo, Guerin, Schott and Galin 2025"},
      inputs(
          with_voids(in<Terrain>("terrain", kHeights)),
          placed(Placing::anywhere, with_voids(optional_in<Terrain>("reference", "another terrain to compare with")))),
      outputs(out<kinds::Report>("report", "descriptors with curves, measures and distances"),
              out<kinds::Drawing>("peaks", "summits of the terrain with height_m, prominence_m and isolation_m")),
      describe));
}

}  // namespace seamount::recipe
