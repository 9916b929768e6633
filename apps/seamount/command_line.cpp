#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <type_traits>

#include "about_program.h"
#include "app.h"
#include "seamount/base/text.h"

namespace seamount::app {
namespace {

CLI::Validator whole_number() {
  return {[](std::string& text) -> std::string {
            const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
            uint64_t number = 0;
            const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
            if (digits && read.ec == std::errc{}) return "";
            return "expected a whole number from 0 to 2^64 - 1, found '" + text + "'";
          },
          "WHOLE"};
}

CLI::Validator finite_number() {
  return {[](std::string& text) -> std::string {
            double number = 0;
            if (CLI::detail::lexical_cast(text, number) && std::isfinite(number)) return "";
            return "expected a number, found '" + text + "'";
          },
          "NUMBER"};
}

/// The commands' names, to suggest one.
std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

/// The option that the beginning of its name means, or the option itself; nullptr: none. Throws for several.
const CLI::Option* meant_option(const CLI::App& command, const std::string& flag) {
  std::vector<std::string> names;
  const CLI::Option* meant = nullptr;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames())
      if (name == flag) return option;
    const bool within = flag.find('.') != std::string::npos;
    const auto begins = [&](const std::string& name) {
      return name.starts_with(flag) && (within || name.find('.') == std::string::npos);
    };
    const bool shown = !option->get_group().empty();  // former names are not
    if (!shown || std::none_of(option->get_lnames().begin(), option->get_lnames().end(), begins)) continue;
    meant = option;
    names.push_back("--" + option->get_lnames().front());
  }
  if (names.size() < 2) return meant;
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  throw InvalidArgument("--" + flag, "may be each of " + all);
}

/// The command line with abbreviated flags written out: "--vertical 2" as "--vertical_exaggeration 2", wherever one
/// flag of the command alone begins so. A group's name means the group, not its members.
std::vector<std::string> written_out(const CLI::App& program, int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  const CLI::App* command = &program;
  for (std::string& word : words) {
    if (!word.starts_with("--")) {
      for (const CLI::App* inner :
           command->get_subcommands([&](const CLI::App* one) { return one->get_name() == word; }))
        command = inner;
      continue;
    }
    const size_t end = std::min(word.find('='), word.size());
    if (end < 3) continue;
    const std::string flag = word.substr(2, end - 2);
    if (const CLI::Option* option = meant_option(*command, flag); option != nullptr && !option->check_lname(flag))
      word = "--" + option->get_lnames().front() + word.substr(end);
  }
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  return words;
}

/// "unknown flag '--relef', did you mean '--relief'?" for the first argument that the chosen command does not know.
std::string unknown_argument(const CLI::App& program, const CLI::ExtrasError& error) {
  for (const CLI::App* command : program.get_subcommands()) {
    for (const CLI::App* inner : command->get_subcommands()) command = inner;
    for (const std::string& extra : command->remaining(false)) {
      if (!extra.starts_with("--")) continue;
      const std::string flag = extra.substr(0, extra.find('='));
      std::vector<std::string> names;
      for (const CLI::Option* option : command->get_options())
        if (!option->get_lnames().empty()) names.push_back("--" + option->get_lnames().front());
      return "unknown flag '" + flag + "'" + suggestion(flag, names);
    }
  }
  return error.what();
}

/// A usage error in one line, with the nearest command or flag where one was mistyped.
int report_usage(const CLI::App& program, const CLI::ParseError& error, int argc, char** argv) {
  if (error.get_exit_code() == 0) return program.exit(error, std::cout, std::cerr);
  std::string message = error.what();
  const CLI::App* command = &program;
  for (int i = 1; i < argc && argv[i][0] != '-'; ++i) {
    const std::vector<std::string> names = command_names(*command);
    if (names.empty()) break;
    if (std::find(names.begin(), names.end(), argv[i]) == names.end()) {
      message = std::string("unknown command '") + argv[i] + "'" + suggestion(argv[i], names);
      break;
    }
    command = command->get_subcommand(argv[i]);
  }
  if (const auto* extras = dynamic_cast<const CLI::ExtrasError*>(&error); extras != nullptr && message == error.what())
    message = unknown_argument(program, *extras);
  print_message("seamount: " + message);
  return kWrongInput;
}

}  // namespace

Flag Flag::required() {
  option_->required();
  return *this;
}

Flag Flag::between(int64_t low, int64_t high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

Flag Flag::whole() {
  option_->check(whole_number());
  return *this;
}

Flag Flag::finite() {
  option_->check(finite_number());
  return *this;
}

Flag Flag::kind(const std::string& name) {
  option_->type_name(name);
  return *this;
}

Flag Flag::group(const std::string& name) {
  option_->group(name);
  return *this;
}

Command Command::add_command(const std::string& name, const std::string& summary, const std::string& group) {
  return Command(app_->add_subcommand(name, summary)->group(group), chosen_);
}

Flag Command::add(const std::string& names, Target target, const std::string& help) {
  const auto add_option = [&](auto& to) -> CLI::Option* {
    using To = std::decay_t<decltype(to)>;
    if constexpr (std::is_pointer_v<To>) {
      return app_->add_option(names, *to, help);
    } else {
      return app_->add_option_function<std::string>(names, to, help);
    }
  };
  CLI::Option* option = std::visit(add_option, target);
  if (std::holds_alternative<std::vector<std::string>*>(target) && names.starts_with('-'))
    option->allow_extra_args(false);
  return Flag(option);
}

Flag Command::add_switch(const std::string& name, bool& target, const std::string& help) {
  return Flag(app_->add_flag(name, target, help));
}

bool Command::has(const std::string& name) const { return app_->get_option_no_throw(name) != nullptr; }

void Command::require_command() { app_->require_subcommand(1); }

void Command::does(Work work) {
  app_->callback([chosen = chosen_, work = std::move(work)] { *chosen = work; });
}

int run_command_line(int argc, char** argv, const std::function<void(Command)>& add_commands) {
  CLI::App program("Seamount: terrain authoring, from ridgeline to reef", "seamount");
  program.set_version_flag("--version", about_program, "The version, what it was built with, where its files lie");
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  Work work;
  add_commands(Command(&program, &work));
  try {
    program.parse(written_out(program, argc, argv));
  } catch (const CLI::ParseError& error) {
    return report_usage(program, error, argc, argv);
  }
  work();
  return kDone;
}

}  // namespace seamount::app
