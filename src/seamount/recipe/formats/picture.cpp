// Pictures of terrains and contours: an operator's picture, written as PNG or JPEG.
#include "seamount/io/image_file.h"
#include "seamount/ops/render/contours.h"
#include "seamount/ops/render/map.h"
#include "seamount/ops/render/perspective.h"
#include "seamount/ops/render/relief.h"
#include "seamount/ops/render/texture.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

/// A format with the parameters of the operator that draws it.
template <class Params>
void add_picture(Registry& registry, const std::string& op, OutputFormat row) {
  row.extensions = io::picture_extensions();
  OutputFormat format = make_format<Params>(std::move(row), [](const Params&, const OutputCall& call) {
    io::write_picture(call.value.get<kinds::Image>(), call.path);
  });
  format.prepare = [op](const Json& params, const Kind&, const std::string&) -> std::vector<Preparation> {
    return {{"", op, "image", params}};
  };
  registry.add(std::move(format));
}

}  // namespace

void add_picture_formats(Registry& registry) {
  const std::vector<const Kind*> terrain = {&kinds::Terrain::kind()};
  add_picture<render::PerspectiveParams>(registry, "render.perspective",
                                         {"perspective", "a picture with sun, sky and water", {}, {}, terrain});
  add_picture<render::MapParams>(registry, "render.map",
                                 {"map", "a map with tints, relief, legend and scale bar", {}, {}, terrain});
  add_picture<render::ReliefParams>(registry, "render.relief", {"relief", "shaded relief", {}, {}, terrain});
  add_picture<render::TextureParams>(registry, "render.texture",
                                     {"texture", "the ground from above, for meshes", {}, {}, terrain});
  add_picture<render::ContoursParams>(
      registry, "render.contours",
      {"contour_map", "contours as a topographic map", {}, io::picture_extensions(), {&kinds::Contours::kind()}});
}

}  // namespace seamount::recipe
