// The command line of a program with a kind of value of its own (recipe/test_tune.h).
#include "program.h"
#include "seamount/recipe/test_tune.h"

int main(int argc, char** argv) { return seamount::app::run_program(argc, argv, seamount::recipe::with_tunes()); }
