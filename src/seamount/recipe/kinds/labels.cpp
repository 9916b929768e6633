// labels: the region of each cell.
#include "seamount/io/atomic_file.h"
#include "seamount/io/raster.h"
#include "seamount/recipe/file_values.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/kinds/rasters.h"

namespace seamount::recipe {
namespace {

/// A label raster, or a painted picture laid over the frame if nothing beside it says where it lies.
LabelMap read_labels(const FileCall& call) {
  return is_picture(call.path) ? read_label_picture(call.path, call.frame, call.run) : io::read_labels(call.path);
}

}  // namespace

const Kind& kinds::Labels::kind() {
  static const Kind kind = make_kind<LabelMap>({
      .name = "labels",
      .about = "the region of each cell",
      .files = {".png"},
      .reads = {".tif", ".tiff", ".png", ".jpg", ".jpeg"},
      .frame = [](const LabelMap& labels) { return &labels.frame(); },
      .bring = bring_raster<Region>,
      .bytes = [](const LabelMap& labels) { return labels.size(); },
      .write = write_grid<Region>,
      .read = read_grid<Region>,
      .read_file = read_labels,
      .info = {},  // their files are rasters
  });
  return kind;
}

void kinds::Labels::add_formats(Registry& registry) {
  const std::vector<std::string> files = {".tif", ".png"};
  OutputFormat format =
      make_format<NoParams>({"labels",
                             "regions: GeoTIFF with a palette, or a picture in the colours that can be painted",
                             files,
                             files,
                             {&kind()}},
                            [](const NoParams&, const OutputCall& call) {
                              io::write_labels(call.value.get<Labels>(), call.path, {.provenance = call.provenance});
                            });
  format.files = [](const Json&, const Kind&, const std::string& path) { return io::written_files(path); };
  registry.add(std::move(format));
}

}  // namespace seamount::recipe
