// A recipe that is being edited: its JSON as written (order of members, remarks), recorded edits with undo and redo,
// and what is still missing.
//
// A document is a recipe that `run` would take, except that it may be incomplete: a required input may be open. An
// incomplete step, and what follows from it, is not computed; the others are. Any other defect is refused, with the
// diagnostics that reading a recipe gives, and nothing changes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seamount/recipe/edit.h"
#include "seamount/recipe/recipe.h"

namespace seamount::recipe {

class Document {
 public:
  /// A new document: a domain and no steps. The registry must outlive every document, as in what follows.
  explicit Document(const Registry& registry = standard_registry());

  /// Reads recipe text; `file` is for messages, relative file names start at `folder`. Throws RecipeError for every
  /// defect but open inputs.
  Document(const std::string& text, std::string file, std::string folder,
           const Registry& registry = standard_registry());

  /// Reads a recipe file. Throws IoError, RecipeError.
  static Document read(const std::string& path, const Registry& registry = standard_registry());

  /// Carries out an edit. Edits in a row that have the same `gesture` (a slider's drag, a stroke) are undone as one;
  /// an empty one belongs to no gesture. Throws RecipeError or InvalidArgument and changes nothing where the result
  /// would be no recipe. Returns what it changed, in order. Cost: that of checking the document, about 1 ms for 100 kB.
  std::vector<Change> apply(const Edit& edit, const std::string& gesture = "");

  /// Several edits as one: all or none. `label` and `author` stand in the history, those of a gesture's last edit.
  std::vector<Change> apply(const std::vector<Edit>& edits, const std::string& gesture = "",
                            const std::string& label = "", const std::string& author = "");

  /// Takes back, or makes again, the newest gesture. False: there is none.
  bool undo();
  bool redo();
  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < history_.size(); }

  /// What was changed, oldest first: for a history that is shown, and for a journal. The first done() of them are in
  /// force, the others can be made again.
  struct Record {
    std::string gesture;
    std::vector<Change> changes;
    std::string label = "";   ///< for people
    std::string author = "";  ///< whose edit it was
  };
  const std::vector<Record>& history() const { return history_; }
  size_t done() const { return done_; }

  /// Takes over a history that led to this very content and was kept elsewhere. Throws InvalidArgument{"done"} for more
  /// than there are.
  void take_history(std::vector<Record> history, size_t done);

  /// Raised by every edit, undo and redo.
  uint64_t revision() const { return revision_; }

  const OrderedJson& json() const { return root_; }

  /// The document as the text of a recipe: readable, and the same for the same content.
  std::string text() const;

  /// Writes text() to a file, whole or not at all. Throws IoError.
  void save(const std::string& path) const;

  /// The same document, history included, as it is to be in another file: names of files that are relative lead from
  /// the file's folder to where they led before. Throws RecipeError.
  Document moved_to(const std::string& file) const;

  const std::string& file() const { return file_; }
  const std::string& folder() const { return folder_; }

  /// The document as a recipe; steps that cannot run yet say why in `incomplete`. `size`: with so many cells along the
  /// longer side of the domain, as `--size` does.
  Recipe recipe(std::optional<int> size = std::nullopt) const;

  /// What is still missing: open inputs, with their places in text().
  std::vector<Diagnostic> missing() const;

 private:
  const Registry* registry_;
  OrderedJson root_;
  std::string file_;
  std::string folder_;
  std::vector<Record> history_;
  size_t done_ = 0;
  uint64_t revision_ = 0;
  bool gesture_goes_on_ = false;  ///< the last thing that happened was an edit, not an undo
};

}  // namespace seamount::recipe
