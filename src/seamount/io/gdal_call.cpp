#include "seamount/io/gdal_call.h"

#include <cpl_http.h>
#include <cpl_vsi.h>
#include <gdal_frmts.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>

#include "seamount/base/error.h"

namespace seamount::io {
namespace {

/// A file may name its coordinate system by an address on the network. We never go there.
CPLHTTPResult* refuse_network(const char*, CSLConstList, GDALProgressFunc, void*, CPLHTTPFetchWriteFunc, void*, void*) {
  auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  result->nStatus = 1;
  result->pszErrBuf = CPLStrdup("files are not fetched from the network");
  return result;
}

/// For destructors: GDAL is C++ and may run out of memory while it closes something.
template <class Function>
void without_throwing(const Function& function) noexcept {
  try {
    function();
  } catch (...) {
    // Something stays open in a program that has no memory left.
  }
}

/// Only what we read and write, which also leaves less to attack.
void register_drivers() {
  static std::once_flag once;
  std::call_once(once, [] {
    GDALSetCacheMax64(
        GIntBig{128} << 20);  // its default, a twentieth of the memory, is more than a large terrain needs
    GDALRegister_GTiff();
    GDALRegister_COG();
    GDALRegister_SRTMHGT();
    GDALRegister_AAIGrid();
    GDALRegister_JPEG();
    GDALRegister_MEM();
    RegisterOGRGeoJSON();
    RegisterOGRGeoPackage();
    RegisterOGRShape();
    CPLHTTPSetFetchCallback(refuse_network, nullptr);
    CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");  // no .aux.xml files beside what we read or write
    CPLSetConfigOption("OGR_GEOJSON_MAX_OBJ_SIZE", "200");
  });
}

}  // namespace

GdalCall::GdalCall(std::string path) : path_(std::move(path)) {
  register_drivers();
  CPLPushErrorHandlerEx(&GdalCall::collect, this);
  CPLErrorReset();
}

GdalCall::~GdalCall() {
  without_throwing([] {
    CPLPopErrorHandler();
    CPLErrorReset();
  });
}

void GdalCall::collect(CPLErr level, CPLErrorNum, const char* message) {
  GdalCall& call = *static_cast<GdalCall*>(CPLGetErrorHandlerUserData());
  if (level < CE_Failure) return;
  call.failed_ = true;
  if (call.message_.empty()) call.message_ = message;
}

void GdalCall::fail(const std::string& problem) const {
  constexpr size_t kLongest = 200;
  std::string said = message_;
  for (const std::string& name : {hidden_, path_}) {
    for (size_t at = said.find(name); !name.empty() && at != std::string::npos; at = said.find(name))
      said.replace(at, name.size(), "file");
  }
  std::replace_if(
      said.begin(), said.end(), [](unsigned char c) { return c < ' '; }, ' ');
  if (said.size() > kLongest) said = said.substr(0, kLongest) + "...";
  throw IoError(path_, said.empty() ? problem : problem + " (" + said + ")");
}

MemoryFile::MemoryFile(std::span<const uint8_t> bytes, const std::string& name) {
  static std::atomic<unsigned> count{0};
  path_ = "/vsimem/seamount-" + std::to_string(count++) + "/" + std::filesystem::path(name).filename().string();
  VSILFILE* file = VSIFileFromMemBuffer(path_.c_str(), const_cast<uint8_t*>(bytes.data()), bytes.size(), FALSE);
  if (file == nullptr) throw IoError(name, "cannot be read from memory");
  VSIFCloseL(file);
}

MemoryFile::~MemoryFile() {
  without_throwing([this] { VSIUnlink(path_.c_str()); });
}

void DatasetCloser::operator()(GDALDataset* dataset) const noexcept {
  without_throwing([dataset] { GDALClose(dataset); });
}

DatasetPtr open_dataset(const GdalCall& call, const std::string& place, unsigned kind, const char* const* drivers,
                        const std::string& what, const char* const* options) {
  DatasetPtr dataset(static_cast<GDALDataset*>(
      GDALOpenEx(place.c_str(), kind | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers, options, nullptr)));
  if (!dataset && call.said("not recognized")) throw IoError(call.path(), "is not " + what + ", or is cut short");
  if (!dataset) call.fail("cannot be read");
  return dataset;
}

std::unique_ptr<OGRSpatialReference> parse_crs(const std::string& crs) {
  if (crs.empty()) return nullptr;
  const GdalCall call("crs");
  auto system = std::make_unique<OGRSpatialReference>();
  constexpr const char* const kNoFiles[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
  if (system->SetFromUserInput(crs.c_str(), kNoFiles) != OGRERR_NONE)
    throw InvalidArgument("crs", "'" + crs.substr(0, 80) + "' is not a coordinate reference system");
  system->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return system;
}

OGRSpatialReference identified(const OGRSpatialReference& system) {
  constexpr int kCertain = 90;  // per cent
  OGRSpatialReference* found = system.IsEmpty() || system.GetAuthorityCode(nullptr) != nullptr
                                   ? nullptr
                                   : system.FindBestMatch(kCertain, "EPSG", nullptr);
  if (found == nullptr) return system;
  OGRSpatialReference result = *found;
  found->Release();
  result.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return result;
}

std::string crs_text(const OGRSpatialReference* system) {
  if (system == nullptr || system->IsEmpty()) return {};
  const char* authority = system->GetAuthorityName(nullptr);
  const char* code = system->GetAuthorityCode(nullptr);
  if (authority != nullptr && code != nullptr) return std::string(authority) + ":" + code;
  char* wkt = nullptr;
  constexpr const char* const kOptions[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
  const bool written = system->exportToWkt(&wkt, kOptions) == OGRERR_NONE;
  std::string text = written && wkt != nullptr ? wkt : "";
  CPLFree(wkt);
  return text;
}

OGRSpatialReference lonlat_system() {
  OGRSpatialReference system;
  system.SetWellKnownGeogCS("WGS84");
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return system;
}

}  // namespace seamount::io
