// The JSON file beside a raster that cannot say its own scale (PNG, R16, R32, EXR, NPY): "height.r16" has
// "height.r16.json". Written with every such export, used by every such import. It knows the digest of its raster: one
// run's numbers are not taken for those of another.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "seamount/io/provenance.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// Values of the lowest and the highest code of an integer raster: 0 and 65535, or 0 and 255. high > low. Metres, or of
/// a field its own unit.
struct HeightRange {
  double low_m = 0.0;
  double high_m = 1.0;
  bool operator==(const HeightRange&) const = default;
};

/// One number that a person types into another program, with the place where it goes: {"Scale Z", "97.7"}.
using ImportNumber = std::pair<std::string, std::string>;

struct Sidecar {
  GridFrame frame;                   ///< size, cell, place and CRS of the samples, row 0 north
  double min_m = 0.0, max_m = 0.0;   ///< of the heights themselves, or of a field in its own unit
  std::optional<HeightRange> range;  ///< integer formats only
  bool ours = false;                 ///< read: it was written by us, not by hand for a file of another program
  bool south_first = false;          ///< the first row of the file is the southern one
  bool heights = true;               ///< metres above sea level; else any other scalar, and so are the values below
  int ground_width = 0;              ///< of a padded tile: samples in the north-west that are ground, the others repeat
  int ground_height = 0;             ///< its edge; 0: all are
  std::string target;                ///< "unreal", "unity", ...; empty: none in particular
  std::vector<ImportNumber> import;  ///< what to type in there
  bool for_painting = false;         ///< the raster is there to be changed by hand: its digest is not kept
  Provenance provenance;
};

/// "height.r16" -> "height.r16.json".
std::string sidecar_path(const std::string& raster_path);

/// Writes the side-car of a raster that is there already. Throws WriteError.
void write_sidecar(const Sidecar& sidecar, const std::string& raster_path);

/// The side-car of a raster whose bytes are at hand, if there is one. Throws IoError if it cannot be understood, or if
/// it was written for other bytes; one without a digest, of an earlier version or made by hand, is believed.
std::optional<Sidecar> read_sidecar(const std::string& raster_path, std::span<const uint8_t> raster);

/// The same; reads the raster to compare it.
std::optional<Sidecar> read_sidecar(const std::string& raster_path);

}  // namespace seamount::io
