// seamount: the command line. Commands are in the files beside this one.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "app.h"
#include "seamount/base/large_block.h"

namespace seamount::app {
namespace {

void add_commands(Command program, const recipe::Registry& registry) {
  add_run_command(program, registry);
  add_discover_commands(program, registry);
  add_chore_commands(program);
  add_dataset_command(program);
  add_operator_commands(program, registry);
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
    return app::run_command_line(argc, argv,
                                 [](app::Command program) { app::add_commands(program, recipe::standard_registry()); });
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
