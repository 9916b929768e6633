// What the studio was told, safe on disk before it is acknowledged, so that a session comes back after a crash with its
// history. A file of lines, each a checksum and a JSON object: first a snapshot of the document with its history, then
// what happened since. A line that was cut off by the crash was never acknowledged and is let go.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "seamount/recipe/document.h"

namespace seamount::server {

/// What a journal holds.
struct Remembered {
  std::string file;        ///< absolute; "" for a document that was never saved
  std::string saved_text;  ///< of the file when it was read or saved last
  recipe::Document document;
};

class Journal {
 public:
  /// The journal of a document's file (absolute) in a folder. One studio has it at a time. Throws IoError{file} where
  /// another has.
  Journal(const std::string& folder, const std::string& file);
  /// A new journal of a document that was never saved.
  static std::unique_ptr<Journal> of_unsaved(const std::string& folder);
  /// The newest journal of such a document that no other studio has; nullptr if there is none.
  static std::unique_ptr<Journal> newest_unsaved(const std::string& folder);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The document as it was left; nothing where there is no journal, or none that can be read. `folder`: of the
  /// document's relative names.
  std::optional<Remembered> read(const std::string& document_folder, const recipe::Registry& registry) const;

  /// Begins anew with a document as it is. Whole or not at all. Throws WriteError.
  void begin(const recipe::Document& document, const std::string& saved_text);

  // One line each, on disk when the call returns. Throws WriteError. REQUIRES: begin().
  void edit(const std::vector<recipe::Edit>& edits, const std::string& gesture, const std::string& label,
            const std::string& author);
  void undo();
  void redo();
  void saved(const std::string& text);

  /// Lines since the snapshot.
  int length() const { return length_; }

  /// Puts the journal aside, where it stays for whoever misses something; its new path, "" if there was none.
  std::string put_aside();
  /// Takes the journal away.
  void remove();

  const std::string& path() const { return path_; }

 private:
  struct Named {};
  Journal(Named, std::string path, std::string file);
  bool lock();
  void append(const recipe::OrderedJson& record);

  std::string path_;
  std::string file_;
  int descriptor_ = -1;
  int lock_ = -1;
  int length_ = 0;
};

/// $XDG_STATE_HOME/seamount, or ~/.local/state/seamount; the temporary folder where there is no home.
std::string default_state_folder();

}  // namespace seamount::server
