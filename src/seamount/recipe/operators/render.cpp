// Registration of the render family.
#include "seamount/io/projection.h"
#include "seamount/ops/render/contours.h"
#include "seamount/ops/render/layers.h"
#include "seamount/ops/render/map.h"
#include "seamount/ops/render/perspective.h"
#include "seamount/ops/render/relief.h"
#include "seamount/ops/render/texture.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Drawing, kinds::Labels, kinds::Terrain;
using Lines = const seamount::Drawing*;

const char* const kLargerCells = "from means over larger cells, as many as fit";

In<Terrain> terrain_in() { return with_voids(in<Terrain>("terrain", "heights in metres")); }
OptionalIn<Labels> labels_in() {
  return optional_in<Labels>("labels", "its regions: where beach, lagoon and reef are");
}
OptionalIn<kinds::Field> lake_in() {
  return with_voids(
      optional_in<kinds::Field>("lake", "metres of standing water over it, as hydrology.lakes gives them"));
}
OptionalIn<Drawing> rivers_in() {
  return optional_in<Drawing>("rivers", "lines of running water, as wide as they say");
}
auto picture_out() { return outputs(out<kinds::Image>("image", "the picture")); }

/// With the latitude of the terrain's middle, if it lies somewhere on the Earth and no other is given.
template <class Params>
Params at_its_latitude(Params params, const GridFrame& frame) {
  if (params.climate.latitude_deg || frame.crs.empty()) return params;
  try {
    const Vec2 middle{frame.west_m + 0.5 * frame.width_m(), frame.north_m - 0.5 * frame.height_m()};
    params.climate.latitude_deg = io::to_lonlat({middle}, frame.crs).front().y;
  } catch (const Error&) {
    // A system of an engineer's own: on no place of the Earth.
  }
  return params;
}

Image map(const render::MapParams& params, const Call& call, const HeightField& terrain, const LabelMap* labels,
          Lines lakes, Lines rivers, Lines ridges, Lines peaks, const VectorField* current, const Scene* objects,
          const ScalarField* lake) {
  return render::map(terrain, labels, {lakes, rivers, ridges, peaks, current, objects, lake}, params, call.run);
}

std::tuple<ScalarField, ScalarField, ScalarField> layers(const render::LayersParams& params, const Call& call,
                                                         const HeightField& terrain) {
  geom::Layers made = render::layers(terrain, params, call.run, call.whole);
  return {std::move(made.low), std::move(made.middle), std::move(made.high)};
}

void add_views(Registry& registry) {
  registry.add(make_operator<render::ReliefParams>(
      {.name = "render.relief",
       .revision = 3,
       .summary = "Shaded relief with light from several directions",
       .in_tiles = kLargerCells},
      inputs(terrain_in()), picture_out(),
      [](const render::ReliefParams& params, const Call& call, const HeightField& terrain) {
        return render::relief(terrain, params, call.run);
      }));
  registry.add(make_operator<render::PerspectiveParams>(
      {.name = "render.perspective",
       .revision = 6,
       .summary = "A picture from a point of view, with sun, shadows, sky and water",
       .in_tiles = kLargerCells},
      inputs(terrain_in(), labels_in(),
             optional_in<kinds::Things>("things", "what stands on it, drawn from its models"), lake_in(), rivers_in()),
      picture_out(),
      [](const render::PerspectiveParams& params, const Call& call, const HeightField& terrain, const LabelMap* labels,
         const Things* things, const ScalarField* lake, Lines rivers) {
        return render::perspective(terrain, {labels, things, lake, rivers}, at_its_latitude(params, terrain.frame()),
                                   call.run);
      }));
  registry.add(make_operator<render::TextureParams>(
      {.name = "render.texture",
       .revision = 5,
       .summary = "The ground from above, as a texture for meshes",
       .in_tiles = kLargerCells},
      inputs(terrain_in(), labels_in(), lake_in(), rivers_in()), picture_out(),
      [](const render::TextureParams& params, const Call& call, const HeightField& terrain, const LabelMap* labels,
         const ScalarField* lake, Lines rivers) {
        return render::texture(terrain, {.labels = labels, .lake = lake, .rivers = rivers},
                               at_its_latitude(params, terrain.frame()), call.run);
      }));
}

}  // namespace

void add_render_operators(Registry& registry) {
  registry.add(make_operator<render::MapParams>(
      {.name = "render.map",
       .revision = 4,
       .summary = "A map with tints by height and depth, relief, contours, legend and scale bar; rivers, lakes, "
                  "ridges, peaks, currents and objects over it",
       .in_tiles = kLargerCells},
      inputs(terrain_in(), labels_in(), optional_in<Drawing>("lakes", "areas to fill as water"),
             optional_in<Drawing>("rivers", "lines of water, as wide as their order"),
             optional_in<Drawing>("ridges", "lines of ridges"), optional_in<Drawing>("peaks", "points with heights"),
             optional_in<kinds::Current>("current", "a flow to draw as arrows as long as it is fast"),
             optional_in<kinds::Objects>("objects", "regions, curves and points, in their classes' colours"),
             lake_in()),
      picture_out(), map));
  add_views(registry);
  registry.add(make_operator<render::ContoursParams>(
      {.name = "render.contours",
       .summary = "Contours as a topographic map: lines with their heights, water, scale bar"},
      inputs(in<kinds::Contours>("contours", "nested closed contours")), picture_out(),
      [](const render::ContoursParams& params, const Call& call, const ContourSet& contours) {
        return render::contours(contours, params, call.run);
      }));
  registry.add(settled_by_relief<render::LayersParams>(
      make_operator<render::LayersParams>(
          {.name = "render.layers",
           .revision = 2,
           .summary = "The layers of ground that a style's pictures show: three masks that sum to one, for splat maps",
           .source = "P4 sec. 3.4, eq. 3-6",
           .looks = "at its own place, once the lowest and the highest of the whole are known"},
          inputs(in<Terrain>("terrain", "heights in metres")),
          outputs(out<kinds::Field>("low", "share of the low layer"),
                  out<kinds::Field>("middle", "share of the middle layer"),
                  out<kinds::Field>("high", "share of the high layer")),
          layers, [](const render::LayersParams& params, double) { return geom::layers_reach(params.layers); }),
      render::settled_layers));
}

}  // namespace seamount::recipe
