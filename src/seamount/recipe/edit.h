// Edits of a recipe: what a person asks for (Edit), and what was changed for it (Change), which can be taken back and
// done again exactly.
//
// Places are JSON pointers into the document. A step may be named by its id instead of its index: "/steps/reef/params/
// subsidence" stays right when steps are moved.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "seamount/recipe/json_document.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// JSON whose members keep the order in which they were written.
using OrderedJson = nlohmann::ordered_json;

/// Gives a member of an object, or an item of a list, a value; without one the member is taken out, so that a parameter
/// has its default again. Objects on the way that are missing ("params", "in", "domain", a group) are made.
struct SetValue {
  std::string pointer;
  std::optional<OrderedJson> value;
};

/// Puts an item into a list (steps, outputs, strokes) before the one at `index`; at its end without an index. The
/// document's own lists are made if they are missing.
struct InsertItem {
  std::string list;
  std::optional<size_t> index;
  OrderedJson value;
};

/// Takes an item out of a list and changes nothing else. For steps see RemoveStep.
struct RemoveItem {
  std::string item;
};

/// Moves an item within its list, to where `index` then is its index.
struct MoveItem {
  std::string item;
  size_t index = 0;
};

/// Gives a step another id, wherever it is named. Its result stays the same: the seed that followed from its old id is
/// written down if the operator uses one.
struct RenameStep {
  std::string id;
  std::string new_id;
};

/// Takes a step out. What was connected to it is connected to what it would have passed on when bypassed; where that is
/// nothing, inputs are left open, and outputs are taken out.
struct RemoveStep {
  std::string id;
};

using Edit = std::variant<SetValue, InsertItem, RemoveItem, MoveItem, RenameStep, RemoveStep>;

// Edits by what they mean. An operator's parameter may be a path: "edits/2/radius_m".
Edit set_parameter(const std::string& step, const std::string& parameter, std::optional<OrderedJson> value);
Edit add_step(OrderedJson step, std::optional<size_t> index = std::nullopt);
/// `source`: "step.port"; empty: the input is left open.
Edit connect(const std::string& step, const std::string& port, const std::string& source);
Edit connect_file(const std::string& step, const std::string& port, const std::string& file);
Edit bypass(const std::string& step, bool on);
Edit set_seed(uint64_t seed);
Edit set_domain(const std::string& member, double value);

/// One elementary change, with indices only. Of `before` and `after` one may be absent: the value is put in or taken
/// out. `index` is its place among the members or items, so that taking back restores the order too.
struct Change {
  std::string pointer;
  size_t index = 0;
  std::optional<OrderedJson> before;
  std::optional<OrderedJson> after;
};

/// Carries out an edit and returns what it changed, in order. Throws InvalidArgument{pointer} for a place that is not
/// there; `root` is then as before. Whether the result is a recipe is the document's question.
std::vector<Change> carry_out(OrderedJson& root, const Edit& edit, const Registry& registry);

/// Takes changes back, the last one first. REQUIRES: they are the last that were made.
void take_back(OrderedJson& root, const std::vector<Change>& changes);
/// Makes them again. REQUIRES: the document is as it was before them.
void make_again(OrderedJson& root, const std::vector<Change>& changes);

/// Joins changes to those before them; a value that was set twice is one change.
void join(std::vector<Change>& changes, std::vector<Change> later);

}  // namespace seamount::recipe
