#include "seamount/io/geopackage_write.h"

#include <memory>

#include "seamount/io/atomic_file.h"

namespace seamount::io {
namespace {

/// The time of writing goes into the file: a fixed one, while this lives.
class FixedDate {
 public:
  FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z"); }
  ~FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr); }
  FixedDate(const FixedDate&) = delete;
  FixedDate& operator=(const FixedDate&) = delete;
};

}  // namespace

void write_new_geopackage(const std::string& path, const std::string& crs, const FillGeopackage& fill) {
  write_atomically(path, [&](const std::string& temporary) {
    GdalCall call(path);
    call.hide(temporary);
    const FixedDate date;
    const std::unique_ptr<OGRSpatialReference> system = parse_crs(crs.empty() ? kLocalMetres : crs);
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    DatasetPtr dataset(driver->Create(temporary.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!dataset || dataset->StartTransaction() != OGRERR_NONE) call.fail("cannot be written");
    fill(*dataset, *system, call);
    if (dataset->CommitTransaction() != OGRERR_NONE) call.fail("cannot be written");
    dataset.reset();
    call.check("cannot be written");
  });
}

}  // namespace seamount::io
