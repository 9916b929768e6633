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

/// Where the page is looked for: $SEAMOUNT_STUDIO, share/seamount/studio beside the program, the sources, where it is
/// installed. Throws IoError, saying how it is built, where it is nowhere.
std::string find_page();

}  // namespace seamount::server
