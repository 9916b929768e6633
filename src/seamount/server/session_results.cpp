// Results of a session on their way to the windows.
#include <algorithm>
#include <array>

#include "seamount/server/session.h"
#include "seamount/server/value_bytes.h"

namespace seamount::server {
namespace {

using recipe::EngineState;
using recipe::Quality;
using recipe::Source;

/// Results of a source that can still be fetched: the one that is shown and those just before it.
constexpr size_t kKept = 4;

constexpr std::array<const char*, 8> kStandings = {"fresh",  "stale",   "queued",     "running",
                                                   "failed", "blocked", "incomplete", "bypassed"};

OrderedJson state_json(const EngineState& state, uint64_t first_revision) {
  OrderedJson steps = OrderedJson::array();
  for (const recipe::StepState& step : state.steps)
    steps.push_back({{"id", step.id},
                     {"op", step.op},
                     {"standing", kStandings[static_cast<size_t>(step.standing)]},
                     {"fraction", step.fraction},
                     {"seconds", step.seconds},
                     {"cached", step.cached},
                     {"message", step.message},
                     {"notes", step.notes}});
  return {{"event", "state"},           {"revision", first_revision + state.revision},
          {"settled", state.settled},   {"coarse", state.coarse},
          {"fraction", state.fraction}, {"steps", std::move(steps)}};
}

OrderedJson frame_json(const GridFrame& frame) {
  return {{"columns", frame.width}, {"rows", frame.height},   {"cell_m", frame.cell_m},
          {"west", frame.west_m},   {"north", frame.north_m}, {"crs", frame.crs}};
}

/// "step.port", or "step" for its first output; nothing for a step or port that the document does not have.
std::optional<Source> source_of(const std::string& name, const recipe::Document& document,
                                const recipe::Registry& registry) {
  const size_t dot = name.rfind('.');
  const std::string id = name.substr(0, dot);
  for (const OrderedJson& step : document.json().at("steps")) {
    if (step.at("id") != id) continue;
    const recipe::Operator* op = registry.find_operator(step.at("op").get<std::string>());
    if (op == nullptr || op->out.empty()) return std::nullopt;
    return Source{id, dot == std::string::npos ? op->out.front().name : name.substr(dot + 1), ""};
  }
  return std::nullopt;
}

}  // namespace

void Session::want(const std::string& window, const std::vector<std::string>& sources, Quality quality) {
  {
    const std::lock_guard lock(results_);
    wishes_[window] = {sources, quality};
    const std::vector<std::string> present = hub_.windows();
    std::erase_if(wishes_, [&](const auto& wish) {
      return wish.first != window && std::find(present.begin(), present.end(), wish.first) == present.end();
    });
  }
  pass_wishes_on();
}

void Session::pass_wishes_on() {
  std::set<std::string> names;
  bool coarse = false, full = false;
  {
    const std::lock_guard lock(results_);
    for (const auto& [window, wish] : wishes_) {
      names.insert(wish.sources.begin(), wish.sources.end());
      coarse = coarse || wish.quality != Quality::full;
      full = full || wish.quality != Quality::coarse;
    }
    std::erase_if(keys_, [&](const auto& item) {
      if (names.contains(item.first)) return false;
      for (const std::string& key : item.second) let_go(key);
      hub_.withdraw_state("value " + item.first, one_line({{"event", "gone"}, {"source", item.first}}));
      return true;
    });
    wanted_ = {names.begin(), names.end()};
  }
  const Quality quality = coarse && full ? Quality::coarse_then_full : full ? Quality::full : Quality::coarse;
  std::vector<Source> sources = wanted_sources();
  {
    const std::lock_guard lock(results_);
    if (sources == passed_on_ && quality == quality_) return;  // a gesture that goes on is not disturbed
    passed_on_ = sources;
    quality_ = quality;
  }
  engine_->want(std::move(sources), quality);
  look_for_results();
}

std::vector<Source> Session::wanted_sources() const {
  std::vector<std::string> names;
  {
    const std::lock_guard lock(results_);
    names = wanted_;
  }
  std::vector<Source> sources;
  engine_->look([&](const recipe::Document& document) {
    for (const std::string& name : names) {
      if (const auto source = source_of(name, document, *options_.registry)) sources.push_back(*source);
    }
  });
  return sources;
}

std::optional<recipe::Value> Session::value(const std::string& key) const {
  const std::lock_guard lock(results_);
  const auto found = values_.find(key);
  return found == values_.end() ? std::nullopt : std::optional(found->second.first);
}

void Session::let_go(const std::string& key) {
  const auto found = values_.find(key);
  if (found != values_.end() && --found->second.second == 0) values_.erase(found);
}

void Session::look_for_results() {
  const std::lock_guard lock(results_);
  look_ = true;
  wake_.notify_all();
}

void Session::publish_results() {
  std::unique_lock lock(results_);
  while (true) {
    wake_.wait(lock, [&] { return look_ || stopping_; });
    if (stopping_) return;
    look_ = false;
    const std::vector<std::string> names = wanted_;
    lock.unlock();
    for (const std::string& name : names) {
      std::optional<Source> source;
      engine_->look([&](const recipe::Document& document) { source = source_of(name, document, *options_.registry); });
      if (!source) continue;
      if (const auto finished = engine_->value(*source)) publish_value(name, *finished);
    }
    hub_.publish_state("state", one_line(state_json(engine_->state(), first_revision_)));
    lock.lock();
  }
}

void Session::publish_value(const std::string& name, const recipe::Finished& finished) {
  const std::string key = finished.key.hex();
  {
    const std::lock_guard lock(results_);
    if (std::find(wanted_.begin(), wanted_.end(), name) == wanted_.end()) return;
    std::deque<std::string>& keys = keys_[name];
    const auto told = told_.find(name);
    if (!keys.empty() && keys.back() == key && told != told_.end() && told->second == finished.revision) return;
    told_[name] = finished.revision;
    if (keys.empty() || keys.back() != key) {
      keys.push_back(key);
      ++values_.try_emplace(key, finished.value, 0).first->second.second;
      if (keys.size() > kKept) {
        let_go(keys.front());
        keys.pop_front();
      }
    }
  }
  OrderedJson event = {{"event", "value"},
                       {"source", name},
                       {"key", key},
                       {"kind", finished.value.kind().name},
                       {"revision", first_revision_ + finished.revision},
                       {"coarse", finished.coarse}};
  if (const GridFrame* frame = finished.value.frame()) event["frame"] = frame_json(*frame);
  if (const auto range = raster_range(finished.value)) {
    event["min"] = range->first;
    event["max"] = range->second;
  }
  hub_.publish_state("value " + name, one_line(event));
}

}  // namespace seamount::server
