/// \file catch.hpp
/// Catch2 by one name: version 3 has catch_all.hpp, version 2 has catch.hpp.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
