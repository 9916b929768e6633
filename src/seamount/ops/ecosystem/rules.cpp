#include "seamount/ops/ecosystem/rules.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string_view>

#include "seamount/base/text.h"
#include "seamount/geom/scalar/expression_code.h"
#include "seamount/ops/ecosystem/words.h"

namespace seamount::ecosystem {
namespace {

constexpr size_t kMostClasses = 10000;

bool is_name(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !name.empty() && name.size() <= 64 && letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

/// Words that a material may not be called.
bool is_taken(const std::string& name) {
  const auto is = [&](std::string_view word) { return word == name; };
  return name == "pi" || std::any_of(kPlaceWords.begin(), kPlaceWords.end(), is) ||
         std::any_of(kClassWords.begin(), kClassWords.end(), is) || name == kNoiseWord ||
         std::any_of(geom::expression::kFunctions.begin(), geom::expression::kFunctions.end(),
                     [&](const geom::expression::Function& function) { return is(function.name); });
}

/// Reads a catalogue and gathers what is wrong with it.
class Reader {
 public:
  explicit Reader(const Catalogue& catalogue) : catalogue_(catalogue), words_(vocabulary_of(catalogue)) {}

  Rules read() {
    if (catalogue_.classes.size() > kMostClasses)
      fail("/classes", std::to_string(catalogue_.classes.size()) + " classes; at most 10000 are read");
    read_materials();
    read_names(catalogue_.classes, "/classes");
    for (size_t i = 0; i < std::min(catalogue_.classes.size(), kMostClasses); ++i) {
      rules_.classes.push_back(read_class(catalogue_.classes[i], "/classes/" + std::to_string(i)));
    }
    refuse_rings_of_classes();
    return std::move(rules_);
  }

  std::vector<CatalogueDefect> defects;

 private:
  void fail(const std::string& pointer, const std::string& message) { defects.push_back({pointer, message}); }

  template <class T>
  void read_names(const std::vector<T>& items, const std::string& pointer) {
    std::vector<std::string_view> seen;
    for (size_t i = 0; i < items.size(); ++i) {
      const std::string place = pointer + "/" + std::to_string(i) + "/name";
      const std::string& name = items[i].name;
      if (!is_name(name)) {
        fail(place, "'" + name + "' is no name: letters, digits and _, not a digit first, at most 64");
      } else if (std::is_same_v<T, Material> && is_taken(name)) {
        fail(place, "'" + name + "' is a word of expressions already");
      }
      seen.emplace_back(name);
    }
    std::sort(seen.begin(), seen.end());
    const auto twice = std::adjacent_find(seen.begin(), seen.end());
    if (twice != seen.end()) fail(pointer, "'" + std::string(*twice) + "' is there twice");
  }

  template <class T>
  std::optional<int> index_of(const std::vector<T>& items, const std::string& name, const std::string& what,
                              const std::string& place) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const T& item) { return item.name == name; });
    if (found != items.end()) return static_cast<int>(found - items.begin());
    std::vector<std::string> names(items.size());
    std::transform(items.begin(), items.end(), names.begin(), [](const T& item) { return item.name; });
    fail(place, "unknown " + what + " '" + name + "'" + suggestion(name, names));
    return std::nullopt;
  }

  void read_materials() {
    read_names(catalogue_.materials, "/materials");
    for (size_t i = 0; i < catalogue_.transformations.size(); ++i) {
      const Transformation& turn = catalogue_.transformations[i];
      const std::string place = "/transformations/" + std::to_string(i);
      const auto from = index_of(catalogue_.materials, turn.from, "material", place + "/from");
      const auto to = index_of(catalogue_.materials, turn.to, "material", place + "/to");
      rules_.turns.emplace_back(from.value_or(-1), to.value_or(-1));
    }
    order_materials();
  }

