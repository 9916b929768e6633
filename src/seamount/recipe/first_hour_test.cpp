// The five tasks of docs/guide/first_hour.md: commands and references that its table states, and at most half of what
// the same takes where nothing is left out.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "seamount/recipe/recipe.h"

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;

struct Effort {
  int commands = 0, references = 0;
  bool operator==(const Effort&) const = default;
};

struct Task {
  std::string recipe;
  Effort now, before;
};

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

fs::path source(const std::string& path) { return fs::path(SEAMOUNT_SOURCE_DIR) / path; }

/// Rows "| ... `recipes/guide/NAME.json` | commands | references | commands before | references before |".
std::vector<Task> tasks() {
  std::vector<Task> out;
  std::istringstream page(text_of(source("docs/guide/first_hour.md")));
  for (std::string line; std::getline(page, line);) {
    const size_t name = line.find("`recipes/guide/");
    if (line.empty() || line[0] != '|' || name == std::string::npos) continue;
    Task task;
    task.recipe = line.substr(name + 1, line.find('`', name + 1) - name - 1);
    std::istringstream cells(line.substr(line.find('|', name) + 1));
    char bar = 0;
    cells >> task.now.commands >> bar >> task.now.references >> bar >> task.before.commands >> bar >>
        task.before.references;
    out.push_back(task);
  }
  return out;
}

/// Sources that a recipe's text names.
int written(const Json& recipe) {
  int count = 0;
  for (const Json& step : recipe.at("steps")) {
    const Json in = step.value("in", Json::object());
    count += in.is_string() ? 1 : static_cast<int>(in.size());
  }
  for (const Json& output : recipe.at("outputs")) {
    for (const char* key : {"from", "labels", "rivers", "lake"})
      count += output.contains(key) && (output.at(key).is_string() || output.at(key).contains("file")) ? 1 : 0;
  }
  return count;
}

/// Each step is a command, as is each output; each connection of them a reference.
Effort spelt_out(const Recipe& recipe) {
  Effort effort;
  for (const Step& step : recipe.steps) {
    ++effort.commands;
    effort.references += static_cast<int>(step.in.size());
  }
  for (const Output& output : recipe.outputs) {
    const bool drawn = output.from.step.find(output.path) != std::string::npos;  // by a step that is counted already
    effort.commands += drawn ? 0 : 1;
    effort.references += drawn ? 0 : 1;
  }
  return effort;
}

/// Commands of the section of the page that is about the recipe.
int commands(const std::string& page, const std::string& recipe) {
  const std::string stem = fs::path(recipe).stem().string();
  int count = 0;
  size_t begin = 0;
  while ((begin = page.find("```sh\n", begin)) != std::string::npos) {
    const size_t end = page.find("```\n", begin + 6);
    const std::string block = page.substr(begin + 6, end - begin - 6);
    begin = end + 4;
    if (block.find(stem) == std::string::npos) continue;
    std::istringstream lines(block);
    for (std::string line; std::getline(lines, line);) count += line.rfind("./run ", 0) == 0 ? 1 : 0;
  }
  return count;
}

TEST(FirstHour, TakesAtMostHalfOfTheCommandsAndReferences) {
  const std::string page = text_of(source("docs/guide/first_hour.md"));
  const std::vector<Task> all = tasks();
  ASSERT_EQ(all.size(), 5u);
  for (const Task& task : all) {
    const std::string text = text_of(source(task.recipe));
    const Effort now{commands(page, task.recipe), written(Json::parse(text))};
    const Effort before = spelt_out(parse_recipe(text, task.recipe, source("recipes/guide").string()));
    EXPECT_EQ(now, task.now) << task.recipe << ": " << now.commands << " " << now.references;
    EXPECT_EQ(before, task.before) << task.recipe << ": " << before.commands << " " << before.references;
    EXPECT_GT(now.commands, 0) << task.recipe;
    EXPECT_LE(2 * now.commands, before.commands) << task.recipe;
    EXPECT_LE(2 * now.references, before.references) << task.recipe;
  }
}

}  // namespace
}  // namespace seamount::recipe
