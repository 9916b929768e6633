#include "seamount/geom/solve/transport.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/geom/scalar/point_source.h"
#include "seamount/model/drawn.h"

namespace seamount::geom {
namespace {

using Flow = std::function<Vec2(double, double)>;  // of places in [0, 1], y to the north

/// A problem that owns its fields.
struct Problem {
  Problem(int width, int height, double cell_m) : source(GridFrame::centred(width, height, cell_m), 0.0F) {}

  Problem& flowing(const Flow& at) {
    flow = VectorField{ScalarField(source.frame()), ScalarField(source.frame())};
    for (int y = 0; y < source.height(); ++y) {
      for (int x = 0; x < source.width(); ++x) {
        const Vec2 v = at((x + 0.5) / source.width(), 1.0 - (y + 0.5) / source.height());
        flow.x(x, y) = static_cast<float>(v.x);
        flow.y(x, y) = static_cast<float>(v.y);
      }
    }
    return *this;
  }
  Problem& spreading(double diffusivity, double decay) {
    diffusivity_m2_s = diffusivity;
    decay_per_s = decay;
    return *this;
  }
  Problem& spots(int count, uint64_t seed, double lowest = 0.1) {
    Rng rng(Seed{seed}.derive("spots"));
    for (int i = 0; i < count; ++i) {
      const int x = static_cast<int>(rng.uniform(0.0, source.width()));
      const int y = static_cast<int>(rng.uniform(0.0, source.height()));
      source(x, y) += static_cast<float>(rng.uniform(lowest, 1.0));
    }
    return *this;
  }
  Transport transport() const {
    return {&source, flow.empty() ? nullptr : &flow, around.empty() ? nullptr : &around, diffusivity_m2_s, decay_per_s};
  }
  ScalarField steady() const { return steady_state(transport(), {}); }

  ScalarField source, around;
  VectorField flow;
  double diffusivity_m2_s = 1.0, decay_per_s = 0.01;
};

float largest(const ScalarField& field) { return *std::max_element(field.cells().begin(), field.cells().end()); }

double difference(const ScalarField& a, const ScalarField& b) {
  float most = 0.0F;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a.cells()[i] - b.cells()[i]));
  return static_cast<double>(most) / static_cast<double>(std::max(largest(a), largest(b)));
}

const auto eddies = [](double x, double y) {
  constexpr double k = 4.0 * std::numbers::pi;
  return Vec2{std::sin(k * x) * std::cos(k * y), -std::cos(k * x) * std::sin(k * y)};
};
const auto towards_middle = [](double x, double y) { return Vec2{1.0 - 2.0 * x, 1.0 - 2.0 * y}; };
const auto from_middle = [](double x, double y) { return Vec2{2.0 * x - 1.0, 2.0 * y - 1.0}; };
const auto uniform = [](double, double) { return Vec2{0.8, -0.5}; };
const auto rough = [](double x, double y) {
  return Vec2{0.5 * std::sin(37 * x + 11 * y) + 0.4 * std::sin(90 * y), 0.6 * std::cos(23 * x - 31 * y)};
};

struct Named {
  std::string name;
  Problem problem;
};

