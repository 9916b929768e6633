// Registration of the hydrology family.
#include "seamount/ops/hydrology/describe.h"
#include "seamount/ops/hydrology/fill.h"
#include "seamount/ops/hydrology/flow.h"
#include "seamount/ops/hydrology/rivers.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

const HeightField& terrain_of(const Call& call) { return call.in.at("terrain").heights(); }

Values fill(const hydrology::FillParams& params, const Call& call) {
  hydrology::Filled made = hydrology::fill(terrain_of(call), params, call.run);
  return {{"terrain", Value::terrain(std::move(made.terrain))},
          {"change", Value::field(std::move(made.change_m))},
          {"lakes", Value::drawing(std::move(made.lakes))}};
}

Values flow(const hydrology::FlowParams& params, const Call& call) {
  hydrology::Flow made = hydrology::flow(terrain_of(call), params, call.run);
  return {
      {"terrain", Value::terrain(std::move(made.terrain))}, {"cells", Value::field(std::move(made.cells))},
      {"area", Value::field(std::move(made.area_m2))},      {"direction", Value::field(std::move(made.direction_deg))},
      {"basins", Value::field(std::move(made.basins))},     {"catchments", Value::drawing(std::move(made.catchments))}};
}

Values rivers(const hydrology::RiversParams& params, const Call& call) {
  return {{"rivers", Value::drawing(hydrology::rivers(terrain_of(call), params, call.run))}};
}

Values ridges(const hydrology::RidgesParams& params, const Call& call) {
  return {{"ridges", Value::drawing(hydrology::ridges(terrain_of(call), params, call.run))}};
}

Values describe(const hydrology::DescribeParams& params, const Call& call) {
  const Value* reference = call.input("reference");
  hydrology::Described made =
      hydrology::describe(terrain_of(call), reference == nullptr ? nullptr : &reference->heights(), params, call.run);
  return {{"report", Value::report(std::move(made.report))}, {"peaks", Value::drawing(std::move(made.peaks))}};
}

}  // namespace

void add_hydrology_operators(Registry& registry) {
  const Port terrain_in = {"terrain", ValueKind::terrain, "heights in metres"};
  registry.add<hydrology::FillParams>(
      {.name = "hydrology.fill",
       .revision = 2,
       .summary = "A terrain without depressions: filled to their outlets, or breached; and the lakes",
       .source = "Barnes, Lehman and Mulla 2014; Lindsay and Dhun 2015",
       .in = {terrain_in},
       .out = {{"terrain", ValueKind::terrain, "heights from which water runs off everywhere"},
               {"change", ValueKind::field, "metres by which it was raised (positive) or cut"},
               {"lakes", ValueKind::drawing, "areas with level_m, depth_m, area_m2 and volume_m3"}}},
      fill);
  registry.add<hydrology::FlowParams>(
      {.name = "hydrology.flow",
       .revision = 2,
       .summary = "Where water runs and how much gathers: one neighbour, two or all (D8, D-infinity, multiple)",
       .source = "O'Callaghan and Mark 1984; Tarboton 1997; Holmgren 1994",
       .in = {terrain_in},
       .out = {{"terrain", ValueKind::terrain, "heights with depressions filled"},
               {"cells", ValueKind::field, "cells that drain through each cell, itself included"},
               {"area", ValueKind::field, "the same in square metres"},
               {"direction", ValueKind::field, "bearing of the flow in degrees clockwise from north; -1 where it ends"},
               {"basins", ValueKind::field, "number of the catchment, 1 the largest; 0 for open water"},
               {"catchments", ValueKind::drawing, "areas of the larger catchments with area_m2, mouth_x and mouth_y"}}},
      flow);
  registry.add<hydrology::RiversParams>(
      {.name = "hydrology.rivers",
       .revision = 2,
       .summary = "The river network as lines with stream order, discharge and width",
       .source = "Strahler 1957; Leopold and Maddock 1953",
       .in = {terrain_in},
       .out = {{"rivers", ValueKind::drawing,
                "lines downstream with order, length_m, area_m2, discharge_m3_s, width_m and fall_m"}}},
      rivers);
  registry.add<hydrology::RidgesParams>(
      {.name = "hydrology.ridges",
       .revision = 2,
       .summary = "The network of ridges as lines: the rivers of the inverted terrain",
       .source = "P1 sec. 5.1",
       .in = {terrain_in},
       .out = {{"ridges", ValueKind::drawing, "lines uphill with order, length_m, area_m2 and rise_m"}}},
      ridges);
  registry.add<hydrology::DescribeParams>(
      {.name = "hydrology.describe",
       .revision = 2,
       .summary = "What a terrain is like in numbers and curves, and how far it is from a reference",
       .source = "P2 sec. 6.5; Argudo, Guerin, Schott and Galin 2025",
       .in = {terrain_in, {"reference", ValueKind::terrain, "another terrain to compare with", false}},
       .out = {{"report", ValueKind::report, "descriptors with curves, measures and distances"},
               {"peaks", ValueKind::drawing, "summits of the terrain with height_m, prominence_m and isolation_m"}}},
      describe);
}

}  // namespace seamount::recipe
