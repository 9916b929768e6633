#include "seamount/io/svg_path.h"

#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "seamount/base/error.h"

namespace seamount::io {
namespace {

/// Numbers, letters and separators of an attribute, one after the other.
class Scanner {
 public:
  Scanner(std::string_view text, const char* what) : text_(text), what_(what) {}

  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == ',' || text_[at_] == '\t' || text_[at_] == '\n' ||
                                  text_[at_] == '\r' || text_[at_] == '\f'))
      ++at_;
  }
  bool ended() {
    skip();
    return at_ >= text_.size();
  }
  bool at_letter() {
    skip();
    return at_ < text_.size() && ((text_[at_] | 32) >= 'a' && (text_[at_] | 32) <= 'z');
  }
  bool take(char c) {
    skip();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  char letter() { return text_[at_++]; }
  std::string word() {
    std::string word;
    while (at_letter()) word += letter();
    return word;
  }

  double number() {
    skip();
    if (at_ < text_.size() && text_[at_] == '+') ++at_;
    double value = 0.0;
    const char* const end = text_.data() + text_.size();
    const auto [next, error] = std::from_chars(text_.data() + at_, end, value);
    if (error != std::errc() || !std::isfinite(value) || std::abs(value) > 1e15) fail("a number is missing");
    at_ = static_cast<size_t>(next - text_.data());
    return value;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InvalidArgument(what_, problem + " at character " + std::to_string(at_));
  }

 private:
  std::string_view text_;
  const char* what_;
  size_t at_ = 0;
};

/// The pen of a path.
class PathReader {
 public:
  explicit PathReader(std::string_view d) : scan_(d, "d") {}

  std::vector<SvgChain> read() {
    char command = 0;
    while (!scan_.ended()) {
      if (scan_.at_letter()) {
        command = scan_.letter();
        if ((command | 32) == 'z') {
          close();
          continue;
        }
      } else if (command == 0 || (command | 32) == 'z') {
        scan_.fail("a command is missing");
      }
      step(command);
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    return std::move(chains_);
  }

 private:
  Vec2 point(bool relative) {
    const double x = scan_.number();
    const double y = scan_.number();
    return relative ? pen_ + Vec2{x, y} : Vec2{x, y};
  }

  void step(char command) {
    const bool relative = command >= 'a';
    const char kind = static_cast<char>(command | 32);
    if (chains_.empty() && kind != 'm') scan_.fail("a path begins with M");
    if (fresh_ && kind != 'm') begin(pen_);
    Vec2 control = pen_;
    switch (kind) {
      case 'm':
        begin(point(relative));
        break;
      case 'l':
        line_to(point(relative));
        break;
      case 'h':
        line_to({scan_.number() + (relative ? pen_.x : 0.0), pen_.y});
        break;
      case 'v':
        line_to({pen_.x, scan_.number() + (relative ? pen_.y : 0.0)});
        break;
      case 'c':
      case 's': {
        const Vec2 first = kind == 'c' ? point(relative) : last_ == 'c' ? 2.0 * pen_ - control_ : pen_;
        control = point(relative);
        curve_to(first, control, point(relative));
        break;
      }
      case 'q':
      case 't': {
        control = kind == 'q' ? point(relative) : last_ == 'q' ? 2.0 * pen_ - control_ : pen_;
        const Vec2 end = point(relative);
        curve_to(pen_ + (2.0 / 3.0) * (control - pen_), end + (2.0 / 3.0) * (control - end), end);
        break;
      }
      default:
        scan_.fail(std::string("the command '") + command + "' is not read; flatten the path to lines and curves");
    }
    control_ = control;
    last_ = kind == 's' ? 'c' : kind == 't' ? 'q' : kind;
  }

  void begin(Vec2 p) {
    chains_.push_back({{p}, false});
    pen_ = p;
    fresh_ = false;
  }

  void line_to(Vec2 p) {
    chains_.back().points.push_back(p);
    pen_ = p;
  }

  void curve_to(Vec2 b, Vec2 c, Vec2 d) {
    constexpr int kEdges = 16;
    const Vec2 a = pen_;
    for (int i = 1; i < kEdges; ++i) {
      const double t = static_cast<double>(i) / kEdges, s = 1.0 - t;
      line_to(s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d);
    }
    line_to(d);
  }

  void close() {
    if (chains_.empty()) scan_.fail("a path begins with M");
    SvgChain& chain = chains_.back();
    pen_ = chain.points.front();
    while (chain.points.size() > 1 && chain.points.back() == pen_) chain.points.pop_back();
    chain.closed = true;
    fresh_ = true;
    last_ = 'z';
  }

  Scanner scan_;
  std::vector<SvgChain> chains_;
  Vec2 pen_, control_;
  char last_ = 0;
  bool fresh_ = false;  ///< the last subpath is closed: what follows begins another where it began
};

}  // namespace

std::vector<SvgChain> parse_svg_path(std::string_view d) { return PathReader(d).read(); }

Polyline parse_svg_points(std::string_view points) {
  Scanner scan(points, "points");
  Polyline line;
  while (!scan.ended()) {
    const double x = scan.number();
    line.push_back({x, scan.number()});
  }
  return line;
}

SvgMatrix SvgMatrix::after(const SvgMatrix& inner) const {
  const Vec2 x = {a * inner.a + c * inner.b, b * inner.a + d * inner.b};
  const Vec2 y = {a * inner.c + c * inner.d, b * inner.c + d * inner.d};
  const Vec2 o = (*this)({inner.e, inner.f});
  return {x.x, x.y, y.x, y.y, o.x, o.y};
}

SvgMatrix parse_svg_transform(std::string_view text) {
  Scanner scan(text, "transform");
  SvgMatrix whole;
  while (!scan.ended()) {
    const std::string name = scan.word();
    if (!scan.take('(')) scan.fail("'(' is missing");
    std::vector<double> n;
    while (!scan.take(')')) {
      n.push_back(scan.number());
      if (n.size() > 6) scan.fail("too many numbers");
    }
    const double radians = n.empty() ? 0.0 : n[0] * std::numbers::pi / 180.0;
    const double cosine = std::cos(radians), sine = std::sin(radians);
    SvgMatrix one;
    if (name == "matrix" && n.size() == 6) {
      one = {n[0], n[1], n[2], n[3], n[4], n[5]};
    } else if (name == "translate" && (n.size() == 1 || n.size() == 2)) {
      one = {1, 0, 0, 1, n[0], n.size() > 1 ? n[1] : 0.0};
    } else if (name == "scale" && (n.size() == 1 || n.size() == 2)) {
      one = {n[0], 0, 0, n.size() > 1 ? n[1] : n[0], 0, 0};
    } else if (name == "rotate" && (n.size() == 1 || n.size() == 3)) {
      const Vec2 centre = n.size() == 3 ? Vec2{n[1], n[2]} : Vec2{};
      one = {cosine, sine, -sine, cosine, 0, 0};
      const Vec2 turned = one(centre);
      one.e = centre.x - turned.x, one.f = centre.y - turned.y;
    } else if (name == "skewX" && n.size() == 1) {
      one.c = std::tan(radians);
    } else if (name == "skewY" && n.size() == 1) {
      one.b = std::tan(radians);
    } else {
      scan.fail("'" + name.substr(0, 20) + "' with " + std::to_string(n.size()) + " numbers is no transform");
    }
    whole = whole.after(one);
  }
  return whole;
}

}  // namespace seamount::io
