#include "seamount/recipe/crop_place.h"

#include "seamount/base/error.h"
#include "seamount/model/extent.h"
#include "seamount/recipe/degrees.h"

namespace seamount::recipe {

terrain::CropParams in_metres(const terrain::CropParams& params, const GridFrame& frame) {
  terrain::CropParams placed = params;
  const Degrees degrees{params.longitude_deg, params.latitude_deg};
  const auto place = place_in_metres(degrees, params.x_m || params.y_m, frame, "", "x_m and y_m");
  if (!place) return placed;
  const double east = 0.5 * params.width_m, north = 0.5 * params.height_m.value_or(params.width_m);
  if (!Extent{frame.crs, place->x - east, place->y - north, place->x + east, place->y + north}.overlaps(
          Extent::of(frame)))
    throw InvalidArgument("longitude_deg", "the rectangle around " +
                                               degrees_text(Vec2{*degrees.longitude, *degrees.latitude}) +
                                               " lies beside the terrain, which covers " + degrees_text(frame));
  placed.x_m = place->x;
  placed.y_m = place->y;
  return placed;
}

}  // namespace seamount::recipe