std::vector<Named> problems() {
  std::vector<Named> all;
  const auto add = [&](std::string name, Problem problem) { all.push_back({std::move(name), std::move(problem)}); };
  add("still", Problem(64, 48, 10).spots(9, 1).spreading(10, 0.01));
  add("still, hardly spreading", Problem(50, 50, 10).spots(9, 1).spreading(0.01, 0.01));
  add("still, without decay", Problem(33, 40, 10).spots(9, 2).spreading(20, 0.0));
  add("uniform", Problem(64, 64, 10).spots(9, 3).flowing(uniform).spreading(1, 0.01));
  add("uniform, only carried", Problem(64, 64, 10).spots(9, 3).flowing(uniform).spreading(0, 0.0));
  add("eddies", Problem(64, 64, 10).spots(9, 4).flowing(eddies).spreading(0.5, 0.005));
  add("eddies, small decay", Problem(64, 64, 10).spots(9, 4).flowing(eddies).spreading(2, 1e-4));
  add("towards the middle", Problem(65, 65, 10).spots(30, 5).flowing(towards_middle).spreading(1, 0.01));
  add("only carried towards the middle", Problem(40, 40, 10).spots(30, 5).flowing(towards_middle).spreading(0, 0.02));
  add("from the middle", Problem(65, 65, 10).spots(30, 6).flowing(from_middle).spreading(1, 0.001));
  add("rough", Problem(64, 64, 10).spots(30, 7).flowing(rough).spreading(0.1, 0.002));
  add("rough, absorbing", Problem(64, 64, 10).spots(60, 8, -1.0).flowing(rough).spreading(1, 0.002));
  add("still, absorbing", Problem(64, 64, 10).spots(60, 9, -1.0).spreading(10, 0.0));
  add("uniform, absorbing", Problem(64, 64, 10).spots(60, 10, -1.0).flowing(uniform).spreading(1, 0.001));
  add("one cell", Problem(1, 1, 10).spots(1, 11).flowing(uniform).spreading(1, 0.01));
  add("a column", Problem(1, 70, 10).spots(5, 12).flowing(uniform).spreading(3, 0.01));
  add("a row", Problem(3, 70, 10).spots(5, 13).flowing(eddies).spreading(3, 0.01));
  add("513 x 130", Problem(513, 130, 10).spots(60, 14).flowing(eddies).spreading(3, 0.03));
  return all;
}

TEST(Transport, DirectAndEulerAgree) {
  for (const Named& named : problems()) {
    EulerOptions euler;
    euler.tolerance = 1e-9;
    const Transport transport = named.problem.transport();
    const ScalarField judge = euler_state(transport, {}, euler);
    EXPECT_LT(difference(steady_state(transport, {}), judge), 1e-3) << named.name;
  }
}

TEST(Transport, ConcentrationsAreNeverNegativeAndMaterialIsKept) {
  for (const Named& named : problems()) {
    const Transport transport = named.problem.transport();
    const ScalarField state = steady_state(transport, {});
    for (const float v : state.cells()) ASSERT_GE(v, 0.0F) << named.name;
    const MaterialBalance balance = material_balance(state, transport);
    EXPECT_NEAR(balance.change(), 0.0, 1e-3 * balance.deposited) << named.name;
  }
}

TEST(Transport, EulerStepsLoseNothingButWhatTheySay) {
  const Problem problem = Problem(20, 20, 10).spots(5, 1).flowing(towards_middle).spreading(0, 0.0);
  EulerOptions few;
  few.max_steps = 50;
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said = line; };
  const ScalarField state = euler_state(problem.transport(), run, few);
  EXPECT_NE(said.find("not steady after 50 steps"), std::string::npos);
  double mass = 0.0, source = 0.0, fastest = 0.0;
  for (const float v : state.cells()) mass += static_cast<double>(v);
  for (const float v : problem.source.cells()) source += static_cast<double>(v);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) {  // outflow of each cell towards the middle, as faces see it
      const auto face = [&](const ScalarField& f, int nx, int ny) {
        return 0.5 * static_cast<double>(f(x, y) + f.clamped(nx, ny)) / 10.0;
      };
      const double rate =
          std::max(0.0, -face(problem.flow.x, x - 1, y)) + std::max(0.0, face(problem.flow.x, x + 1, y)) +
          std::max(0.0, face(problem.flow.y, x, y - 1)) + std::max(0.0, -face(problem.flow.y, x, y + 1));
      fastest = std::max(fastest, rate);
    }
  EXPECT_NEAR(mass, 50 * (0.9 / fastest) * source, 1e-4 * mass);
}

TEST(Transport, MoreSourceNeverGivesLess) {
  for (const Named& named : problems()) {
    Problem more = named.problem;
    more.spots(3, 99);
    const ScalarField before = named.problem.steady(), after = more.steady();
    const float slack = 6e-4F * largest(after);
    for (size_t i = 0; i < before.size(); ++i) ASSERT_GE(after.cells()[i] + slack, before.cells()[i]) << named.name;
  }
}

