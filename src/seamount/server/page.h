// The studio's page: the files that studio/ builds, in memory, as the server hands them out.
#pragma once

#include <map>
#include <string>

namespace seamount::server {

class Page {
 public:
  struct File {
    std::string type;     ///< MIME
    std::string bytes;    ///< as they are
    std::string brotli;   ///< compressed; empty: not there
    std::string gzip;     ///< compressed; empty: not there
    std::string version;  ///< of the content, for ETag
  };

  /// Reads a folder, whose index.html is the page. Throws IoError where there is none.
  explicit Page(const std::string& folder);

  /// "/" or the name of a file: "/app.js"; nullptr if there is none.
  const File* find(const std::string& path) const;

 private:
  std::map<std::string, File> files_;
};

/// The first of shared_folders(Shared::studio) that holds the page. Throws IoError, saying how it is built, where none
/// does.
std::string find_page();

}  // namespace seamount::server
