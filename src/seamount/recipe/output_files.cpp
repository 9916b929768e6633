#include "seamount/recipe/output_files.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>

#include "seamount/io/file_digest.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Does some text fit both patterns? `in_a`, `in_b`: the star before a[i], b[j] may go on.
bool meet(std::string_view a, std::string_view b, bool in_a, bool in_b) {
  if (a.empty() && b.empty()) return true;
  if (!a.empty() && a[0] == '*' && !in_a && !b.empty()) {
    if (b[0] == '*') return meet(a.substr(1), b.substr(1), true, true);
    return is_digit(b[0]) && meet(a.substr(1), b.substr(1), true, in_b);
  }
  if (!b.empty() && b[0] == '*' && !in_b && !a.empty())
    return is_digit(a[0]) && meet(a.substr(1), b.substr(1), in_a, true);
  if (in_a && !b.empty() && is_digit(b[0]) && meet(a, b.substr(1), in_a, in_b)) return true;
  if (in_b && !a.empty() && is_digit(a[0]) && meet(a.substr(1), b, in_a, in_b)) return true;
  return !a.empty() && !b.empty() && a[0] == b[0] && a[0] != '*' && meet(a.substr(1), b.substr(1), false, false);
}

/// The file of an absolute or relative name, links on the way to it followed.
std::string canonical_name(const fs::path& path) {
  std::error_code error;
  const fs::path found = fs::weakly_canonical(fs::absolute(path), error);
  return (error ? path : found).lexically_normal().string();
}

}  // namespace

bool may_be_same_file(const std::string& a, const std::string& b) { return a == b || meet(a, b, false, false); }

void check_outputs_apart(const std::vector<Output>& outputs, const ReadPlace& place) {
  for (size_t i = 0; i < outputs.size(); ++i) {
    for (size_t earlier = 0; earlier < i; ++earlier) {
      const auto clash = [&]() -> std::optional<std::string> {
        for (const std::string& file : outputs[i].files) {
          for (const std::string& other : outputs[earlier].files) {
            if (may_be_same_file(file, other)) return file;
          }
        }
        return std::nullopt;
      }();
      if (!clash) continue;
      const Output& other = outputs[earlier];
      place.at(i).at("path").fail(
          outputs[i].path == other.path ? fmt::format("output {} already writes '{}'", earlier, *clash)
          : *clash == outputs[i].path
              ? fmt::format("'{}' is also written by output {} ('{}')", *clash, earlier, other.path)
              : fmt::format("'{}' also writes '{}', as output {} ('{}') does", outputs[i].path, *clash, earlier,
                            other.path));
      break;
    }
  }
}

std::vector<std::string> read_files(const Recipe& recipe) {
  std::vector<std::string> files;
  const auto add = [&](const std::string& name) {
    const fs::path path(name);
    files.push_back(path.is_absolute() ? name : (fs::path(recipe.folder) / path).string());
  };
  for (const Step& step : recipe.steps) {
    for (const auto& [port, source] : step.in) {
      if (source.from_file()) add(source.file);
    }
    for_each_file(step.op->params, step.params, add);
  }
  for (size_t i = 0, named = files.size(); i < named; ++i) {
    for (const std::string& companion : io::companions_of(files[i])) files.push_back(companion);
  }
  if (std::error_code ignored; fs::is_regular_file(recipe.file, ignored)) files.push_back(recipe.file);
  return files;
}

void check_nothing_overwritten(const Recipe& recipe, const std::string& out_folder) {
  std::vector<std::string> read;
  for (const std::string& file : read_files(recipe)) read.push_back(canonical_name(file));
  const std::string self = canonical_name(recipe.file);
  for (const Output& output : recipe.outputs) {
    for (const std::string& file : output.files) {
      const fs::path written = fs::path(out_folder) / file;
      const std::string target = (fs::path(canonical_name(written.parent_path())) / written.filename()).string();
      for (const std::string& input : read) {
        if (!may_be_same_file(target, input)) continue;
        throw InvalidArgument(fmt::format("output '{}'", output.path),
                              fmt::format("would be written over {} {}; choose another name or --out folder",
                                          input == self ? "the recipe" : "the input", input));
      }
    }
  }
}

}  // namespace seamount::recipe
