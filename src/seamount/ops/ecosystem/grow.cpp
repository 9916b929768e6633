#include "seamount/ops/ecosystem/grow.h"

#include <algorithm>
#include <cmath>

#include "seamount/ops/ecosystem/begin_scene.h"
#include "seamount/ops/ecosystem/births.h"
#include "seamount/ops/ecosystem/edits.h"
#include "seamount/ops/ecosystem/events.h"
#include "seamount/ops/ecosystem/fit.h"
#include "seamount/ops/ecosystem/fitness.h"
#include "seamount/ops/ecosystem/growth_notes.h"

namespace seamount::ecosystem {
namespace {

class Growth {
 public:
  Growth(const GrowInputs& inputs, const GrowParams& params, Scene scene, int window, const RunContext& run)
      : params_(params),
        focus_(inputs.focus),
        site_{inputs.ground, inputs.current},
        scene_(std::move(scene)),
        window_(window),
        rules_(compile(scene_.catalogue)),
        histories_(scene_.catalogue.classes.size()),
        run_(run) {
    find_targets();
  }

  Grown grow() {
    environment_ = make(scene_.iteration);
    const int last = clock() + params_.iterations;
    while (clock() < last && !targets_reached()) {
      run_.check_cancelled();
      iterate();
      run_.report(1.0 - static_cast<double>(last - clock()) / params_.iterations);
    }
    say_what_became(scene_, histories_, wanted_, window_, run_);
    for (const SceneEdit& edit : params_.edits) {
      const int after = std::visit([](const auto& e) { return e.after; }, edit);
      if (after < clock() && after >= last - params_.iterations) continue;
      run_.say("an edit after iteration " + std::to_string(after) + " was not done: growth was at iterations " +
               std::to_string(last - params_.iterations) + " to " + std::to_string(clock()));
      break;
    }
    return finish();
  }

 private:
  Environment make(double time) {
    return make_environment(scene_, rules_, site_, window_, time, run_, std::move(environment_));
  }

  /// Iterations done in the frame that grows.
  int& clock() { return window_ == 0 ? scene_.iteration : scene_.windows[static_cast<size_t>(window_ - 1)].iteration; }

  void iterate() {
    const bool edited = apply_edits(params_.edits, scene_, window_, run_);
    const int before = scene_.iteration;
    ++clock();
    const int time = scene_.iteration;  // stands still while a window grows
    if (edited || changes_between(scene_.timeline, before, time)) environment_ = make(time);
    const bool born = give_birth();
    const bool moved = fit_again(scene_, rules_, environment_, window_, run_);
    if (born || moved) environment_ = make(time);
    while (let_die()) {
    }
  }

  void find_targets() {
    wanted_.assign(scene_.catalogue.classes.size(), -1);
    for (size_t i = 0; i < params_.targets.size(); ++i)
      wanted_[class_named(scene_.catalogue, params_.targets[i].class_name,
                          "targets[" + std::to_string(i) + "].class")] = params_.targets[i].count;
    chosen_.assign(wanted_.size(), params_.classes.empty());
    for (size_t i = 0; i < params_.classes.size(); ++i)
      chosen_[class_named(scene_.catalogue, params_.classes[i], "classes[" + std::to_string(i) + "]")] = true;
  }

  std::vector<int> count_living() const {
    std::vector<int> living(scene_.catalogue.classes.size(), 0);
    for (const SceneObject& object : scene_.objects)
      if (object.window == window_) ++living[static_cast<size_t>(object.of_class)];
    return living;
  }

  bool targets_reached() const {
    if (params_.targets.empty()) return false;
    const std::vector<int> living = count_living();
    for (size_t c = 0; c < living.size(); ++c)
      if (wanted_[c] >= 0 && living[c] < wanted_[c]) return false;
    return true;
  }

  int& owed(int of_class) {
    for (Owed& owed : scene_.owed)
      if (owed.of_class == of_class && owed.window == window_) return owed.count;
    scene_.owed.push_back({of_class, window_, 0});
    return scene_.owed.back().count;
  }

