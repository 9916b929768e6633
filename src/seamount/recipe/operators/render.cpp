// Registration of the render family.
#include "seamount/ops/render/contours.h"
#include "seamount/ops/render/map.h"
#include "seamount/ops/render/perspective.h"
#include "seamount/ops/render/relief.h"
#include "seamount/ops/render/texture.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

template <class Params, Image (*draw)(const HeightField&, const LabelMap*, const Params&, const RunContext&)>
Values picture(const Params& params, const Call& call) {
  return {{"image", Value::image(draw(call.in.at("terrain").heights(), call.labels("labels"), params, call.run))}};
}

}  // namespace

void add_render_operators(Registry& registry) {
  const std::vector<Port> in = {{"terrain", ValueKind::terrain, "heights in metres"},
                                {"labels", ValueKind::labels, "its regions: where beach, lagoon and reef are", false}};
  const std::vector<Port> out = {{"image", ValueKind::image, "the picture"}};
  registry.add<render::MapParams>(
      {.name = "render.map",
       .summary = "A map with tints by height and depth, relief, contours, legend and scale bar; rivers, lakes, ridges "
                  "and peaks over it",
       .in = {in[0],
              in[1],
              {"lakes", ValueKind::drawing, "areas to fill as water", false},
              {"rivers", ValueKind::drawing, "lines of water, as wide as their order", false},
              {"ridges", ValueKind::drawing, "lines of ridges", false},
              {"peaks", ValueKind::drawing, "points with heights", false}},
       .out = out},
      [](const render::MapParams& params, const Call& call) -> Values {
        const render::MapDrawings drawings{call.shapes("lakes"), call.shapes("rivers"), call.shapes("ridges"),
                                           call.shapes("peaks")};
        return {{"image", Value::image(render::map(call.in.at("terrain").heights(), call.labels("labels"), drawings,
                                                   params, call.run))}};
      });
  registry.add<render::ReliefParams>(
      {.name = "render.relief",
       .summary = "Shaded relief with light from several directions",
       .in = {in[0]},
       .out = out},
      [](const render::ReliefParams& params, const Call& call) -> Values {
        return {{"image", Value::image(render::relief(call.in.at("terrain").heights(), params, call.run))}};
      });
  registry.add<render::PerspectiveParams>(
      {.name = "render.perspective",
       .summary = "A picture from a point of view, with sun, shadows, sky and water",
       .in = in,
       .out = out},
      picture<render::PerspectiveParams, render::perspective>);
  registry.add<render::TextureParams>(
      {.name = "render.texture", .summary = "The ground from above, as a texture for meshes", .in = in, .out = out},
      picture<render::TextureParams, render::texture>);
  registry.add<render::ContoursParams>(
      {.name = "render.contours",
       .summary = "Contours as a topographic map: lines with their heights, water, scale bar",
       .in = {{"contours", ValueKind::contours, "nested closed contours"}},
       .out = out},
      [](const render::ContoursParams& params, const Call& call) -> Values {
        return {{"image", Value::image(render::contours(call.in.at("contours").contour_set(), params, call.run))}};
      });
}

}  // namespace seamount::recipe
