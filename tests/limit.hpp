/// \file limit.hpp
/// No loop of a test runs forever, whatever the code that it tests has become.
#pragma once

#include "tests/catch.hpp"

/// `for (Limit rounds(1000); not_yet() && rounds.left();)` fails the test instead of making round 1001.
class Limit {
public:
    explicit Limit(long rounds) : rounds_(rounds) {}

    bool left()
    {
        if (--rounds_ < 0) FAIL("a loop of this test goes on and on");
        return true;
    }

private:
    long rounds_;
};