  /// Those that nothing still to come turns into, one after another.
  void order_materials() {
    std::vector<bool> done(catalogue_.materials.size(), false);
    while (rules_.material_order.size() < done.size()) {
      const size_t before = rules_.material_order.size();
      for (size_t m = 0; m < done.size(); ++m) {
        const auto waits = [&](const std::pair<int, int>& turn) {
          return turn.second == static_cast<int>(m) && turn.first >= 0 && !done[static_cast<size_t>(turn.first)];
        };
        if (done[m] || std::any_of(rules_.turns.begin(), rules_.turns.end(), waits)) continue;
        done[m] = true;
        rules_.material_order.push_back(static_cast<int>(m));
      }
      if (rules_.material_order.size() > before) continue;
      const auto left = std::find(done.begin(), done.end(), false) - done.begin();
      return fail("/transformations", "'" + catalogue_.materials[static_cast<size_t>(left)].name +
                                          "' turns into itself by way of others: transformations may not form a ring");
    }
  }

  ClassRules read_class(const ObjectClass& of, const std::string& place) {
    ClassRules rules;
    rules.fitness = read_expression(of.fitness, place + "/fitness");
    rules.fitting = of.fitting.empty() ? rules.fitness : read_expression(of.fitting, place + "/fitting");
    rules.within = read_classes(of.placement.within, place + "/placement/within");
    rules.outside = read_classes(of.placement.outside, place + "/placement/outside");
    rules.deposits = read_exchanges(of.deposits, place + "/deposits");
    rules.absorbs = read_exchanges(of.absorbs, place + "/absorbs");
    refuse_what_never_lives(of, rules, place);
    refuse_wrong_shapes(of, place);
    return rules;
  }

  geom::Expression read_expression(const std::string& text, const std::string& place) {
    try {
      return geom::Expression::parse(text, words_);
    } catch (const geom::ExpressionError& error) {
      fail(place, "column " + std::to_string(error.column()) + ": " + error.what());
      return {};
    }
  }

  std::vector<int> read_classes(const std::vector<std::string>& names, const std::string& place) {
    std::vector<int> indices;
    for (size_t i = 0; i < names.size(); ++i) {
      const auto index = index_of(catalogue_.classes, names[i], "class", place + "/" + std::to_string(i));
      if (!index) continue;
      if (catalogue_.classes[static_cast<size_t>(*index)].skeleton != SkeletonKind::region) {
        fail(place + "/" + std::to_string(i), "'" + names[i] + "' has no inside: only regions have");
      }
      indices.push_back(*index);
    }
    return indices;
  }

  std::vector<int> read_exchanges(const std::vector<Exchange>& exchanges, const std::string& place) {
    std::vector<int> indices;
    for (size_t i = 0; i < exchanges.size(); ++i) {
      indices.push_back(index_of(catalogue_.materials, exchanges[i].material, "material",
                                 place + "/" + std::to_string(i) + "/material")
                            .value_or(-1));
    }
    return indices;
  }

  void refuse_what_never_lives(const ObjectClass& of, const ClassRules& rules, const std::string& place) {
    if (of.death > of.birth) {
      fail(place + "/death", format_number(of.death) + " is above the threshold of birth, " + format_number(of.birth) +
                                 ": it would die as it is born");
    }
    if (of.placement.finest_cell_m > of.placement.coarsest_cell_m)
      fail(place + "/placement/finest_cell_m", "is coarser than coarsest_cell_m: it would be placed on no grid");
    for (const int within : rules.within) {
      if (std::find(rules.outside.begin(), rules.outside.end(), within) == rules.outside.end()) continue;
      fail(place + "/placement/outside", "'" + catalogue_.classes[static_cast<size_t>(within)].name +
                                             "' is in 'within' as well: it could be nowhere");
    }
  }

