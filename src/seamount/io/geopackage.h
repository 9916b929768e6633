// GeoPackages are SQLite databases: a view in one is a program that runs when it is read. Not part of the public
// interface.
#pragma once

#include <string>

#include "seamount/base/run_context.h"

class GDALDataset;

namespace seamount::io {

/// Throws IoError{path} unless the schema can be trusted: virtual tables of SQLite's own index modules only (one of
/// VirtualText reads any text file of the user), and layers that are tables, or views of tables that plain SQLite can
/// read with its own functions, without recursion, and whose first row comes soon. Triggers do nothing in a file that
/// is only read, and are not looked at. Nothing but the file itself is opened. What is no database at all passes:
/// whoever opens it will say so. Throws Cancelled.
void check_geopackage(const std::string& path, const RunContext& run);

/// Lets a GeoPackage that GDAL has opened stop in the middle of a query when `run` is cancelled. `run` must outlive the
/// dataset.
void watch_queries(GDALDataset& dataset, const RunContext& run);

}  // namespace seamount::io
