// Registration of the island family: which files and inputs become a plan, and which ports the operators have.
#include <filesystem>

#include "seamount/base/text.h"
#include "seamount/io/vector.h"
#include "seamount/ops/island/archipelago.h"
#include "seamount/ops/island/build.h"
#include "seamount/ops/island/coral.h"
#include "seamount/ops/island/outlines.h"
#include "seamount/ops/island/wind.h"
#include "seamount/recipe/file_values.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

const Port kTerrainIn{"terrain", ValueKind::terrain, "heights in metres"};
const Port kLabelsIn{"labels", ValueKind::labels, "its regions"};
const Port kTerrainOut{"terrain", ValueKind::terrain, "heights in metres"};
const Port kLabelsOut{"labels", ValueKind::labels, "its regions"};
const Port kCoordinateOut{"coordinate", ValueKind::field,
                          "region coordinate: 0 at the summit, i on outline i, 5 on the sea floor"};

Port optional_port(Port port, const std::string& help) {
  port.required = false;
  port.help = help;
  return port;
}

Port described(Port port, const std::string& help) {
  port.help = help;
  return port;
}

bool is_picture(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".png" || extension == ".PNG" || extension == ".jpg" || extension == ".jpeg";
}

/// The one thing that an island is built on, of those that were given.
island::Plan make_plan(const island::BuildParams& p, const Call& call) {
  const island::GivenWidths widths{p.beach_m, p.lagoon_m, p.reef_m, p.slope_m};
  std::vector<std::string> given;
  if (!p.coast.path.empty()) given.emplace_back("coast");
  if (!p.outlines.empty()) given.emplace_back("outlines");
  if (!p.areas.empty()) given.emplace_back("areas");
  if (call.input("outlines") != nullptr) given.emplace_back("the input 'outlines'");
  if (call.input("labels") != nullptr) given.emplace_back("the input 'labels'");
  if (given.size() > 1)
    throw InvalidArgument(given[0], "given together with " + given[1] + "; an island is built on one of them");
  if (const LabelMap* labels = call.labels("labels")) return island::plan_from_labels(*labels, widths, call.run);
  if (const Value* drawing = call.input("outlines"))
    return island::plan_from_areas(drawing->shapes(), widths, "outlines");
  if (!p.outlines.empty()) return island::plan_from_polar(p.outlines, p.centre, widths);
  if (!p.areas.empty()) return island::plan_from_areas({{{"", p.areas}}, {}, {}}, widths, "areas");
  if (p.coast.path.empty()) return island::random_plan(call.domain, p.centre, p.irregularity, call.seed, widths);
  const std::string path = call.resolve(p.coast);
  if (is_picture(path)) {
    return island::plan_from_labels(read_label_picture(path, call.domain, call.run), widths, call.run);
  }
  return island::plan_from_areas(io::read_areas(path, {.feature = p.feature, .layer = {}}), widths, "coast");
}

Values build(const island::BuildParams& params, const Call& call) {
  const island::Plan plan = make_plan(params, call);
  GridFrame frame = call.domain;
  if (const LabelMap* labels = call.labels("labels")) frame = labels->frame();
  if (!plan.crs.empty()) frame.crs = plan.crs;
  island::Island made = island::build(plan, params, frame, call.seed, call.run);
  return {{"terrain", Value::terrain(std::move(made.terrain))},
          {"labels", Value::labels(std::move(made.labels))},
          {"coordinate", Value::field(std::move(made.coordinate))}};
}

Values wind(const island::WindParams& params, const Call& call) {
  const HeightField& terrain = call.in.at("terrain").heights();
  const LabelMap* labels = call.labels("labels");
  island::Warped warped = island::wind(terrain, labels, call.scalars("coordinate"), params, call.seed, call.run);
  Values out{{"terrain", Value::terrain(std::move(warped.terrain))}};
  // Ports are always there: without labels all is mountain, and nothing is known about where a place lies across
  // regions.
  if (labels == nullptr) warped.labels = LabelMap(terrain.frame(), Region::mountain);
  if (warped.coordinate.empty()) warped.coordinate = ScalarField(terrain.frame(), 0.0F);
  out["labels"] = Value::labels(std::move(warped.labels));
  out["coordinate"] = Value::field(std::move(warped.coordinate));
  return out;
}

