#include "seamount/recipe/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "seamount/base/text.h"
#include "seamount/recipe/prepare_output.h"
#include "seamount/recipe/reference_params.h"

namespace seamount::recipe {
namespace {

struct Paper {
  std::string_view short_name, title;
};

/// The papers that sources name by a letter and a number, as docs/bibliography.md has them.
constexpr std::array<Paper, 5> kPapers = {
    {{"P0", "Automatic generation of coral reef islands"},
     {"P1", "Guerin et al. 2017, Interactive example-based terrain authoring with conditional GANs"},
     {"P2", "Huftier et al., Terrain synthesis and authoring based on iso-contours"},
     {"P3", "Semantic terrain representation"},
     {"P4", "Li 2021, Procedural modeling of the Great Barrier Reef"}}};

/// "source: P4 sec. 3.2", and what P4 is.
std::string source_text(const std::string& source) {
  if (source.empty()) return "";
  std::string text = "source: " + source + "\n";
  for (const Paper& paper : kPapers) {
    if (source.find(paper.short_name) != std::string::npos)
      text += fmt::format("  {}: {}\n", paper.short_name, paper.title);
  }
  return text;
}

/// How far a cell of its rasters looks: whether it can be run tile by tile.
std::string looks_text(const Operator& op) {
  return (op.looks.empty() ? "at everything" : op.looks) + (op.in_tiles.empty() ? "" : "; in tiles " + op.in_tiles);
}

std::string params_text(const std::vector<ParamInfo>& params) {
  std::string text;
  for (const ParamInfo& info : params) text += param_text(info, "  ", "--");
  return text;
}

std::string ports_text(const std::string& title, const std::vector<Port>& ports) {
  if (ports.empty()) return "";
  std::string text = title + "\n";
  for (const Port& port : ports) {
    text += fmt::format("  {} ({}{})\n      {}\n", port.name, port.kind->name, port.required ? "" : ", optional",
                        port.help);
  }
  return text + "\n";
}

std::string ports_list(const std::string& title, const std::vector<Port>& ports) {
  if (ports.empty()) return "";
  std::string text = title + "\n\n";
  for (const Port& port : ports) {
    text +=
        fmt::format("- `{}` ({}{}): {}\n", port.name, port.kind->name, port.required ? "" : ", optional", port.help);
  }
  return text + "\n";
}

}  // namespace

std::string describe_operator(const Operator& op) {
  std::string text = fmt::format("{}  -  {}\n", op.name, op.summary);
  text += source_text(op.source);
  if (op.stochastic) text += "depends on the seed\n";
  text += "looks " + looks_text(op) + "\n";
  text += "\n" + ports_text("inputs", op.in) + ports_text("outputs", op.out);
  return text + "parameters\n" + params_text(op.params);
}

std::string describe_format(const OutputFormat& format) {
  std::vector<std::string> kinds;
  for (const Kind* kind : format.accepts) kinds.push_back(kind->name);
  return fmt::format("{}  -  {}\nwrites {} to {}\n\nparameters\n{}", format.name, format.summary,
                     fmt::join(kinds, ", "), written_to(format), params_text(format.params));
}

std::string describe_kind(const Kind& kind, const Registry& registry) {
  std::vector<std::string> makers, takers;
  const auto has = [&](const std::vector<Port>& ports) {
    return std::any_of(ports.begin(), ports.end(), [&](const Port& port) { return port.kind == &kind; });
  };
  for (const auto& op : registry.operators()) {
    if (has(op->out)) makers.push_back(op->name);
    if (has(op->in)) takers.push_back(op->name);
  }
  return fmt::format("{}  -  {}\nread from {}\nmade by {}\ntaken by {}\n", kind.name, kind.about,
                     kind.reads.empty() ? "no file" : fmt::format("{}", fmt::join(kind.reads, ", ")),
                     fmt::join(makers, ", "), fmt::join(takers, ", "));
}

std::string reference_markdown(const Registry& registry) {
  std::string text =
      "# Operators and output formats\n\n"
      "Made by `seamount describe --markdown` from the tables that the program itself reads; do not edit.\n\n"
      "Lengths are metres, z is up, sea level is 0. A *curve* is a list of knots `[x, y]`, *strokes* are\n"
      "`{\"points\": [[x, y], ...], \"width_m\": w, \"strength_m\": s}`, *outlines* are radii (one number: a circle) "
      "at equal steps of\n"
      "the angle, *polygons* are rings of points, *regions* are rings or\n"
      "`{\"name\": n, \"ring\": [[x, y], ...], \"height_m\": h, \"peak_m\": p, \"basin\": false}`, *rivers* are lines "
      "from source to "
      "mouth "
      "or\n`{\"points\": [[x, y], ...], \"bed_m\": [...], \"source_width_m\": w, \"mouth_width_m\": w}`. *Derived* "
      "defaults "
      "follow from the\ninput.\n\n"
      "The members of a *group* are flags of their own: `--walk.stickiness 0.5`. Papers, P0 to P4 among them, are in "
      "the\n"
      "[bibliography](bibliography.md), words in the [glossary](glossary.md).\n\n";
  for (const auto& row : registry.operators()) {
    const Operator& op = *row;
    text += fmt::format("## {}\n\n{}.\n\n", op.name, op.summary);
    if (!op.source.empty())
      text += fmt::format("Source: {}.{}\n\n", op.source, op.stochastic ? " Depends on the seed." : "");
    text += fmt::format("Looks {}.\n\n", looks_text(op));
    text += ports_list("Inputs", op.in) + ports_list("Outputs", op.out) + params_table(op.params);
  }
  text += "# Output formats\n\nChosen by `\"as\"` in a recipe's output, or by the file's extension.\n\n";
  for (const auto& row : registry.formats()) {
    const OutputFormat& format = *row;
    std::vector<std::string> kinds;
    for (const Kind* kind : format.accepts) kinds.push_back(kind->name);
    text += fmt::format("## as {}\n\n{} ({} to {}).\n\n{}", format.name, format.summary, fmt::join(kinds, ", "),
                        written_to(format), params_table(format.params));
  }
  text += "# Kinds of values\n\n| kind | | read from |\n|---|---|---|\n";
  for (const Kind* kind : registry.kinds())
    text += fmt::format("| {} | {} | {} |\n", kind->name, kind->about, fmt::join(kind->reads, ", "));
  return text;
}

}  // namespace seamount::recipe
