// The functions of elastic_sound.hpp.
#include "chapters/30_elastic_bodies/elastic_sound.hpp"

#include "common/text.hpp"

#include <cmath>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>

namespace rigid {

//! [sound]
template <int Dim>
std::vector<Real> sound_of(const ElasticBody<Dim>& body, int count, int freedom,
                           Real seconds, int rate)
{
    if (freedom < 0 || freedom >= body.x.size())
        throw std::invalid_argument("the freedom to listen to is " +
                                    std::to_string(freedom) + "; there are " +
                                    std::to_string(body.x.size()));
    if (!(seconds > 0) || rate < 1)
        throw std::invalid_argument("a sound of " + shortest(seconds) + " s at " +
                                    std::to_string(rate) +
                                    " samples a second; both must be positive");
    if (!(seconds < 3600) || seconds * rate < 1)
        throw std::invalid_argument("a sound of " + shortest(seconds) + " s at " +
                                    std::to_string(rate) +
                                    " samples a second; it must be of one sample "
                                    "at least, and below 3600 s");
    ModalBody<Dim> modal(body, count);
    const Vibration<Dim>& found = modal.vibration;
    if (found.status != Status::solved)
        throw std::runtime_error("the vibrations of the body have a residual of " +
                                 shortest(found.residual) + " after " +
                                 std::to_string(found.iterations) +
                                 " rounds; a sound needs them solved");
    std::vector<Real> samples(static_cast<std::size_t>(std::floor(seconds * rate)),
                              Real{0});
    for (Index k = 0; k < modal.q.size(); ++k) {
        const Real omega = modal.vibration.omega[k];
        if (omega >= pi * rate) break;  // they ascend
        const Real c = body.mass_damping + body.stiffness_damping * omega * omega;
        for (Real& s : samples) {
            swing(omega, c, 0, Real{1} / rate, modal.q[k], modal.speed[k]);
            s += modal.vibration.shapes(freedom, k) * modal.speed[k];
        }
    }
    return samples;
}
//! [sound]

void write_wave(std::ostream& out, std::span<const Real> samples, int rate)
{
    Real loudest = 0;
    for (const Real s : samples) {
        if (!std::isfinite(s))
            throw std::invalid_argument("a sample of a sound is " + shortest(s) +
                                        "; it must be finite");
        loudest = std::max(loudest, std::abs(s));
    }
    if (samples.empty())
        throw std::invalid_argument("a sound has no samples; it must have one");
    if (rate < 1)
        throw std::invalid_argument("a sound has " + std::to_string(rate) +
                                    " samples a second; it must have one or more");
    const auto put = [&out](std::uint32_t number, int bytes) {
        for (int i = 0; i < bytes; ++i)
            out.put(static_cast<char>(number >> (8 * i) & 0xff));
    };
    const auto size = static_cast<std::uint32_t>(2 * samples.size());
    out << "RIFF";
    put(36 + size, 4);
    out << "WAVEfmt ";
    put(16, 4), put(1, 2), put(1, 2);  // plain numbers, one channel
    put(static_cast<std::uint32_t>(rate), 4);
    put(2 * static_cast<std::uint32_t>(rate), 4);
    put(2, 2), put(16, 2);
    out << "data";
    put(size, 4);
    const Real scale = loudest > 0 ? 0.9 * 32767 / loudest : 0;
    for (const Real s : samples)
        put(static_cast<std::uint32_t>(std::lround(scale * s)) & 0xffff, 2);
}

template std::vector<Real> sound_of(const ElasticBody<1>&, int, int, Real, int);
template std::vector<Real> sound_of(const ElasticBody<2>&, int, int, Real, int);
template std::vector<Real> sound_of(const ElasticBody<3>&, int, int, Real, int);

}  // namespace rigid
