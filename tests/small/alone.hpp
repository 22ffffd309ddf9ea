/// \file alone.hpp
/// What the small programs include, so that each can be included whole in a namespace of its own, with another name
/// for its main():
///
///     #define main small_main
///     namespace small04 {
///     #include "chapters/04_pgs/small.cpp"
///     }
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// main() ends without a return, which is right for that name alone; it is not called here. Warnings are those of the
// tests "small: … alone", which compile each as a reader does.
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wreturn-type"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#endif
