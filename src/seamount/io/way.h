// Points from one coordinate system to another. Not part of the public interface.
#pragma once

#include <string>
#include <vector>

#include "seamount/io/gdal_call.h"
#include "seamount/model/drawn.h"

namespace seamount::io {

class Way {
 public:
  /// Throws InvalidArgument{"crs"} where there is none, or a system is not known.
  Way(const OGRSpatialReference& from, const OGRSpatialReference& to);
  Way(const std::string& from, const std::string& to);

  /// In place. Throws InvalidArgument{"crs"} for a point outside of either system, naming it. Linear.
  void move(std::vector<Vec2>& points) const;

 private:
  GdalCall call_;
  TransformPtr way_;
};

}  // namespace seamount::io