  void refuse_wrong_shapes(const ObjectClass& of, const std::string& place) {
    const auto refuse = [&](HeightShape shape, bool fits, const std::string& needs) {
      if (of.height.shape == shape && !fits) fail(place + "/height/shape", "is for " + needs);
    };
    refuse(HeightShape::ridge, of.skeleton != SkeletonKind::point, "curves and outlines of regions");
    refuse(HeightShape::cylinder, of.skeleton != SkeletonKind::point, "curves and outlines of regions");
    refuse(HeightShape::island, of.skeleton == SkeletonKind::region, "regions");
    for (size_t i = 0; i < of.currents.size(); ++i) {
      const CurrentEffect& effect = of.currents[i];
      const std::string here = place + "/currents/" + std::to_string(i) + "/shape";
      const bool region = of.skeleton == SkeletonKind::region;
      const bool for_regions = effect.shape == CurrentShape::obstacle || effect.shape == CurrentShape::waves;
      if (for_regions != region) fail(here, region ? "regions have obstacle and waves" : "is for regions");
      if (effect.shape == CurrentShape::twist && of.skeleton == SkeletonKind::curve) fail(here, "twist is for points");
    }
  }

  /// A class that lives within others lives only if one of them does not, by whatever way, depend on it.
  void refuse_rings_of_classes() {
    std::vector<bool> lives(rules_.classes.size(), false);
    const auto can_live = [&](const ClassRules& rules) {
      return rules.within.empty() || std::any_of(rules.within.begin(), rules.within.end(),
                                                 [&](int c) { return lives[static_cast<size_t>(c)]; });
    };
    bool changed = true;
    while (changed) {
      changed = false;
      for (size_t c = 0; c < lives.size(); ++c) {
        if (lives[c] || !can_live(rules_.classes[c])) continue;
        lives[c] = changed = true;
      }
    }
    for (size_t c = 0; c < lives.size(); ++c) {
      if (!lives[c])
        fail("/classes/" + std::to_string(c) + "/placement/within", "it lives only within what lives only within it");
    }
  }

  const Catalogue& catalogue_;
  geom::Vocabulary words_;
  Rules rules_;
};

}  // namespace

geom::Vocabulary vocabulary_of(const Catalogue& catalogue) {
  geom::Vocabulary words;
  words.variables.assign(kPlaceWords.begin(), kPlaceWords.end());
  for (const Material& material : catalogue.materials) words.variables.push_back(material.name);
  words.of_class.assign(kClassWords.begin(), kClassWords.end());
  for (const ObjectClass& of : catalogue.classes) words.classes.push_back(of.name);
  words.of_number = {std::string(kNoiseWord)};
  return words;
}

std::vector<CatalogueDefect> find_defects(const Catalogue& catalogue) {
  Reader reader(catalogue);
  reader.read();
  return std::move(reader.defects);
}

size_t class_named(const Catalogue& catalogue, const std::string& name, const std::string& place) {
  std::vector<std::string> names;
  for (size_t c = 0; c < catalogue.classes.size(); ++c) {
    if (catalogue.classes[c].name == name) return c;
    names.push_back(catalogue.classes[c].name);
  }
  throw InvalidArgument(place, "unknown class '" + name + "'" + suggestion(name, names));
}

void mark_screened(const Catalogue& catalogue, const geom::Expression& expression, Rules& rules) {
  rules.screened.resize(catalogue.classes.size(), false);
  for (const geom::Term& term : expression.terms()) {
    if (term.word != kClassWords[static_cast<size_t>(ClassWord::screened)]) continue;
    for (size_t c = 0; c < catalogue.classes.size(); ++c)
      if (catalogue.classes[c].name == term.of_class) rules.screened[c] = true;
  }
}

Rules compile(const Catalogue& catalogue) {
  Reader reader(catalogue);
  Rules rules = reader.read();
  if (!reader.defects.empty())
    throw InvalidArgument("catalogue", reader.defects[0].pointer + ": " + reader.defects[0].message);
  rules.screened.resize(catalogue.classes.size(), false);
  for (const ClassRules& of : rules.classes) {
    mark_screened(catalogue, of.fitness, rules);
    mark_screened(catalogue, of.fitting, rules);
  }
  return rules;
}

}  // namespace seamount::ecosystem
