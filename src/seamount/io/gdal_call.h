// A stretch of GDAL calls on one file: registers the few drivers that we use, once, and turns what GDAL prints into one
// IoError. Not part of the public interface.
#pragma once

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace seamount::io {

/// While it lives, GDAL's messages of this thread are collected instead of printed.
class GdalCall {
 public:
  /// `path` is what messages name.
  explicit GdalCall(std::string path);
  ~GdalCall();
  GdalCall(const GdalCall&) = delete;
  GdalCall& operator=(const GdalCall&) = delete;

  /// Throws IoError{path}: "problem (what GDAL said first)".
  [[noreturn]] void fail(const std::string& problem) const;
  /// Throws if GDAL reported a failure since the start.
  void check(const std::string& problem) const {
    if (failed_) fail(problem);
  }
  bool said(const std::string& text) const { return message_.find(text) != std::string::npos; }
  const std::string& path() const { return path_; }
  /// A name of ours (a temporary file) that messages shall not show.
  void hide(const std::string& name) { hidden_ = name; }

 private:
  static void collect(CPLErr level, CPLErrorNum number, const char* message);

  std::string path_;
  std::string message_;
  std::string hidden_;
  bool failed_ = false;
};

/// Bytes under a /vsimem/ name that ends in `name`, gone with this object. The bytes are not copied.
class MemoryFile {
 public:
  MemoryFile(std::span<const uint8_t> bytes, const std::string& name);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// GDAL's handle types, closed by RAII.
struct DatasetCloser {
  void operator()(GDALDataset* dataset) const noexcept;
};
using DatasetPtr = std::unique_ptr<GDALDataset, DatasetCloser>;

/// Opens for reading with the given drivers ("GTiff", ...; nullptr last). Throws IoError, which calls the file not
/// `what` ("a JPEG") if no driver knows it.
DatasetPtr open_dataset(const GdalCall& call, const std::string& place, unsigned kind, const char* const* drivers,
                        const std::string& what, const char* const* options = nullptr);

/// A system from our text; nullopt-like empty pointer for empty text. Longitude before latitude. Throws
/// InvalidArgument{"crs"}.
std::unique_ptr<OGRSpatialReference> parse_crs(const std::string& crs);

/// The system of EPSG's list that this one is, where it has lost its code (WKT of ESRI's kind has none).
OGRSpatialReference identified(const OGRSpatialReference& system);

/// "EPSG:code" where known, else WKT 2 in one line; empty for nullptr.
std::string crs_text(const OGRSpatialReference* system);

/// WGS 84, longitude before latitude.
OGRSpatialReference lonlat_system();

struct TransformDeleter {
  void operator()(OGRCoordinateTransformation* transform) const { OGRCoordinateTransformation::DestroyCT(transform); }
};
using TransformPtr = std::unique_ptr<OGRCoordinateTransformation, TransformDeleter>;

}  // namespace seamount::io
