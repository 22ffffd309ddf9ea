/// \file mutant.hpp
/// Which fault a test run is to have: the number in the environment variable RIGID_MUTANT, 0 for none.
/// run.py puts it in front of every source of its copy of the book; the book itself does not know it.
#pragma once

#include <cstdlib>

inline const int rigid_chosen_mutant =
    std::getenv("RIGID_MUTANT") != nullptr ? std::atoi(std::getenv("RIGID_MUTANT")) : 0;

inline bool rigid_mutant(int number) { return rigid_chosen_mutant == number; }
