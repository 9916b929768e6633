#include "seamount/recipe/document.h"

#include <algorithm>
#include <filesystem>

#include "seamount/io/atomic_file.h"
#include "seamount/recipe/domain.h"
#include "seamount/recipe/json_text.h"
#include "seamount/recipe/moved_names.h"

namespace seamount::recipe {
namespace {

/// Throws RecipeError for every defect but open inputs; places are looked for in the document's own text.
void check(const OrderedJson& root, const std::string& file, const std::string& folder, const Registry& registry) {
  Diagnostics defects, missing;
  read_document(Json(root), file, folder, defects, missing, registry);
  if (!defects.empty()) throw RecipeError(file, defects.items());
}

}  // namespace

Document::Document(const Registry& registry)
    : registry_(&registry),
      root_(OrderedJson::parse(
          R"({"seamount": 1, "domain": {"width_m": 10240, "height_m": 10240, "cell_m": 10}, "seed": 0, "steps": []})")) {
}

Document::Document(const std::string& text, std::string file, std::string folder, const Registry& registry)
    : registry_(&registry), file_(std::move(file)), folder_(std::move(folder)) {
  const JsonDocument document = parse_json(text, file_);
  Diagnostics defects, missing;
  read_document(document.root, file_, folder_, defects, missing, *registry_);
  if (!defects.empty()) {
    place_diagnostics(defects, document);
    throw RecipeError(file_, defects.items());
  }
  root_ = OrderedJson::parse(text);
}

Document Document::read(const std::string& path, const Registry& registry) {
  return {read_recipe_text(path), path, std::filesystem::path(path).parent_path().string(), registry};
}

std::vector<Change> Document::apply(const Edit& edit, const std::string& gesture) {
  return apply(std::vector<Edit>{edit}, gesture);
}

std::vector<Change> Document::apply(const std::vector<Edit>& edits, const std::string& gesture,
                                    const std::string& label, const std::string& author) {
  std::vector<Change> changes;
  try {
    for (const Edit& edit : edits) {
      for (Change& change : carry_out(root_, edit, *registry_)) changes.push_back(std::move(change));
    }
    check(root_, file_, folder_, *registry_);
  } catch (const OrderedJson::exception& error) {
    take_back(root_, changes);
    throw InvalidArgument("the edit", error.what());
  } catch (...) {
    take_back(root_, changes);
    throw;
  }
  if (changes.empty()) return changes;
  history_.resize(done_);
  if (gesture_goes_on_ && !gesture.empty() && done_ > 0 && history_.back().gesture == gesture) {
    join(history_.back().changes, changes);
  } else {
    history_.push_back({gesture, {}});
    join(history_.back().changes, changes);
    ++done_;
  }
  history_.back().label = label;
  history_.back().author = author;
  gesture_goes_on_ = true;
  ++revision_;
  return changes;
}

void Document::take_history(std::vector<Record> history, size_t done) {
  if (done > history.size()) throw InvalidArgument("done", "is more than the history has");
  history_ = std::move(history);
  done_ = done;
  gesture_goes_on_ = false;
}

bool Document::undo() {
  if (!can_undo()) return false;
  take_back(root_, history_[--done_].changes);
  gesture_goes_on_ = false;
  ++revision_;
  return true;
}

bool Document::redo() {
  if (!can_redo()) return false;
  make_again(root_, history_[done_++].changes);
  gesture_goes_on_ = false;
  ++revision_;
  return true;
}

Document Document::moved_to(const std::string& file) const {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const auto moved = [&](const OrderedJson& json, const std::string& pointer) {
    return seen_from(json, pointer, folder_, folder);
  };
  Document there(readable_text(moved(root_, "")), file, folder, *registry_);
  std::vector<Record> history = history_;
  for (Record& record : history) {
    for (Change& change : record.changes) {
      if (change.before) change.before = moved(*change.before, change.pointer);
      if (change.after) change.after = moved(*change.after, change.pointer);
    }
  }
  there.take_history(std::move(history), done_);
  return there;
}

std::string Document::text() const { return readable_text(root_); }

void Document::save(const std::string& path) const { io::write_text(path, text()); }

Recipe Document::recipe(std::optional<int> size) const {
  Json root(root_);
  apply_changes(root, {.sets = {}, .seed = {}, .size = size}, *registry_);
  Diagnostics none, missing;  // the steps say what is missing too
  return read_document(root, file_, folder_, none, missing, *registry_);
}

std::vector<Diagnostic> Document::missing() const {
  const JsonDocument document = parse_json(text(), file_);
  Diagnostics none, missing;
  read_document(document.root, file_, folder_, none, missing, *registry_);
  place_diagnostics(missing, document);
  return missing.items();
}

}  // namespace seamount::recipe