Values coral(const island::CoralParams& params, const Call& call) {
  island::Reefed reefed = island::coral(call.in.at("terrain").heights(), call.in.at("labels").regions(),
                                        call.scalars("coordinate"), params, call.seed, call.run);
  return {{"terrain", Value::terrain(std::move(reefed.terrain))}, {"labels", Value::labels(std::move(reefed.labels))}};
}

constexpr int kMostIslands = 8;

std::vector<Port> archipelago_ports() {
  std::vector<Port> ports;
  for (int i = 0; i < kMostIslands; ++i) {
    ports.push_back({numbered("terrain", i), ValueKind::terrain, i == 0 ? "an island" : "another island", i == 0});
    ports.push_back({numbered("labels", i), ValueKind::labels, "its regions", false});
  }
  return ports;
}

Values archipelago(const island::ArchipelagoParams& params, const Call& call) {
  std::vector<island::Member> members;
  for (int i = 0; i < kMostIslands; ++i) {
    if (const Value* terrain = call.input(numbered("terrain", i))) {
      members.push_back({&terrain->heights(), call.labels(numbered("labels", i))});
    }
  }
  island::Archipelago made = island::archipelago(members, params, call.domain, call.run);
  if (made.labels.empty()) made.labels = LabelMap(call.domain, Region::abyss);
  return {{"terrain", Value::terrain(std::move(made.terrain))}, {"labels", Value::labels(std::move(made.labels))}};
}

Values outlines(const island::OutlinesParams& params, const Call& call) {
  return {{"outlines", Value::drawing(island::outlines(call.in.at("labels").regions(), params, call.run))}};
}

}  // namespace

void add_island_operators(Registry& registry) {
  registry.add<island::BuildParams>(
      {.name = "island.build",
       .summary = "An island from its outlines (drawn, polar, a real coastline, painted labels, or a random one) and "
                  "its profile",
       .source = "P0 sec. 1.4.1, eq. 1.1-1.2, 1.16",
       .stochastic = true,
       .in = {optional_port({"outlines", ValueKind::drawing, ""},
                            "areas named mountain, beach, lagoon, reef, abyss, or one coast"),
              optional_port({"labels", ValueKind::labels, ""}, "a label map to trace the outlines from")},
       .out = {kTerrainOut, kLabelsOut, kCoordinateOut}},
      build);
  registry.add<island::WindParams>(
      {.name = "island.wind",
       .summary = "Pushes an island out of its symmetry along strokes of wind and waves, terrain and labels together",
       .source = "P0 sec. 1.4.1, eq. 1.3-1.7, fig. 1.38",
       .stochastic = true,
       .in = {kTerrainIn, optional_port(kLabelsIn, "regions, which move along"),
              optional_port(kCoordinateOut,
                            "region coordinate, as island.build makes it; derived from the labels if absent")},
       .out = {kTerrainOut, described(kLabelsOut, "its regions; all mountain if no labels were given"),
               described(kCoordinateOut, "region coordinate; 0 everywhere if neither it nor labels were given")}},
      wind);
  registry.add<island::CoralParams>(
      {.name = "island.coral",
       .summary = "Sinks an island and grows its reef: fringing reef, barrier reef, atoll",
       .source = "P0 sec. 1.4.2, eq. 1.8-1.15",
       .stochastic = true,
       .in = {kTerrainIn, kLabelsIn,
              optional_port(kCoordinateOut,
                            "region coordinate, as island.build makes it; derived from the labels if absent")},
       .out = {kTerrainOut, kLabelsOut}},
      coral);
  registry.add<island::ArchipelagoParams>(
      {.name = "island.archipelago",
       .summary = "Several islands, or copies of one, in one sea",
       .source = "P0 sec. 1.5.1, eq. 1.15",
       .in = archipelago_ports(),
       .out = {kTerrainOut, described(kLabelsOut, "its regions; all abyss unless every island has labels")}},
      archipelago);
  registry.add<island::OutlinesParams>(
      {.name = "island.outlines",
       .summary = "Traces the outlines of a label map, as island.build reads them",
       .source = "P0 sec. 1.4.1, fig. 1.23",
       .in = {kLabelsIn},
       .out = {{"outlines", ValueKind::drawing, "nested areas named mountain, beach, lagoon, reef"}}},
      outlines);
}

}  // namespace seamount::recipe
