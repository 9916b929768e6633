// seamount: the command line. Commands are in the files beside this one.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "app.h"
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

/// A usage error in one line, with the nearest command where a command was mistyped.
int report_usage(const CLI::App& program, const CLI::ParseError& error, int argc, char** argv) {
  if (error.get_exit_code() == 0) return program.exit(error, std::cout, std::cerr);
  std::string message = error.what();
  if (argc > 1 && argv[1][0] != '-') {
    const std::vector<std::string> names = command_names(program);
    if (std::find(names.begin(), names.end(), argv[1]) == names.end()) {
      message = std::string("unknown command '") + argv[1] + "'" + suggestion(argv[1], names);
    }
  }
  std::cerr << "seamount: " << message << "\n";
  return kWrongInput;
}

int run_program(int argc, char** argv) {
  CLI::App program("Seamount: terrain authoring, from ridgeline to reef", "seamount");
  program.set_version_flag("--version", std::string("seamount ") + kVersion);
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  Work work;
  add_run_command(program, work);
  add_discover_commands(program, work);
  add_chore_commands(program, work);
  add_dataset_command(program, work);
  add_operator_commands(program, work);
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
  using namespace seamount;
  std::signal(SIGINT, [](int) { app::cancel_flag() = true; });
  std::signal(SIGTERM, [](int) { app::cancel_flag() = true; });
  const auto fail = [](const char* what, app::ExitCode code) {
    std::cerr << "seamount: " << what << "\n";
    return static_cast<int>(code);
  };
  try {
    return app::run_program(argc, argv);
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
