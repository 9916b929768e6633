#include "seamount/recipe/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "seamount/base/version.h"
#include "seamount/io/find_model.h"

namespace seamount::recipe {
namespace {

void hash_domain(const Recipe& recipe, Hasher& hasher) {
  const GridFrame& domain = recipe.domain;
  hasher.text(fmt::format("{} {} {} {} {} {} {}", domain.width, domain.height, domain.cell_m, domain.west_m,
                          domain.north_m, recipe.domain_stated, domain.crs));
}

Digest key_of(const Plan& plan, const Step& step, PlannedStep& planned, FileSnapshots& files) {
  const Recipe& recipe = *plan.recipe;
  const auto file_hex = [&](const std::string& name) {
    planned.files.push_back(files.of(resolve_file(recipe, name)));
    return planned.files.back()->digest().hex();
  };
  Hasher hasher;
  hasher.text(kVersion).text(step.op->name).number(static_cast<uint64_t>(step.op->revision)).text(step.params.dump());
  if (step.op->stochastic) hasher.number(step.seed.value);
  hash_domain(recipe, hasher);
  for_each_file(step.op->params, step.params, [&](const std::string& name) { hasher.text(file_hex(name)); });
  for_each_model(step.op->params, step.params,
                 [&](const std::string& word) { hasher.text(file_hex(io::find_model(word))); });
  for (const auto& [port, source] : step.in) {
    hasher.text(port);
    if (source.from_file()) {
      hasher.text(file_hex(source.file));
    } else {
      hasher.text(plan.steps[plan.index_of.at(source.step)].key.hex()).text(source.port);
    }
  }
  return hasher.digest();
}

/// The key of a step, or why it has none.
void find_key(const Plan& plan, size_t index, PlannedStep& planned, FileSnapshots& files) {
  const Step& step = plan.recipe->steps[index];
  planned.defect_of = index;
  try {
    if (!step.incomplete.empty()) throw Error(fmt::format("step '{}': {}", step.id, step.incomplete));
    for (const size_t from : planned.reads) {
      if (!plan.steps[from].defect) continue;
      planned.defect = plan.steps[from].defect;
      planned.defect_of = plan.steps[from].defect_of;
      return;
    }
    planned.key = key_of(plan, step, planned, files);
  } catch (...) {
    planned.defect = std::current_exception();
  }
}

void need(Plan& plan, size_t index) {
  PlannedStep& planned = plan.steps[index];
  if (planned.needed) return;
  planned.needed = true;
  if (planned.defect) return;  // nothing can come of what it reads
  for (const auto& [port, source] : plan.recipe->steps[index].in) {
    if (source.from_file()) continue;
    const size_t from = plan.index_of.at(source.step);
    plan.steps[from].ports.insert(source.port);
    need(plan, from);
  }
}

}  // namespace

std::string resolve_file(const Recipe& recipe, const std::string& name) {
  const std::filesystem::path path(name);
  return path.is_absolute() ? name : (std::filesystem::path(recipe.folder) / path).string();
}

Plan make_plan(std::shared_ptr<const Recipe> recipe, const std::vector<Source>& wanted, FileSnapshots& files) {
  Plan plan;
  plan.recipe = std::move(recipe);
  for (size_t i = 0; i < plan.recipe->steps.size(); ++i) {
    const Step& step = plan.recipe->steps[i];
    plan.index_of[step.id] = i;
    PlannedStep planned;
    for (const auto& [port, source] : step.in) {
      if (!source.from_file()) planned.reads.push_back(plan.index_of.at(source.step));
    }
    std::sort(planned.reads.begin(), planned.reads.end());
    planned.reads.erase(std::unique(planned.reads.begin(), planned.reads.end()), planned.reads.end());
    find_key(plan, i, planned, files);
    plan.steps.push_back(std::move(planned));
  }
  for (const Source& source : wanted) {
    const size_t target = plan.index_of.at(source.step);
    if (!source.port.empty()) plan.steps[target].ports.insert(source.port);
    plan.targets.push_back(target);
  }
  for (const size_t target : plan.targets) need(plan, target);
  return plan;
}

}  // namespace seamount::recipe
