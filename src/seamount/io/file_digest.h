// What a file holds, as a number: for cache keys. Files that are read beside the named one belong to it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seamount/base/hash.h"
#include "seamount/base/run_context.h"

namespace seamount::io {

/// The files beside `path` that its reader may open too, in any letter case, sorted: side-cars (height.png.json), world
/// files (.tfw, .pgw, .wld, ...), .prj, .aux.xml, .ovr, .msk, .tab; a Shapefile's .shx, .dbf, .cpg, .qix, ...; the
/// journal and the write-ahead log of a GeoPackage, which holds what an open QGIS has edited. (Its -shm is only an
/// index of that log, made anew by whoever opens it.) Of a link, also those beside the file that it leads to.
std::vector<std::string> companions_of(const std::string& path);

/// The content of a file and its companions as it was at one moment.
///
/// To keep a result that depends on the file: take a snapshot, put its digest into the key, read, compute, and keep the
/// result only if still_valid(). What was read is then what was hashed, whoever wrote to the file meanwhile.
class FileSnapshot {
 public:
  /// Reads all of it once. Throws IoError if the file is missing, not a regular file, or does not stand still;
  /// Cancelled.
  explicit FileSnapshot(const std::string& path, const RunContext& run = {});

  const std::string& path() const { return path_; }

  /// Hash of the content, and of that of every companion with its ending.
  const Digest& digest() const { return digest_; }

  /// Whether nothing was written, replaced, added or removed since. Costs a listing of the folder; reads the files
  /// again only if they had been written less than two seconds before the snapshot, when times are too coarse to tell.
  /// Throws Cancelled.
  bool still_valid(const RunContext& run = {}) const;

 private:
  /// What tells a file from another one, or from itself before it was written to.
  struct Identity {
    std::string path;
    uint64_t device = 0, inode = 0, size = 0;
    int64_t written_ns = 0, changed_ns = 0;
    bool operator==(const Identity&) const = default;
  };

  void read(const RunContext& run);
  static Identity identity_of(const std::string& path);
  std::vector<Identity> identities() const;

  std::string path_;
  Digest digest_;
  std::vector<Identity> files_;  ///< the file, then its companions
  bool young_ = false;           ///< written so shortly before that its times may not show the next write
};

/// Hash of one file's bytes, without companions: that of hash_bytes(). Throws IoError, Cancelled.
Digest content_digest(const std::string& path, const RunContext& run = {});

/// The digest of a snapshot.
Digest file_digest(const std::string& path, const RunContext& run = {});

}  // namespace seamount::io
