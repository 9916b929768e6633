// Registration of what leads from terrains to contours and back.
#include "seamount/ops/contour/convert/extract.h"
#include "seamount/ops/contour/convert/reconstruct.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {

void add_contour_conversions(Registry& registry) {
  registry.add(make_operator<contour::ExtractParams>(
      {.name = "contour.extract",
       .summary = "The contours of a network or of a terrain, closed and nested",
       .source = "P2 sec. 4.4"},
      inputs(optional_in<kinds::Tin>("tin", "a network with heights"),
             optional_in<kinds::Terrain>("terrain", "or heights in metres")),
      outputs(out<kinds::Contours>("contours", "nested closed contours")),
      [](const contour::ExtractParams& params, const Call& call, const Tin* tin, const HeightField* terrain) {
        return contour::extract(tin, terrain, params, call.run);
      }));
  registry.add(make_operator<contour::ReconstructParams>(
      {.name = "contour.reconstruct",
       .revision = 2,
       .summary = "A terrain from its contours or from a network, at any resolution",
       .source = "P2 sec. 3.2"},
      inputs(optional_in<kinds::Contours>("contours", "nested closed contours"),
             optional_in<kinds::Tin>("tin", "or a network with heights")),
      outputs(out<kinds::Terrain>("terrain", "heights in metres")),
      [](const contour::ReconstructParams& params, const Call& call, const ContourSet* contours, const Tin* tin) {
        return contour::reconstruct(contours, tin, params, call.run);
      }));
}

}  // namespace seamount::recipe