TEST(Transport, TurnsAndMirrorsWithItsInputs) {
  const auto problem = [](bool mirrored, bool turned) {
    Problem p = Problem(60, 60, 5).spreading(0.3, 0.01).flowing([=](double x, double y) {
      const double a = mirrored ? 1.0 - x : x;
      const Vec2 v = turned ? rough(y, 1.0 - a) : rough(a, y);
      const Vec2 w = turned ? Vec2{-v.y, v.x} : v;
      return Vec2{mirrored ? -w.x : w.x, w.y};
    });
    const Problem spots = Problem(60, 60, 5).spots(12, 3);
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x) {
        const int a = mirrored ? 59 - x : x;
        p.source(x, y) = turned ? spots.source(59 - y, a) : spots.source(a, y);
      }
    return p.steady();
  };
  const ScalarField plain = problem(false, false), mirrored = problem(true, false), turned = problem(false, true);
  ScalarField back(plain.frame()), forth(plain.frame());
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) {
      back(x, y) = mirrored(59 - x, y);
      forth(59 - y, x) = turned(x, y);
    }
  EXPECT_LT(difference(plain, back), 1e-3);
  EXPECT_LT(difference(plain, forth), 1e-3);
}

TEST(Transport, StillWaterFollowsTheBesselFunction) {
  Problem problem = Problem(257, 257, 2).spreading(4.0, 0.01);  // 20 m decay length
  const double sigma = 6.0;
  const GridFrame& frame = problem.source.frame();
  for (int y = 0; y < 257; ++y)
    for (int x = 0; x < 257; ++x) {
      const double r2 = std::pow(frame.x(x), 2) + std::pow(frame.y(y), 2);
      problem.source(x, y) =
          static_cast<float>(std::exp(-r2 / (2 * sigma * sigma)) / (2 * std::numbers::pi * sigma * sigma));
    }
  const ScalarField state = problem.steady();
  const double top = steady_gaussian_source(1.0, 0.0, 4.0, 0.01, sigma);
  for (int x = 128; x < 200; ++x) {
    const double exact = steady_gaussian_source(1.0, frame.x(x), 4.0, 0.01, sigma);
    EXPECT_NEAR(static_cast<double>(state(x, 128)), exact, 0.01 * top) << x;
  }
}

TEST(Transport, AUniformFlowCarriesAProfile) {
  // One row: upwinding carries c' = u / (u + mu h) c from cell to cell.
  Problem problem = Problem(40, 1, 10).spreading(0.0, 0.02).flowing([](double, double) { return Vec2{0.5, 0.0}; });
  problem.source(4, 0) = 3.0F;
  const ScalarField state = problem.steady();
  double expected = 3.0 / (0.05 + 0.02);
  for (int x = 0; x < 4; ++x) EXPECT_EQ(state(x, 0), 0.0F);
  for (int x = 4; x < 40; ++x) {
    EXPECT_NEAR(static_cast<double>(state(x, 0)), expected, 1e-4 * expected) << x;
    expected *= 0.05 / 0.07;
  }
}

TEST(Transport, AWindowContinuesWhatIsAroundIt) {
  const Problem whole = Problem(96, 96, 10).spots(40, 5).flowing(eddies).spreading(5, 0.005);
  const ScalarField all = whole.steady();
  Problem window(40, 40, 10);
  window.spreading(5, 0.005).flowing([](double, double) { return Vec2{}; });
  window.around = ScalarField(window.source.frame(), 0.0F);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const int wx = x + 30, wy = y + 25;
      window.source(x, y) = whole.source(wx, wy);
      window.flow.x(x, y) = whole.flow.x(wx, wy);
      window.flow.y(x, y) = whole.flow.y(wx, wy);
      // Beyond a border cell lies the next cell of the whole; a corner knows two of them.
      window.around(x, y) = all(wx + (x == 39) - (x == 0), wy + (x > 0 && x < 39 ? (y == 39) - (y == 0) : 0));
    }
  const ScalarField state = window.steady();
  for (int y = 2; y < 38; ++y)
    for (int x = 2; x < 38; ++x)
      ASSERT_NEAR(static_cast<double>(state(x, y)), static_cast<double>(all(x + 30, y + 25)),
                  0.02 * static_cast<double>(largest(all)))
          << x << ' ' << y;
}

TEST(Transport, AConstantSurroundingOfADecaylessWaterFillsIt) {
  Problem problem = Problem(37, 20, 3).spreading(2, 0.0).flowing(uniform);
  problem.around = ScalarField(problem.source.frame(), 2.5F);
  const ScalarField state = problem.steady();
  for (const float v : state.cells()) ASSERT_NEAR(v, 2.5F, 2e-3F);
}

