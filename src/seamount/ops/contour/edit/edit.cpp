#include "seamount/ops/contour/edit/edit.h"

#include <optional>

#include "seamount/base/text.h"
#include "seamount/ops/contour/edit/edit_moves.h"
#include "seamount/ops/contour/edit/fill.h"
#include "seamount/ops/contour/edit/pattern.h"

namespace seamount::contour {
namespace {

/// A session under way.
class Session {
 public:
  Session(const ContourSet& contours, const PatternSource& patterns) : set_(contours), patterns_(patterns) {}

  ContourSet& set() { return set_; }

  template <class Tool>
  void use(const Tool& tool, const ToolContext& context) {
    apply(tool, set_, context);
  }

  void use(const DeleteTool& tool, const ToolContext& context) {
    if (describe(tool.select) == "all")
      throw InvalidArgument(context.name + ".select", "says nothing; for all contours ask for heights from -12000 m");
    const std::vector<size_t> chosen = select(set_, tool.select, context.name + ".select");
    if (chosen.empty())
      throw InvalidArgument(context.name + ".select", "there is no such contour: " + describe(tool.select));
    std::vector<char> gone(set_.contours.size(), 0);
    for (const size_t i : chosen) gone[i] = 1;
    remove_contours(set_, gone);
  }

  void use(const CopyTool& tool, const ToolContext& context) {
    copied_ = make_pattern(set_, find_outline(set_, tool.within, tool.select, context.name));
  }

  void use(const CutTool& tool, const ToolContext& context) {
    const Outline outline = find_outline(set_, tool.within, tool.select, context.name);
    copied_ = make_pattern(set_, outline);
    clear_outline(outline, set_, context.name, context.run);
  }

  void use(const PasteTool& tool, const ToolContext& context) {
    std::optional<Drawing> read;
    if (!tool.file.path.empty()) read = read_file(tool.file, context.name + ".file");
    const Drawing* pattern = read ? &*read : copied_ ? &*copied_ : patterns_.input;
    if (pattern == nullptr)
      throw InvalidArgument(context.name, "there is nothing to paste: name a file, copy before, or connect a pattern");
    check_pattern(*pattern, read ? context.name + ".file" : context.name);
    paste_pattern(*pattern, tool, set_, context.name, context.run);
  }

  void use(const FillTool& tool, const ToolContext& context) {
    const Outline outline = find_outline(set_, tool.within, tool.select, context.name);
    if (outline.contour >= 0 && !tool.files.empty())
      throw InvalidArgument(context.name + ".files", "serve polygons (\"within\"); a contour is filled from its like");
    std::vector<LibraryPattern> library;
    for (size_t i = 0; i < tool.files.size(); ++i) {
      const std::string name = context.name + ".files[" + std::to_string(i) + "]";
      library.push_back({tool.files[i].path, read_file(tool.files[i], name)});
      check_pattern(library.back().pattern, name);
    }
    fill_outline(outline, tool, library, set_, context.name, context.seed, context.run);
  }

 private:
  Drawing read_file(const FilePath& file, const std::string& name) const {
    if (!patterns_.read_file) throw InvalidArgument(name, "files cannot be read here");
    return patterns_.read_file(file);
  }

  ContourSet set_;
  const PatternSource& patterns_;
  std::optional<Drawing> copied_;
};

}  // namespace

ContourSet edit(const ContourSet& contours, const EditParams& params, const PatternSource& patterns, Seed seed,
                const RunContext& run) {
  check_params(params);
  run.check_cancelled();
  Session session(contours, patterns);
  for (size_t i = 0; i < params.edits.size(); ++i) {
    run.check_cancelled();
    const ToolContext context{"edits[" + std::to_string(i) + "]", params.on_crossing, seed.derive("edit", i), run};
    std::visit([&](const auto& tool) { session.use(tool, context); }, params.edits[i]);
    run.report(static_cast<double>(i + 1) / static_cast<double>(params.edits.size()));
  }
  return std::move(session.set());
}

}  // namespace seamount::contour
