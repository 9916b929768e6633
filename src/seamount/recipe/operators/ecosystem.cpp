// Registration of the ecosystem family.
#include "seamount/io/input_file.h"
#include "seamount/io/thing_file.h"
#include "seamount/ops/ecosystem/field.h"
#include "seamount/ops/ecosystem/grow.h"
#include "seamount/ops/ecosystem/labels.h"
#include "seamount/ops/ecosystem/scene_things.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Catalogue, kinds::Current, kinds::Field, kinds::Labels, kinds::Objects, kinds::Terrain;

/// Appends what a JSON file holds as a list.
template <class T>
void add_from_file(const FilePath& file, const Call& call, std::vector<T>& items) {
  if (file.path.empty()) return;
  const std::string path = call.resolve(file);
  const JsonDocument document = parse_json(io::read_text(path, kLargestText + 1, call.run), path, call.run);
  Diagnostics diagnostics;
  std::vector<T> more;
  read_json(document.root, more, {"", diagnostics});
  if (!diagnostics.empty()) {
    place_diagnostics(diagnostics, document);
    throw RecipeError(path, diagnostics.items());
  }
  items.insert(items.end(), more.begin(), more.end());
}

std::tuple<Scene, HeightField, VectorField> grow(ecosystem::GrowParams params, const Call& call,
                                                 const HeightField& terrain, const seamount::Catalogue* catalogue,
                                                 const Scene* objects, const ScalarField* focus,
                                                 const VectorField* current) {
  add_from_file(params.timeline_file, call, params.timeline);
  add_from_file(params.edits_file, call, params.edits);
  ecosystem::Grown grown = ecosystem::grow({terrain, catalogue, objects, focus, current}, params, call.seed, call.run);
  return {std::move(grown.scene), std::move(grown.terrain), std::move(grown.current)};
}

ecosystem::MeshFiles read_meshes(const Scene& scene, const Call& call) {
  ecosystem::MeshFiles meshes;
  for (const ObjectClass& of : scene.catalogue.classes) {
    for (const ThingParams& thing : of.things) {
      if (thing.shape != ThingForm::file || meshes.contains(thing.file.path)) continue;
      meshes[thing.file.path] = std::make_shared<const ThingMesh>(io::read_thing(call.resolve(thing.file), call.run));
    }
  }
  return meshes;
}

Things things(const ecosystem::ThingsParams& params, const Call& call, const HeightField& terrain, const Scene& objects,
              const HeightField* surface) {
  const ecosystem::MeshFiles meshes = read_meshes(objects, call);
  if (surface != nullptr) return ecosystem::things(objects, *surface, meshes, params, call.run);
  const HeightField made = ecosystem::height(objects, {terrain}, {params.window}, call.run).terrain;
  return ecosystem::things(objects, made, meshes, params, call.run);
}

const char* const kGround = "heights in metres: the ground that the objects grew on";
const char* const kScene = "the objects";
const char* const kMore = "m/s, added to what the terrain, events and objects make of the water";

}  // namespace

void add_ecosystem_operators(Registry& registry) {
  registry.add(make_operator<ecosystem::GrowParams>(
      {.name = "ecosystem.grow",
       .revision = 2,
       .summary = "Environmental objects that live where they are fit and change their surroundings: islands, reefs, "
                  "corals, trees, rocks",
       .source = "P3 sec. 1.4-1.7, Algorithms 1, 2 and 4",
       .stochastic = true},
      inputs(in<Terrain>("terrain", "heights in metres: the ground before any object"),
             optional_in<Catalogue>("catalogue", "what may grow; with objects, in place of theirs"),
             optional_in<Objects>("objects", "a scene to go on with"),
             optional_in<Field>("focus", "factor of the fitness of what is to be born: 0 nowhere, 1 as it is"),
             optional_in<Current>("current", kMore)),
      outputs(out<Objects>("objects", "points, curves and regions with their classes"),
              out<Terrain>("terrain", "the ground with them, of the scene or of the window"),
              out<Current>("current", "m/s, over that ground")),
      grow));
  registry.add(make_operator<ecosystem::HeightParams>(
      {.name = "ecosystem.height",
       .summary = "The ground with what objects and events make of it",
       .source = "P3 sec. 1.6.2, eq. 1.46-1.49"},
      inputs(in<Terrain>("terrain", kGround), in<Objects>("objects", kScene), optional_in<Current>("current", kMore)),
      outputs(out<Terrain>("terrain", "heights in metres, of the scene or of a window"),
              out<Current>("current", "m/s, over that ground")),
      [](const ecosystem::HeightParams& params, const Call& call, const HeightField& terrain, const Scene& objects,
         const VectorField* current) {
        ecosystem::GroundAndCurrent made = ecosystem::height(objects, {terrain, current}, params, call.run);
        return std::tuple(std::move(made.terrain), std::move(made.current));
      }));
  registry.add(make_operator<ecosystem::FieldParams>(
      {.name = "ecosystem.field",
       .revision = 2,
       .summary = "A material, the current, a distance, a fitness, any expression of a scene as a raster",
       .source = "P3 sec. 1.5.1, 1.6"},
      inputs(in<Terrain>("terrain", kGround), in<Objects>("objects", kScene), optional_in<Current>("current", kMore)),
      outputs(out<Field>("field", "the value of the expression, in its unit")),
      [](const ecosystem::FieldParams& params, const Call& call, const HeightField& terrain, const Scene& objects,
         const VectorField* current) {
        return ecosystem::field_of(objects, {terrain, current}, params, call.run);
      }));
  registry.add(make_operator<ecosystem::LabelsParams>(
      {.name = "ecosystem.labels",
       .summary = "The label map of a scene: mountain, beach, lagoon, reef, abyss",
       .source = "P3 fig. 1.45"},
      inputs(in<Objects>("objects", kScene)),
      outputs(out<Labels>("labels", "regions as island.coral and learned islands read them")),
      [](const ecosystem::LabelsParams& params, const Call& call, const Scene& objects) {
        return ecosystem::labels(objects, params, call.run);
      }));
  registry.add(make_operator<ecosystem::ThingsParams>(
      {.name = "ecosystem.things",
       .summary = "What the objects look like: corals, trees and rocks, standing on the ground",
       .source = "P3 sec. 1.4.3, fig. 1.18, 1.21"},
      inputs(in<Terrain>("terrain", kGround), in<Objects>("objects", kScene),
             placed(Placing::system, optional_in<Terrain>("surface", "what they stand on instead: worn ground, say"))),
      outputs(out<kinds::Things>("things", "models and where they stand")), things));
}

}  // namespace seamount::recipe
