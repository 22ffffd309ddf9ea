// The functions of spectral.hpp.
#include "chapters/29_waves/spectral.hpp"

#include "common/elementary.hpp"

#include <utility>

namespace rigid {
namespace {

void require_sines(const WaveLine& line)
{
    if (line.left != LineEnd::fixed || line.right != LineEnd::fixed)
        throw std::invalid_argument(
            "a spectral step in sines needs both ends of the string fixed");
    for (Index i = 0; i < line.damping.size(); ++i)
        if (line.damping[i] != 0)
            throw std::invalid_argument(
                "damping[" + std::to_string(i) + "] is " +
                shortest(line.damping[i]) +
                " 1/s; a spectral step needs zero: where it "
                "differs from place to place, sines mix");
}

}  // namespace

SineTransform::SineTransform(Index intervals) : N_(intervals)
{
    if (N_ < 2 || (N_ & (N_ - 1)) != 0)
        throw std::invalid_argument(
            "a sine transform of " + std::to_string(N_) +
            " intervals; it must be a power of two, from 2");
    roots_.resize(static_cast<std::size_t>(N_));
    work_.resize(static_cast<std::size_t>(2 * N_));
    for (Index i = 0; i < N_; ++i) {
        const Real angle = pi * static_cast<Real>(i) / static_cast<Real>(N_);
        roots_[static_cast<std::size_t>(i)] = {cos(angle), -sin(angle)};
    }
}

//! [sine_transform]
void SineTransform::apply(VecX& values)
{
    if (values.size() != N_ + 1)
        throw std::invalid_argument(
            "a sine transform of " + std::to_string(N_) + " intervals has " +
            std::to_string(values.size()) + " numbers; it must have one more");
    // the sines of y are the Fourier transform of y and its mirror, −y
    const auto n = static_cast<std::size_t>(2 * N_);
    work_[0] = work_[n / 2] = 0;
    for (std::size_t i = 1; i < n / 2; ++i) {
        work_[i] = values[static_cast<Index>(i)];
        work_[n - i] = -work_[i];
    }
    for (std::size_t i = 1, j = 0; i < n; ++i) {  // places with their bits reversed
        std::size_t bit = n / 2;
        for (; j & bit; bit /= 2) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(work_[i], work_[j]);
    }
    for (std::size_t size = 2; size <= n; size *= 2)
        for (std::size_t first = 0; first < n; first += size)
            for (std::size_t k = 0; k < size / 2; ++k) {
                std::complex<Real>&a = work_[first + k],
                &b = work_[first + k + size / 2];
                // written out: a product of complex numbers looks for infinities
                const std::complex<Real> w = roots_[k * (n / size)];
                const std::complex<Real> turned(
                    w.real() * b.real() - w.imag() * b.imag(),
                    w.real() * b.imag() + w.imag() * b.real());
                b = a - turned;
                a += turned;
            }
    for (Index k = 0; k <= N_; ++k)
        values[k] = -work_[static_cast<std::size_t>(k)].imag() / 2;
    values[0] = values[N_] = 0;
}
//! [sine_transform]

SpectralStep::SpectralStep(const WaveLine& line, Real h, Of of)
    : transform_(line.intervals()), c_(line.c), dx_(line.dx)
{
    require_step(h);
    require_valid(line);
    require_sines(line);
    const Index N = line.intervals();
    cosine_ = sine_ = omega_ = VecX::Zero(N + 1);
    for (Index i = 1; i < N; ++i) {
        const Real k = pi * static_cast<Real>(i) / line.length();
        omega_[i] =
            of == Of::equation ? line.c * k : masses_frequency(k, line.c, line.dx);
        cosine_[i] = cos(omega_[i] * h);
        sine_[i] = sin(omega_[i] * h);
    }
}

//! [spectral_step]
void SpectralStep::step(WaveLine& line)
{
    const Index N = transform_.intervals();
    if (line.v.size() != line.y.size()) require_valid(line);
    if (line.intervals() != N || line.dx != dx_ || line.c != c_)
        throw std::invalid_argument(
            "the string has " + std::to_string(line.intervals()) +
            " intervals of " + shortest(line.dx) + " m and waves of " +
            shortest(line.c) + " m/s; the step was made for " + std::to_string(N) +
            ", " + shortest(dx_) + " m and " + shortest(c_) + " m/s");
    require_sines(line);
    transform_.apply(line.y);
    transform_.apply(line.v);
    for (Index k = 1; k < N; ++k) {  // (29.19)
        const Real a = line.y[k], b = line.v[k];
        const Real back = 2 / static_cast<Real>(N);
        line.y[k] = back * (a * cosine_[k] + b / omega_[k] * sine_[k]);
        line.v[k] = back * (b * cosine_[k] - a * omega_[k] * sine_[k]);
    }
    transform_.apply(line.y);
    transform_.apply(line.v);
}
//! [spectral_step]

}  // namespace rigid
