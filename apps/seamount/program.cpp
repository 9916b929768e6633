#include "program.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>

#include "app.h"
#include "seamount/base/large_block.h"
#include "seamount/base/printable.h"
#include "train_command.h"

namespace seamount::app {
namespace {

void add_commands(Command program, const recipe::Registry& registry) {
  add_run_command(program, registry);
  add_studio_command(program, registry);
  add_discover_commands(program, registry);
  add_chore_commands(program, registry);
  add_dataset_command(program);
  add_train_command(program);
  add_operator_commands(program, registry);
}

/// Signals that end a program ask the work to stop, which removes what is unfinished, and interrupt a read that waits
/// for a pipe; the second one of a kind ends the program. What was ignored on purpose (nohup) stays so. A closed pipe
/// and a limit of file size are errors of a write.
void handle_signals() {
  struct sigaction on_stop = {};
  on_stop.sa_handler = [](int) { cancel_flag() = true; };
  on_stop.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &on_stop, nullptr);
  }
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

/// Where an error cannot even be thrown any more: memory that ran out in a destructor, say.
[[noreturn]] void end_at_once() {
  constexpr std::string_view kMessage = "seamount: not enough memory, or a mistake of this program\n";
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
  ::_exit(kFailed);
}

int fail(std::string_view what, ExitCode code) noexcept {
  if (cancel_flag()) {
    what = "cancelled";
    code = kFailed;
  }
  std::cout.flush();
  for (size_t begin = 0; begin <= what.size();) {  // a recipe's defects are a line each
    const size_t end = std::min(what.find('\n', begin), what.size());
    print_message((begin == 0 ? "seamount: " : "") + std::string(what.substr(begin, end - begin)));
    begin = end + 1;
  }
  return code;
}

/// What was printed has arrived, or the work failed.
int finish_printing(int code) {
  std::cout.flush();
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
  return written ? code : fail("the standard output cannot be written", kFailed);
}

}  // namespace

int run_program(int argc, char** argv, const recipe::Registry& registry) {
  keep_freed_memory();
  std::set_terminate(end_at_once);
  handle_signals();
  try {
    return finish_printing(run_command_line(argc, argv, [&](Command program) { add_commands(program, registry); }));
  } catch (const recipe::RecipeError& error) {
    return fail(error.what(), kWrongInput);
  } catch (const InvalidArgument& error) {
    return fail(printable(error.what()), kWrongInput);
  } catch (const IncompatibleInputs& error) {
    return fail(printable(error.what()), kWrongInput);
  } catch (const WriteError& error) {
    return fail(printable(error.what()), kFailed);
  } catch (const IoError& error) {
    return fail(printable(error.what()), kWrongInput);
  } catch (const std::bad_alloc&) {
    return fail("not enough memory", kFailed);
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(printable(error.what()), kFailed);
  } catch (const std::system_error&) {  // what fmt::print() throws
    return fail("the standard output cannot be written", kFailed);
  } catch (const std::exception& error) {
    return fail(printable(error.what()), kFailed);
  }
}

}  // namespace seamount::app
