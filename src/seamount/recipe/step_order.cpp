#include "seamount/recipe/step_order.h"

#include <algorithm>
#include <map>
#include <set>

namespace seamount::recipe {
namespace {

std::vector<std::string> find_cycle(const std::vector<Step>& waiting) {
  std::map<std::string, const Step*> by_id;
  for (const Step& step : waiting) by_id[step.id] = &step;
  std::vector<std::string> path;
  std::string id = waiting.front().id;
  while (std::find(path.begin(), path.end(), id) == path.end()) {
    path.push_back(id);
    for (const auto& [port, source] : by_id[id]->in) {
      if (by_id.contains(source.step)) id = source.step;
    }
  }
  path.erase(path.begin(), std::find(path.begin(), path.end(), id));
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

StepOrder order_of(std::vector<Step> waiting) {
  StepOrder order;
  std::set<std::string> placed;
  const auto ready = [&](const Step& step) {
    return std::all_of(step.in.begin(), step.in.end(), [&](const auto& input) {
      return input.second.from_file() || placed.contains(input.second.step);
    });
  };
  while (!waiting.empty()) {
    const auto next = std::find_if(waiting.begin(), waiting.end(), ready);
    if (next == waiting.end()) break;
    placed.insert(next->id);
    order.steps.push_back(std::move(*next));
    waiting.erase(next);
  }
  if (!waiting.empty()) order.cycle = find_cycle(waiting);
  return order;
}

}  // namespace seamount::recipe