TEST(Transport, NothingGivesNothing) {
  Problem problem = Problem(30, 30, 1).flowing(eddies);
  EXPECT_EQ(largest(problem.steady()), 0.0F);
  problem.source(3, 3) = -1.0F;
  EXPECT_EQ(largest(problem.steady()), 0.0F);
  EXPECT_TRUE(steady_state({&problem.around}, {}).empty());
}

TEST(Transport, AbsorbersTakeNoMoreThanThereIs) {
  Problem problem = Problem(40, 40, 10).spreading(5, 0.001);
  problem.source(20, 20) = 1.0F;
  for (int y = 0; y < 40; ++y) problem.source(25, y) = -10.0F;
  const ScalarField state = problem.steady();
  const MaterialBalance balance = material_balance(state, problem.transport());
  for (int y = 0; y < 40; ++y) EXPECT_EQ(state(25, y), 0.0F);
  for (int x = 26; x < 40; ++x) EXPECT_EQ(state(x, 20), 0.0F);
  EXPECT_GT(balance.taken, 0.2);
  EXPECT_NEAR(balance.change(), 0.0, 1e-3);
}

TEST(Transport, SaysWhereThereIsNoSteadyState) {
  const Problem gathered = Problem(20, 20, 10).spots(5, 1).flowing(towards_middle).spreading(0, 0.0);
  EXPECT_THROW(gathered.steady(), InvalidArgument);
  const Problem still = Problem(20, 20, 10).spots(5, 1).spreading(0, 0.0);
  try {
    still.steady();
    FAIL();
  } catch (const InvalidArgument& e) {
    EXPECT_EQ(e.field(), "decay_per_s");
    EXPECT_NE(std::string(e.what()).find("no steady state"), std::string::npos);
  }
  EXPECT_NO_THROW(Problem(20, 20, 10).spots(5, 1).flowing(from_middle).spreading(0, 0.0).steady());
}

TEST(Transport, RefusesWhatIsNoNumber) {
  Problem problem = Problem(8, 8, 1).spots(2, 1).flowing(uniform);
  EXPECT_THROW(Problem(problem).spreading(-1, 0.1).steady(), InvalidArgument);
  EXPECT_THROW(Problem(problem).spreading(1, std::nan("")).steady(), InvalidArgument);
  Problem holed = problem;
  holed.flow.y(2, 2) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(holed.steady(), InvalidArgument);
  Problem other = problem;
  other.around = ScalarField(GridFrame::centred(7, 8, 1), 0.0F);
  EXPECT_THROW(other.steady(), IncompatibleInputs);
  EXPECT_THROW(steady_state({}, {}), InvalidArgument);
}

TEST(Transport, SameBitsAloneInCompanyAndOnAnyNumberOfThreads) {
  const std::vector<Named> all = problems();
  std::vector<Transport> transports;
  for (const Named& named : all) transports.push_back(named.problem.transport());
  RunContext one, four;
  one.threads = 1;
  four.threads = 4;
  const std::vector<ScalarField> serial = steady_states(transports, one);
  EXPECT_EQ(serial, steady_states(transports, four));
  for (size_t i = 0; i < all.size(); ++i) EXPECT_EQ(serial[i], steady_state(transports[i], four)) << all[i].name;
}

TEST(Transport, CancelsPromptly) {
  std::atomic<bool> stop{true};
  RunContext run;
  run.cancelled = &stop;
  const Problem problem = Problem(64, 64, 10).spots(9, 1);
  EXPECT_THROW(steady_state(problem.transport(), run), Cancelled);
}

TEST(Transport, UnitsDoNotMatter) {
  const Problem plain = Problem(48, 48, 10).spots(20, 2).flowing(eddies).spreading(2, 0.01);
  Problem tiny = Problem(48, 48, 1e-6).spots(20, 2).flowing([](double x, double y) { return 1e-12 * eddies(x, y); });
  tiny.spreading(2e-19, 0.01e-5);  // lengths 1e-7, times 1e5 of the plain one's
  for (float& v : tiny.source.cells()) v *= 1e20F;
  ScalarField scaled = tiny.steady();
  for (float& v : scaled.cells()) v *= 1e-25F;
  ScalarField expected = plain.steady();
  EXPECT_LT(difference(scaled, expected), 1e-4);
}

}  // namespace
}  // namespace seamount::geom
