// seamount: the command line. Commands are in the files beside this one.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "app.h"
#include "seamount/base/large_block.h"
#include "seamount/base/text.h"
#include "seamount/base/version.h"
#include "seamount/recipe/registry.h"

namespace seamount::app {
namespace {

/// The commands' names, to suggest one.
std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
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
  std::cerr << "seamount: " << message << "\n";
  return kWrongInput;
}

int run_program(int argc, char** argv, const recipe::Registry& registry) {
  CLI::App program("Seamount: terrain authoring, from ridgeline to reef", "seamount");
  program.set_version_flag("--version", std::string("seamount ") + kVersion);
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  Work work;
  add_run_command(program, registry, work);
  add_discover_commands(program, registry, work);
  add_chore_commands(program, work);
  add_dataset_command(program, work);
  add_operator_commands(program, registry, work);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_usage(program, error, argc, argv);
  }
  work();
  return kDone;
}

}  // namespace
}  // namespace seamount::app

int main(int argc, char** argv) {
  seamount::keep_freed_memory();
  using namespace seamount;
  // The first signal asks the work to stop and interrupts a read that waits for a pipe; the second one ends the
  // program.
  struct sigaction on_stop = {};
  on_stop.sa_handler = [](int) { app::cancel_flag() = true; };
  on_stop.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &on_stop, nullptr);
  sigaction(SIGTERM, &on_stop, nullptr);
  const auto fail = [](const char* what, app::ExitCode code) {
    if (app::cancel_flag()) {
      what = "cancelled";
      code = app::kFailed;
    }
    std::cerr << "seamount: " << what << "\n";
    return static_cast<int>(code);
  };
  try {
    return app::run_program(argc, argv, recipe::standard_registry());
  } catch (const recipe::RecipeError& error) {
    return fail(error.what(), app::kWrongInput);
  } catch (const InvalidArgument& error) {
    return fail(error.what(), app::kWrongInput);
  } catch (const IncompatibleInputs& error) {
    return fail(error.what(), app::kWrongInput);
  } catch (const IoError& error) {
    return fail(error.what(), app::kWrongInput);
  } catch (const std::bad_alloc&) {
    return fail("not enough memory", app::kFailed);
  } catch (const std::exception& error) {
    return fail(error.what(), app::kFailed);
  }
}