  bool give_birth() {
    const std::vector<int> living = count_living();
    std::vector<SceneObject> newborn;
    for (size_t c = 0; c < living.size(); ++c) {
      const ObjectClass& of = scene_.catalogue.classes[c];
      const Placement& placement = of.placement;
      if (!chosen_[c]) continue;
      const double cell_m = environment_.frame.cell_m;
      if (cell_m < placement.finest_cell_m || cell_m > placement.coarsest_cell_m) {
        histories_[c].wrong_cell = true;
        continue;
      }
      const auto number = static_cast<int>(c);
      const int again = placement.reinsert ? owed(number) : 0;
      const int room = (wanted_[c] >= 0 ? std::min(wanted_[c], placement.most) : placement.most) - living[c];
      const int most = std::min(placement.per_iteration + again, room);
      if (most <= 0) continue;
      const std::vector<Vec2> places =
          birth_places({scene_, rules_, environment_, number, window_, most, focus_}, histories_[c].prospects, run_);
      const int grown = add_newborn(number, places, newborn);
      if (placement.reinsert) owed(number) = std::max(0, again - grown);
    }
    for (SceneObject& object : newborn) object.id = scene_.next_id++;
    scene_.objects.insert(scene_.objects.end(), newborn.begin(), newborn.end());
    return !newborn.empty();
  }

  /// How many of the places a skeleton grew from.
  int add_newborn(int of_class, const std::vector<Vec2>& places, std::vector<SceneObject>& newborn) {
    if (places.empty()) return 0;
    const ObjectClass& of = scene_.catalogue.classes[static_cast<size_t>(of_class)];
    const Seed seed = Seed{scene_.seed}
                          .derive("sizes", static_cast<uint64_t>(clock()))
                          .derive(of.name, static_cast<uint64_t>(window_));
    std::vector<double> sizes;
    for (size_t i = 0; i < places.size(); ++i)
      sizes.push_back(std::exp(of.shape.variation * Rng(seed.derive("size", i)).normal()));
    std::vector<Skeleton> skeletons = first_skeletons(scene_, rules_, environment_, of_class, places, sizes, run_);
    History& history = histories_[static_cast<size_t>(of_class)];
    int grown = 0;
    for (size_t i = 0; i < skeletons.size(); ++i) {
      if (skeletons[i].points.empty()) {
        ++history.unfitted;
        continue;
      }
      ++grown;
      newborn.push_back({.of_class = of_class,
                         .skeleton = std::move(skeletons[i]),
                         .size = sizes[i],
                         .born = clock(),
                         .window = window_});
    }
    history.born += grown;
    return grown;
  }

  /// Asks every object; takes away those that cannot stay. Returns whether the others must be asked again.
  bool let_die() {
    std::vector<size_t> active;
    for (size_t i = 0; i < scene_.objects.size(); ++i)
      if (scene_.objects[i].window == window_) active.push_back(i);
    const std::vector<double> fitness = fitness_of(scene_, rules_, environment_, active, run_);
    std::vector<bool> dies(scene_.objects.size(), false);
    bool changes = false, any = false;
    for (size_t k = 0; k < active.size(); ++k) {
      SceneObject& object = scene_.objects[active[k]];
      const auto c = static_cast<size_t>(object.of_class);
      object.fitness = fitness[k];
      if (object.keep || fitness[k] >= scene_.catalogue.classes[c].death) continue;
      dies[active[k]] = any = true;
      changes = changes || changes_surroundings(scene_.catalogue.classes[c]);
      ++histories_[c].died;
      // One that dies as it is born was an attempt: to owe it would try more and more of them.
      if (scene_.catalogue.classes[c].placement.reinsert && object.born < clock()) ++owed(object.of_class);
    }
    if (!any) return false;
    size_t i = 0;
    std::erase_if(scene_.objects, [&](const SceneObject&) { return dies[i++]; });
    if (changes) {
      environment_ = make(scene_.iteration);
    } else {
      index_objects(scene_, rules_, window_, environment_, run_);
    }
    return true;
  }

  Grown finish() {
    HeightField terrain = std::move(environment_.height);
    const auto level = static_cast<float>(environment_.water_level_m);
    for (float& z : terrain.cells()) z += level;
    return {std::move(scene_), std::move(terrain), std::move(environment_.current)};
  }

  const GrowParams& params_;
  const Mask* focus_;
  Site site_;
  Scene scene_;
  int window_;
  Rules rules_;
  std::vector<History> histories_;
  std::vector<int> wanted_;   ///< of each class; -1: any number
  std::vector<bool> chosen_;  ///< may it be born?
  Environment environment_;
  const RunContext& run_;
};

}  // namespace

Grown grow(const GrowInputs& inputs, const GrowParams& params, Seed seed, const RunContext& run) {
  check_params(params);
  Scene scene = begin_scene(inputs, params, seed, run);
  const int window = open_window(params.window, scene);
  return Growth(inputs, params, std::move(scene), window, run).grow();
}

}  // namespace seamount::ecosystem
