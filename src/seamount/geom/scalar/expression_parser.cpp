// Text to instructions: one method per level of precedence, each of which leaves its value on the stack.
#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "seamount/base/printable.h"
#include "seamount/base/text.h"
#include "seamount/geom/scalar/expression.h"
#include "seamount/geom/scalar/expression_code.h"

namespace seamount::geom {
namespace {

constexpr int kDeepest = 100;

bool starts_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, const Vocabulary& vocabulary) : text_(text), vocabulary_(vocabulary) {}

  Expression parse() {
    skip_blanks();
    if (at_end()) fail(at_, "there is no expression");
    choice();
    if (!at_end()) fail(at_, "expected an operator, found " + found());
    return std::move(made_);
  }

 private:
  using Code = expression::Code;

  [[noreturn]] static void fail(size_t at, const std::string& why) { throw ExpressionError(at + 1, why); }
  bool at_end() const { return at_ == text_.size(); }
  std::string found() const { return at_end() ? "the end" : "'" + printable(std::string(1, text_[at_])) + "'"; }

  void skip_blanks() {
    while (!at_end() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r')) ++at_;
  }
  bool take(std::string_view sign) {
    if (text_.substr(at_, sign.size()) != sign) return false;
    at_ += sign.size();
    skip_blanks();
    return true;
  }
  void expect(std::string_view sign, const std::string& where) {
    if (!take(sign)) fail(at_, "expected '" + std::string(sign) + "' " + where + ", found " + found());
  }

  void emit(Code code, double value = 0.0, uint32_t index = 0) {
    stack_ -= expression::operands(code);
    ++stack_;
    made_.depth_ = std::max(made_.depth_, stack_);
    made_.code_.push_back({static_cast<uint8_t>(code), index, value});
  }

  void choice() {
    if (++nesting_ > kDeepest) fail(at_, "nested more than 100 levels deep");
    either();
    if (take("?")) {
      choice();
      expect(":", "of the choice");
      choice();
      emit(Code::choose);
    }
    --nesting_;
  }

  void either() {
    both();
    while (take("||")) {
      both();
      emit(Code::either);
    }
  }

  void both() {
    comparison();
    while (take("&&")) {
      comparison();
      emit(Code::both);
    }
  }

  void comparison() {
    constexpr std::array<std::pair<std::string_view, Code>, 6> kSigns = {{{"<=", Code::at_most},
                                                                          {">=", Code::at_least},
                                                                          {"==", Code::equal},
                                                                          {"!=", Code::different},
                                                                          {"<", Code::less},
                                                                          {">", Code::more}}};
    sum();
    for (const auto& [sign, code] : kSigns) {
      if (!take(sign)) continue;
      sum();
      return emit(code);
    }
    if (!at_end() && text_[at_] == '=') fail(at_, "'=' gives a value; '==' compares");
  }

  void sum() {
    product();
    while (true) {
      if (take("+")) {
        product();
        emit(Code::add);
      } else if (take("-")) {
        product();
        emit(Code::subtract);
      } else {
        return;
      }
    }
  }

  void product() {
    signed_value();
    while (true) {
      if (take("*")) {
        signed_value();
        emit(Code::multiply);
      } else if (take("/")) {
        signed_value();
        emit(Code::divide);
      } else {
        return;
      }
    }
  }

  void signed_value() {
    if (++nesting_ > kDeepest) fail(at_, "nested more than 100 levels deep");
    if (take("-")) {
      signed_value();
      emit(Code::negate);
    } else if (take("+")) {
      signed_value();
    } else if (text_.substr(at_, 2) != "!=" && take("!")) {
      signed_value();
      emit(Code::invert);
    } else {
      value();
      if (take("^")) {
        signed_value();
        emit(Code::power);
      }
    }
    --nesting_;
  }

  void value() {
    if (at_end()) fail(at_, "expected a value, found the end");
    if (take("(")) {
      choice();
      return expect(")", "after the parenthesis");
    }
    if (is_digit(text_[at_]) || text_[at_] == '.') return emit(Code::constant, number());
    if (starts_name(text_[at_])) return name();
    fail(at_, "expected a value, found " + found());
  }

  double number() {
    double parsed = 0.0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), parsed);
    if (error != std::errc()) fail(at_, "this is no number that can be held");
    at_ = static_cast<size_t>(end - text_.data());
    skip_blanks();
    return parsed;
  }

  std::string word() {
    const size_t begin = at_;
    while (!at_end() && (starts_name(text_[at_]) || is_digit(text_[at_]))) ++at_;
    std::string taken(text_.substr(begin, at_ - begin));
    skip_blanks();
    return taken;
  }

  static bool holds(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  void name() {
    const size_t begin = at_;
    const std::string taken = word();
    if (taken == "pi") return emit(Code::constant, std::numbers::pi);
    if (holds(vocabulary_.variables, taken)) return term({taken});
    for (const expression::Function& function : expression::kFunctions)
      if (function.name == taken) return call(function);
    if (holds(vocabulary_.of_class, taken)) return about_class(taken);
    if (holds(vocabulary_.of_number, taken)) {
      expect("(", "after " + taken);
      const double factor = take("-") ? -1.0 : 1.0;
      if (at_end() || !(is_digit(text_[at_]) || text_[at_] == '.'))
        fail(at_, taken + "(...) takes a number as it stands");
      term({taken, {}, factor * number()});
      return expect(")", "after " + taken + "(...)");
    }
    fail(begin, "unknown name '" + printable(taken) + "'" + suggestion(taken, known_names()));
  }

  std::vector<std::string> known_names() const {
    std::vector<std::string> names = vocabulary_.variables;
    names.insert(names.end(), vocabulary_.of_class.begin(), vocabulary_.of_class.end());
    names.insert(names.end(), vocabulary_.of_number.begin(), vocabulary_.of_number.end());
    for (const expression::Function& function : expression::kFunctions) names.emplace_back(function.name);
    return names;
  }

  void about_class(const std::string& query) {
    expect("(", "and a class after " + query);
    const size_t begin = at_;
    const std::string taken = !at_end() && starts_name(text_[at_]) ? word() : "";
    if (taken.empty()) fail(begin, query + "(...) takes the name of a class, found " + found());
    if (!holds(vocabulary_.classes, taken))
      fail(begin, "unknown class '" + printable(taken) + "'" + suggestion(taken, vocabulary_.classes));
    term({query, taken});
    expect(")", "after " + query + "(" + taken);
  }

  void term(Term asked) {
    auto found = std::find(made_.terms_.begin(), made_.terms_.end(), asked);
    if (found == made_.terms_.end()) found = made_.terms_.insert(found, std::move(asked));
    emit(Code::term, 0.0, static_cast<uint32_t>(found - made_.terms_.begin()));
  }

  void call(const expression::Function& function) {
    const std::string name(function.name);
    expect("(", "after " + name);
    size_t given = 0;
    do {
      choice();
      if (++given >= 2 && function.joins) emit(function.code);
    } while (take(","));
    const bool right = function.joins ? given >= 2 : given == function.operands;
    if (!right) {
      fail(at_, name + " takes " + std::to_string(function.operands) + (function.joins ? " or more" : "") +
                    (function.operands == 1 ? " value, found " : " values, found ") + std::to_string(given));
    }
    expect(")", "after " + name + "(...");
    if (!function.joins) emit(function.code);
  }

  std::string_view text_;
  const Vocabulary& vocabulary_;
  size_t at_ = 0;
  size_t stack_ = 0;
  int nesting_ = 0;
  Expression made_;
};

Expression Expression::parse(std::string_view text, const Vocabulary& vocabulary) {
  if (text.size() > kLongest)
    throw ExpressionError(kLongest + 1, "more than " + std::to_string(kLongest) + " characters");
  return ExpressionParser(text, vocabulary).parse();
}

}  // namespace seamount::geom
