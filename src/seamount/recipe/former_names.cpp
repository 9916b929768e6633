#include "seamount/recipe/former_names.h"

#include "seamount/base/text.h"

namespace seamount::recipe {

std::string renamed_text(const std::string& former, const std::string& now) {
  return "'" + former + "' is now called '" + now + "'";
}

PresentNames::PresentNames(const Json& given, std::span<const FormerName> former, const ReadPlace& place)
    : given_(given), place_(place), defects_before_(place.diagnostics.items().size()) {
  for (const FormerName& name : former) {
    if (given.contains(std::string(name.name))) replace(name);
  }
}

void PresentNames::replace(const FormerName& former) {
  const std::string name(former.name), now(former.now);
  if (!renamed_) renamed_ = given_;
  Json value = std::move((*renamed_)[name]);
  renamed_->erase(name);
  const ReadPlace written = place_.at(pointer_token(name));

  Json* parent = &*renamed_;
  std::string pointer = place_.pointer, rest = now;
  for (size_t dot = rest.find('.'); dot != std::string::npos; dot = rest.find('.')) {
    parent = &(*parent)[rest.substr(0, dot)];
    if (parent->is_null()) *parent = Json::object();
    if (!parent->is_object()) return;  // a defect of the group, which will be found where it is read
    pointer += "/" + rest.substr(0, dot);
    rest = rest.substr(dot + 1);
  }
  if (parent->contains(rest)) return written.fail(renamed_text(name, now) + ", which is given too: leave one out");

  std::string text = renamed_text(name, now);
  if (former.factor != 1.0 && value.is_number()) {
    const double number = value.get<double>();
    value = number * former.factor;
    text += ", in another unit: " + format_number(number) + " is read as " + format_number(number * former.factor);
  }
  written.note(std::move(text));
  (*parent)[rest] = std::move(value);
  places_.emplace_back(pointer + "/" + rest, written.pointer);
}

void PresentNames::move_defects() {
  auto& items = place_.diagnostics.items();
  for (size_t i = defects_before_; i < items.size(); ++i) {
    std::string& pointer = items[i].pointer;
    for (const auto& [present, written] : places_) {
      const bool inside =
          pointer.starts_with(present) && pointer.size() > present.size() && pointer[present.size()] == '/';
      if (pointer == present || inside) {
        pointer.replace(0, present.size(), written);
        break;
      }
    }
  }
}

}  // namespace seamount::recipe
