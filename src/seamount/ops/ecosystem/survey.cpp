#include "seamount/ops/ecosystem/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/ecosystem/words.h"

namespace seamount::ecosystem {
namespace {

constexpr int64_t kBlock = 1024;

/// Where a place lies between four cell centres; level beyond the outermost ones.
struct Reading {
  Reading(const GridFrame& frame, Vec2 at) {
    const double column = std::clamp(frame.column(at.x), 0.0, frame.width - 1.0);
    const double row = std::clamp(frame.row(at.y), 0.0, frame.height - 1.0);
    const int x = std::min(static_cast<int>(column), std::max(0, frame.width - 2));
    const int y = std::min(static_cast<int>(row), std::max(0, frame.height - 2));
    first = static_cast<size_t>(y) * static_cast<size_t>(frame.width) + static_cast<size_t>(x);
    right = x + 1 < frame.width ? 1 : 0;
    below = y + 1 < frame.height ? static_cast<size_t>(frame.width) : 0;
    u = column - x;
    v = row - y;
  }

  double of(const ScalarField& field) const {
    const float* at = field.cells().data() + first;
    return (1 - v) * ((1 - u) * at[0] + u * at[right]) + v * ((1 - u) * at[below] + u * at[below + right]);
  }

  size_t first, right, below;
  double u, v;
};

bool contains(const GridFrame& frame, Vec2 at) {
  return at.x >= frame.west_m && at.x <= frame.east_m() && at.y >= frame.south_m() && at.y <= frame.north_m;
}

Vec2 gradient(const ScalarField& height, Vec2 at) {
  const double reach = height.cell_m();
  const GridFrame& frame = height.frame();
  const auto rise = [&](Vec2 step) {
    Vec2 from = at - step, to = at + step;
    from = {std::clamp(from.x, frame.x(0), frame.x(frame.width - 1)),
            std::clamp(from.y, frame.y(frame.height - 1), frame.y(0))};
    to = {std::clamp(to.x, frame.x(0), frame.x(frame.width - 1)),
          std::clamp(to.y, frame.y(frame.height - 1), frame.y(0))};
    const double run = step.x != 0.0 ? to.x - from.x : to.y - from.y;
    return run > 0.0 ? (Reading(frame, to).of(height) - Reading(frame, from).of(height)) / run : 0.0;
  };
  return {rise({reach, 0.0}), rise({0.0, reach})};
}

/// Fills columns word by word for one block of places.
class Columns {
 public:
  Columns(const Scene& scene, const Environment& environment, const Places& places)
      : scene_(scene), environment_(environment), places_(places) {}

  std::vector<double> of(const geom::Term& term) {
    std::vector<double> column(places_.at.size());
    if (!term.of_class.empty()) {
      fill_class_word(term, column);
    } else if (term.word == kNoiseWord) {
      const Seed seed = Seed{scene_.seed}.derive("noise of expressions");
      const double wavelength = std::abs(term.number) > 0.0 ? std::abs(term.number) : 1.0;
      each(column, [&](Vec2 at) { return 2.0 * geom::perlin(seed, at.x / wavelength, at.y / wavelength); });
    } else if (const auto word = std::find(kPlaceWords.begin(), kPlaceWords.end(), term.word);
               word != kPlaceWords.end()) {
      fill_place_word(static_cast<PlaceWord>(word - kPlaceWords.begin()), column);
    } else {
      read(material(term.word), 1.0, 0.0, column);
    }
    return column;
  }

 private:
  template <class F>
  void each(std::vector<double>& column, F f) const {
    for (size_t i = 0; i < column.size(); ++i) column[i] = f(places_.at[i]);
  }

  /// Of the places, once for all words that read a field.
  const std::vector<Reading>& readings() {
    if (readings_.empty()) {
      readings_.reserve(places_.at.size());
      for (const Vec2 at : places_.at) readings_.emplace_back(environment_.frame, at);
    }
    return readings_;
  }

  void read(const ScalarField& field, double sign, double above, std::vector<double>& column) {
    const std::vector<Reading>& from = readings();
    for (size_t i = 0; i < column.size(); ++i) column[i] = sign * from[i].of(field) + above;
  }

  const ScalarField& material(const std::string& name) const {
    const auto& materials = scene_.catalogue.materials;
    const auto found =
        std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
    return environment_.materials[static_cast<size_t>(found - materials.begin())];
  }

