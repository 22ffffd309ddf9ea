/// \file order.hpp
/// With which power an error shrinks.
#pragma once

#include "common/math.hpp"

#include <cmath>
#include <vector>

/// The slope of log y over log x, by least squares.
inline rigid::Real slope(const std::vector<rigid::Real>& x, const std::vector<rigid::Real>& y)
{
    rigid::Real sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const rigid::Real a = std::log(x[i]), b = std::log(y[i]);
        sx += a, sy += b, sxx += a * a, sxy += a * b;
    }
    const auto n = static_cast<rigid::Real>(x.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// p with which errors at h, h/2, h/4, … shrink as h^p: the mean from one halving to the next.
inline rigid::Real order_of(const std::vector<rigid::Real>& errors)
{
    return std::log2(std::abs(errors.front() / errors.back())) / static_cast<rigid::Real>(errors.size() - 1);
}
