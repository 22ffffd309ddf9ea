/// Chapter 7: Baumgarte and the other ways to repay a position error.

#include "chapters/07_baumgarte/stabilized_step.hpp"
#include "common/program/program.hpp"

int main() {}
