#include "seamount/io/geotiff_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/geotiff_tags.h"

namespace seamount::io {
namespace {

constexpr int kBlock = 512;  ///< cells along a tile of the file, and rows that are in memory

bool any_unknown(const float* cells, size_t count) {
  return std::any_of(cells, cells + count, [](float z) { return std::isnan(z); });
}

DatasetPtr create(const GdalCall& call, const std::string& path, const GridFrame& frame, bool bytes, int threads) {
  CPLStringList how;
  how.SetNameValue("TILED", "YES");
  how.SetNameValue("BLOCKXSIZE", std::to_string(kBlock).c_str());
  how.SetNameValue("BLOCKYSIZE", std::to_string(kBlock).c_str());
  how.SetNameValue("COMPRESS", "DEFLATE");
  how.SetNameValue("ZLEVEL", "4");
  how.SetNameValue("PREDICTOR", bytes ? "1" : "3");
  how.SetNameValue("BIGTIFF", "IF_SAFER");
  how.SetNameValue("NUM_THREADS", std::to_string(threads).c_str());  // the bytes do not hang on it
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  DatasetPtr made(
      driver->Create(path.c_str(), frame.width, frame.height, 1, bytes ? GDT_Byte : GDT_Float32, how.List()));
  if (!made) call.fail("cannot be written");
  return made;
}

/// Band after band of rows; true if a cell has no value.
bool copy_rows(const GdalCall& call, GDALDataset& dataset, const RowSource& source, bool bytes, const RunContext& run) {
  const int width = dataset.GetRasterXSize(), height = dataset.GetRasterYSize();
  std::vector<float> cells(static_cast<size_t>(width) * static_cast<size_t>(std::min(kBlock, height)));
  bool unknown = false;
  for (int row = 0; row < height; row += kBlock) {
    run.check_cancelled();
    const int rows = std::min(kBlock, height - row);
    source(row, rows, cells.data());
    unknown = unknown || (!bytes && any_unknown(cells.data(), static_cast<size_t>(width) * static_cast<size_t>(rows)));
    const GDALDataType type = bytes ? GDT_Byte : GDT_Float32;
    if (dataset.GetRasterBand(1)->RasterIO(GF_Write, 0, row, width, rows, cells.data(), width, rows, type, 0, 0,
                                           nullptr) != CE_None)
      call.fail("cannot be written");
    run.report(0.8 * (row + rows) / height);
  }
  return unknown;
}

/// Halves until one tile holds it all.
void add_overviews(const GdalCall& call, GDALDataset& dataset, bool regions, const RunContext& run) {
  std::vector<int> factors;
  for (int factor = 2; std::max(dataset.GetRasterXSize(), dataset.GetRasterYSize()) > factor / 2 * kBlock; factor *= 2)
    factors.push_back(factor);
  if (factors.empty()) return;
  const auto stopped = [](double, const char*, void* context) {
    const auto* cancelled = static_cast<const RunContext*>(context)->cancelled;
    return cancelled != nullptr && cancelled->load() ? FALSE : TRUE;
  };
  const CPLErr result = dataset.BuildOverviews(regions ? "NEAREST" : "AVERAGE", static_cast<int>(factors.size()),
                                               factors.data(), 0, nullptr, stopped, const_cast<RunContext*>(&run));
  run.check_cancelled();
  if (result != CE_None) call.fail("its overviews cannot be written");
}

/// The file in the order of a cloud-optimised one, with the overviews that it has.
void lay_out_for_network(const GdalCall& call, const std::string& from, const std::string& to, bool regions) {
  CPLStringList how;
  how.SetNameValue("COMPRESS", "DEFLATE");
  how.SetNameValue("LEVEL", "4");
  how.SetNameValue("PREDICTOR", regions ? "NO" : "FLOATING_POINT");
  how.SetNameValue("BIGTIFF", "IF_SAFER");
  how.SetNameValue("OVERVIEW_RESAMPLING", regions ? "NEAREST" : "AVERAGE");
  DatasetPtr source(GDALDataset::Open(from.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (!source) call.fail("cannot be read again");
  DatasetPtr copy(GetGDALDriverManager()->GetDriverByName("COG")->CreateCopy(to.c_str(), source.get(), FALSE,
                                                                             how.List(), nullptr, nullptr));
  if (!copy) call.fail("cannot be written");
}

}  // namespace

void write_geotiff_rows(const GridFrame& frame, CellMeaning meaning, const RowSource& source, const std::string& path,
                        const Provenance& provenance, bool cloud_optimised, const RunContext& run) {
  const bool bytes = meaning == CellMeaning::regions;
  write_atomically(path, [&](const std::string& temporary) {
    GdalCall call(path);
    call.hide(temporary);
    const std::string plain = cloud_optimised ? temporary + ".rows.tif" : temporary;
    DatasetPtr dataset = create(call, plain, frame, bytes, thread_count(run));
    tag_place(*dataset, frame, provenance);
    if (meaning == CellMeaning::heights) tag_heights(*dataset);
    if (meaning == CellMeaning::regions) tag_regions(*dataset);
    if (copy_rows(call, *dataset, source, bytes, run))
      dataset->GetRasterBand(1)->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
    dataset->FlushCache(false);
    add_overviews(call, *dataset, bytes, run.part(0.8, 1.0));
    dataset.reset();
    if (cloud_optimised) lay_out_for_network(call, plain, temporary, bytes);
    call.check("cannot be written");
  });
}

}  // namespace seamount::io
