// Registration of the island family.
#include <optional>

#include "seamount/io/vector.h"
#include "seamount/ops/island/archipelago.h"
#include "seamount/ops/island/build.h"
#include "seamount/ops/island/choose_plan.h"
#include "seamount/ops/island/coral.h"
#include "seamount/ops/island/outlines.h"
#include "seamount/ops/island/wind.h"
#include "seamount/recipe/file_values.h"
#include "seamount/recipe/one_frame.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Drawing, kinds::Field, kinds::Labels, kinds::Terrain;
using IslandParts = std::tuple<HeightField, LabelMap, ScalarField>;

const char* const kHeights = "heights in metres";
const char* const kRegions = "its regions";
const char* const kCoordinate = "region coordinate: 0 at the summit, i on outline i, 5 on the sea floor";

/// What the coast's file holds, in the document's system; a document that says nothing of its place or its size takes
/// those of the island.
island::CoastFile read_coast(const island::BuildParams& params, const Call& call, GridFrame& domain) {
  const std::string path = call.resolve(params.coast);
  if (is_picture(path)) {
    PaintedPicture picture = read_painted_picture(path, domain, call.run);
    return island::PaintedCoast{std::move(picture.labels), std::move(picture.subsidence)};
  }
  return bring_drawing(
      io::read_areas(path, {.feature = params.feature, .layer = params.layer, .crs = params.crs}, call.run), domain,
      path);
}

IslandParts build(const island::BuildParams& params, const Call& call, const seamount::Drawing* outlines,
                  const LabelMap* labels, const seamount::Drawing* summits) {
  GridFrame domain = call.domain;
  std::optional<island::CoastFile> coast;
  if (!params.coast.path.empty()) coast = read_coast(params, call, domain);
  const auto read = [&](const FilePath&) { return *coast; };
  island::Island made =
      island::build({outlines, labels, summits, read, !call.domain_stated}, params, domain, call.seed, call.run);
  return {std::move(made.terrain), std::move(made.labels), std::move(made.coordinate)};
}

/// Outputs are always there: without labels all is mountain, and nothing is known about where a place lies across
/// regions.
IslandParts wind(const island::WindParams& params, const Call& call, const HeightField& terrain, const LabelMap* labels,
                 const ScalarField* coordinate) {
  island::Warped warped = island::wind(terrain, labels, coordinate, params, call.seed, call.run);
  if (labels == nullptr) warped.labels = LabelMap(terrain.frame(), Region::mountain);
  if (warped.coordinate.empty()) warped.coordinate = ScalarField(terrain.frame(), 0.0F);
  return {std::move(warped.terrain), std::move(warped.labels), std::move(warped.coordinate)};
}

std::tuple<HeightField, LabelMap> coral(const island::CoralParams& params, const Call& call, const HeightField& terrain,
                                        const LabelMap& labels, const ScalarField* coordinate) {
  island::Reefed reefed = island::coral(terrain, labels, coordinate, params, call.seed, call.run);
  return {std::move(reefed.terrain), std::move(reefed.labels)};
}

constexpr int kMostIslands = 8;
using IslandRows = std::vector<std::tuple<const HeightField*, const LabelMap*>>;

std::tuple<HeightField, LabelMap> archipelago(const island::ArchipelagoParams& params, const Call& call,
                                              const IslandRows& islands) {
  std::vector<island::Member> members;
  members.reserve(islands.size());
  for (const auto& [terrain, labels] : islands) members.push_back({terrain, labels});
  island::Archipelago made = island::archipelago(members, params, call.domain, call.run);
  if (made.labels.empty()) made.labels = LabelMap(call.domain, Region::abyss);
  return {std::move(made.terrain), std::move(made.labels)};
}

}  // namespace

void add_island_operators(Registry& registry) {
  registry.add(make_operator<island::BuildParams>(
      {.name = "island.build",
       .revision = 6,
       .summary = "An island from its outlines (drawn, polar, a real coastline, painted labels, or a random one) and "
                  "its profile",
       .source = "P0 sec. 1.4.1, eq. 1.1-1.2, 1.16",
       .stochastic = true},
      inputs(optional_in<Drawing>("outlines", "areas named mountain, beach, lagoon, reef, abyss, or one coast"),
             optional_in<Labels>("labels", "a label map to trace the outlines from"),
             optional_in<Drawing>("summits", "points with their heights, besides the parameter's summits")),
      outputs(out<Terrain>("terrain", kHeights), out<Labels>("labels", kRegions),
              out<Field>("coordinate", kCoordinate)),
      build));
  registry.add(make_operator<island::WindParams>(
      {.name = "island.wind",
       .revision = 2,
       .summary = "Pushes an island out of its symmetry along strokes of wind and waves, terrain and labels together",
       .source = "P0 sec. 1.4.1, eq. 1.3-1.7, fig. 1.38",
       .stochastic = true},
      inputs(in<Terrain>("terrain", kHeights), optional_in<Labels>("labels", "regions, which move along"),
             optional_in<Field>("coordinate",
                                "region coordinate, as island.build makes it; derived from the labels if absent")),
      outputs(out<Terrain>("terrain", kHeights),
              out<Labels>("labels", "its regions; all mountain if no labels were given"),
              out<Field>("coordinate", "region coordinate; 0 everywhere if neither it nor labels were given")),
      wind));
  registry.add(make_operator<island::CoralParams>(
      {.name = "island.coral",
       .revision = 4,
       .summary = "Sinks an island and grows its reef: fringing reef, barrier reef, atoll",
       .source = "P0 sec. 1.4.2, eq. 1.8-1.15",
       .stochastic = true},
      inputs(in<Terrain>("terrain", kHeights), in<Labels>("labels", kRegions),
             optional_in<Field>("coordinate",
                                "region coordinate, as island.build makes it; derived from the labels if absent")),
      outputs(out<Terrain>("terrain", kHeights), out<Labels>("labels", kRegions)), coral));
  registry.add(make_operator<island::ArchipelagoParams>(
      {.name = "island.archipelago",
       .revision = 2,
       .summary = "Several islands, or copies of one, in one sea",
       .source = "P0 sec. 1.5.1, eq. 1.15",
       .looks = "at its own place in the sea, at the whole islands"},
      inputs(placed(Placing::system, in_rows<Terrain, Labels>(kMostIslands, {"terrain", "labels"},
                                                              {"an island", kRegions}, {"another island", kRegions}))),
      outputs(out<Terrain>("terrain", kHeights),
              out<Labels>("labels", "its regions; all abyss unless every island has labels")),
      archipelago, [](const island::ArchipelagoParams&, double) { return Reach::place(); }));
  registry.add(make_operator<island::OutlinesParams>(
      {.name = "island.outlines",
       .summary = "Traces the outlines of a label map, as island.build reads them",
       .source = "P0 sec. 1.4.1, fig. 1.23"},
      inputs(in<Labels>("labels", kRegions)),
      outputs(out<Drawing>("outlines", "nested areas named mountain, beach, lagoon, reef")),
      [](const island::OutlinesParams& params, const Call& call, const LabelMap& labels) {
        return island::outlines(labels, params, call.run);
      }));
}

}  // namespace seamount::recipe
