#include "seamount/io/label_info.h"

#include <algorithm>
#include <vector>

#include "seamount/io/gdal_call.h"

namespace seamount::io {
namespace {

/// The region whose colour this is, darkened or not; kRegionCount: none.
size_t region_of(const uint8_t* rgb) {
  const uint8_t value = std::max({rgb[0], rgb[1], rgb[2]});
  constexpr uint8_t kDarkest = 51;  // subsidence 1
  if (value < kDarkest) return kRegionCount;
  for (const Region region : kRegions) {
    const Colour pure = painted_colour(region);
    const auto fits = [&](uint8_t channel, uint8_t full) { return channel == (full > 0 ? value : 0); };
    if (fits(rgb[0], pure.r) && fits(rgb[1], pure.g) && fits(rgb[2], pure.b)) return static_cast<size_t>(region);
  }
  return kRegionCount;
}

void count(RegionCounts& counts, size_t region) {
  if (region < kRegionCount) {
    ++counts.cells[region];
  } else {
    ++counts.others;
  }
}

bool names_regions(GDALDataset& dataset) {
  return std::all_of(kRegions.begin(), kRegions.end(), [&](Region region) {
    const char* name = dataset.GetMetadataItem(("LABEL_" + std::to_string(static_cast<int>(region))).c_str());
    return name != nullptr && name == region_name(region);
  });
}

}  // namespace

std::optional<RegionCounts> count_regions(const std::string& tiff_path) {
  const GdalCall call(tiff_path);
  constexpr const char* const kDrivers[] = {"GTiff", nullptr};
  const DatasetPtr dataset = open_dataset(call, tiff_path, GDAL_OF_RASTER | GDAL_OF_READONLY, kDrivers, "a GeoTIFF");
  if (dataset->GetRasterCount() != 1 || !names_regions(*dataset)) return std::nullopt;
  RegionCounts counts;
  const int width = dataset->GetRasterXSize();
  std::vector<uint8_t> row(static_cast<size_t>(width));
  for (int y = 0; y < dataset->GetRasterYSize(); ++y) {
    if (dataset->GetRasterBand(1)->RasterIO(GF_Read, 0, y, width, 1, row.data(), width, 1, GDT_Byte, 0, 0, nullptr) !=
        CE_None)
      call.fail("cannot be read");
    for (const uint8_t number : row) count(counts, number);
  }
  return counts;
}

std::optional<RegionCounts> count_regions(const Image& image) {
  RegionCounts counts;
  for (size_t i = 0; i < image.rgb.size(); i += 3) count(counts, region_of(&image.rgb[i]));
  const int64_t all = int64_t{image.width} * image.height;
  if (counts.others * 100 > all) return std::nullopt;
  return counts;
}

}  // namespace seamount::io
