// Environmental objects from and to GIS files: GeoJSON and GeoPackage. Features are the truth: what is moved, added or
// taken away in a GIS comes back so; all else that a scene needs goes along as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/skeleton.h"

namespace seamount::io {

struct ObjectFeature {
  std::string of_class;
  uint64_t id = 0;  ///< 0: it has none yet
  Skeleton skeleton;
  double size = 1.0;
  double fitness = 0.0;
  int born = 0;
  int age = 0;  ///< written for readers; not read
  int window = 0;
  bool keep = false;
};

struct ObjectFile {
  std::vector<ObjectFeature> objects;
  std::string crs;   ///< of the places, as GridFrame::crs
  std::string head;  ///< JSON text of all else; empty: the file has none
};

/// By extension: .gpkg (layers "points", "curves" and "regions" in the objects' system, exact; the head as metadata
/// "seamount_scene") or .geojson (longitude and latitude to a hundredth of a millimetre where a system is known, else
/// metres, exact; the head as a member "seamount_scene"). Fields: class, id, size, fitness, born, age, window, keep,
/// hold. Throws IoError.
void write_objects(const ObjectFile& file, const std::string& path);

/// What write_objects() wrote, also after a GIS has edited it: unknown fields are passed over, missing ones have their
/// defaults, parts of multi-geometries are objects of their own. Throws IoError: no such file, no field "class", holes
/// in regions, a place that is not finite; Cancelled.
ObjectFile read_objects(const std::string& path, const RunContext& run = {});

/// Does the file hold a head? False for one that is no GeoJSON or GeoPackage. Throws IoError: no such file.
bool has_scene(const std::string& path);

}  // namespace seamount::io
