// The toy as a program of its own, for the tests that need a process: pictures, signals, a window.
#include "tests/program_toy.hpp"

int main(int argc, char** argv) { return rigid::run_program(rigid::toy::program, argc, argv); }
