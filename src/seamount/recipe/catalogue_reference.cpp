#include "seamount/recipe/catalogue_reference.h"

#include <fmt/format.h>

#include <span>
#include <vector>

#include "seamount/model/catalogue.h"
#include "seamount/ops/ecosystem/word_help.h"
#include "seamount/recipe/reference_params.h"

namespace seamount::recipe {
namespace {

using ecosystem::WordHelp;

std::string words_text(std::span<const WordHelp> words) {
  std::string text;
  for (const WordHelp& help : words) text += fmt::format("  {}\n      {}\n", help.word, help.meaning);
  return text;
}

std::string words_table(std::span<const WordHelp> words) {
  std::string text = "| | |\n|---|---|\n";
  for (const WordHelp& help : words) text += fmt::format("| `{}` | {} |\n", cell(std::string(help.word)), help.meaning);
  return text + "\n";
}

bool is_list(const ParamInfo& info) { return info.kind == "groups"; }

/// A table of the members, and below it one for each list of groups among them.
std::string sections(const std::vector<ParamInfo>& params, const std::string& path) {
  std::string text = params_table(params);
  for (const ParamInfo& info : params) {
    if (!is_list(info)) continue;
    const std::string name = path + info.name;
    text += fmt::format("## {}\n\n{}.\n\n", name, info.help) + sections(info.tools.at(0).params, name + ".");
  }
  return text;
}

const char* const kHead =
    "Catalogues say what may grow in a scene and by which rules: materials, and classes of objects. A catalogue is a "
    "JSON file that begins with `\"seamount_catalogue\": 1`";

}  // namespace

std::string describe_catalogue() {
  std::string text = "members of the file, beside \"seamount_catalogue\": 1\n";
  for (const ParamInfo& info : describe_params<Catalogue>()) text += param_text(info, "  ", "");
  return text + "\nwords of expressions, at a place\n" + words_text(ecosystem::kWordHelp) + "\nfunctions\n" +
         words_text(ecosystem::kFunctionHelp);
}

std::string catalogue_markdown() {
  return std::string("<!-- Made by `seamount describe catalogue --markdown`. -->\n# Catalogues\n\n") + kHead +
         "; `seamount schema catalogue` prints its JSON Schema, `seamount info FILE` what one holds.\n\n" +
         sections(describe_params<Catalogue>(), "") + "## Words of expressions\n\n" +
         words_table(ecosystem::kWordHelp) +
         "An object never finds itself: `distance` of its own class is that to the next one. A value that is no number "
         "(a division of 0 by 0, a logarithm below 0) is said with a place, and nothing is born there.\n\n## "
         "Functions\n\n" +
         words_table(ecosystem::kFunctionHelp);
}

}  // namespace seamount::recipe