  void fill_place_word(PlaceWord word, std::vector<double>& column) {
    const Environment& e = environment_;
    switch (word) {
      case PlaceWord::height:
        return read(e.height, 1.0, 0.0, column);
      case PlaceWord::depth:
        return read(e.height, -1.0, 0.0, column);
      case PlaceWord::ground:
        return read(e.height, 1.0, e.water_level_m, column);
      case PlaceWord::slope_deg:
        return each(column, [&](Vec2 at) {
          const Vec2 g = gradient(e.height, at);
          return std::atan(std::hypot(g.x, g.y)) * 180.0 / std::numbers::pi;
        });
      case PlaceWord::gradient_x:
        return each(column, [&](Vec2 at) { return gradient(e.height, at).x; });
      case PlaceWord::gradient_y:
        return each(column, [&](Vec2 at) { return gradient(e.height, at).y; });
      case PlaceWord::current:
        for (size_t i = 0; i < column.size(); ++i) {
          const Reading& reading = readings()[i];
          column[i] = std::hypot(reading.of(e.current.x), reading.of(e.current.y));
        }
        return;
      case PlaceWord::current_x:
        return read(e.current.x, 1.0, 0.0, column);
      case PlaceWord::current_y:
        return read(e.current.y, 1.0, 0.0, column);
      case PlaceWord::x:
        return each(column, [](Vec2 at) { return at.x; });
      case PlaceWord::y:
        return each(column, [](Vec2 at) { return at.y; });
      case PlaceWord::age:
        if (!places_.age.empty()) std::copy(places_.age.begin(), places_.age.end(), column.begin());
        return;
      case PlaceWord::iteration:
        return each(column, [&](Vec2) { return static_cast<double>(iterations_in(scene_, environment_.window)); });
      case PlaceWord::water_level:
        return each(column, [&](Vec2) { return e.water_level_m; });
    }
  }

  void fill_class_word(const geom::Term& term, std::vector<double>& column) {
    if (term.word == kClassWords[static_cast<size_t>(ClassWord::screened)])
      return read(environment_.screened[class_index(term.of_class)], 1.0, 0.0, column);
    const std::vector<geom::NearestSkeleton>& found = nearest(term.of_class);
    const auto word = std::find(kClassWords.begin(), kClassWords.end(), term.word) - kClassWords.begin();
    const double far = std::hypot(environment_.frame.width_m(), environment_.frame.height_m());
    for (size_t i = 0; i < column.size(); ++i) {
      const geom::NearestSkeleton& hit = found[i];
      switch (static_cast<ClassWord>(word)) {
        case ClassWord::distance:
          column[i] = hit.inside ? 0.0 : std::min(hit.distance, far);
          break;
        case ClassWord::border:
          column[i] = std::min(hit.distance, far);
          break;
        case ClassWord::inside:
          column[i] = hit.inside ? 1.0 : 0.0;
          break;
        case ClassWord::normal_x:
          column[i] = hit.normal.x;
          break;
        case ClassWord::normal_y:
          column[i] = hit.normal.y;
          break;
        case ClassWord::curvature:
          column[i] = hit.curvature;
          break;
        case ClassWord::screened:
          break;  // a field, read above
      }
    }
  }

  size_t class_index(const std::string& name) const {
    const auto& classes = scene_.catalogue.classes;
    const auto of = std::find_if(classes.begin(), classes.end(), [&](const ObjectClass& c) { return c.name == name; });
    return static_cast<size_t>(of - classes.begin());
  }

  /// Of a class; asked once for all its words.
  const std::vector<geom::NearestSkeleton>& nearest(const std::string& name) {
    const size_t index = class_index(name);
    for (const auto& [number, results] : asked_)
      if (number == index) return results;
    std::vector<geom::NearestSkeleton> results(places_.at.size());
    environment_.of_class[index].nearest(places_.at, places_.self, results, {.threads = 1});
    asked_.emplace_back(index, std::move(results));
    return asked_.back().second;
  }

  const Scene& scene_;
  const Environment& environment_;
  const Places& places_;
  std::vector<Reading> readings_;
  std::vector<std::pair<size_t, std::vector<geom::NearestSkeleton>>> asked_;
};

}  // namespace

void Survey::ask_block(const geom::Expression& expression, const Places& places, std::span<double> out) const {
  Columns columns(scene_, environment_, places);
  std::vector<std::vector<double>> values;
  values.reserve(expression.terms().size());
  for (const geom::Term& term : expression.terms()) values.push_back(columns.of(term));
  const std::vector<std::span<const double>> views(values.begin(), values.end());
  expression.evaluate(views, out);
  for (size_t i = 0; i < out.size(); ++i)
    if (!contains(environment_.frame, places.at[i])) out[i] = std::numeric_limits<double>::quiet_NaN();
}

void Survey::ask(const geom::Expression& expression, const Places& places, std::span<double> out) const {
  const auto part_of = [](auto values, int64_t begin, int64_t end) {
    return values.size() <= 1 ? values : values.subspan(static_cast<size_t>(begin), static_cast<size_t>(end - begin));
  };
  parallel_blocks(run_, static_cast<int64_t>(places.at.size()), kBlock, [&](int64_t begin, int64_t end) {
    const auto part = [&](auto values) { return part_of(values, begin, end); };
    const auto whole = [&](auto values) {
      return values.subspan(static_cast<size_t>(begin), static_cast<size_t>(end - begin));
    };
    ask_block(expression, {whole(places.at), part(places.self), places.age.empty() ? places.age : whole(places.age)},
              whole(out));
  });
}

}  // namespace seamount::ecosystem
