// The functions of cloth_sleep.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/28_cloth_that_touches/cloth_sleep.hpp"

#include <algorithm>
#include <numeric>

namespace rigid {

namespace cloth_sleep {

template <class Visit>
void each_row(const TouchingCloth& cloth, const Visit& visit)
{
    for (const ClothSpring& s : cloth.springs) visit(std::array{s.a, s.b});
    for (const ClothBend& b : cloth.bends)
        visit(std::array{b.p[0], b.p[1], b.p[2], b.p[3] < 0 ? b.p[2] : b.p[3]});
    for (const ClothHinge& b : cloth.hinges) visit(b.p);
    for (const auto& t : cloth.triangles) visit(t);
}

std::size_t rows_of(const TouchingCloth& cloth)
{
    return cloth.springs.size() + cloth.bends.size() + cloth.hinges.size() +
           cloth.triangles.size();
}

std::array<Real, 11> air_of(const TouchingCloth& cloth)
{
    return {
        cloth.gravity.x(), cloth.gravity.y(),    cloth.gravity.z(),  cloth.wind.x(),
        cloth.wind.y(),    cloth.wind.z(),       cloth.air,          cloth.drag,
        cloth.thickness,   cloth.self_thickness, cloth.self_friction};
}

/// A solid and where it comes to in a step lie in this box, in the world.
SolidBox box_of(const TouchingCloth& cloth, Index k, Real h)
{
    const ClothSolid& s = cloth.shapes[static_cast<std::size_t>(k)];
    const Vec3 all = Vec3::Constant(infinity);
    if (s.shape == ClothSolid::Shape::wall) return {-all, all};
    Real radius = s.half.norm() + s.radius;
    if (s.shape == ClothSolid::Shape::mesh)
        for (const Vec3& p : s.mesh->vertices) radius = std::max(radius, p.norm());
    const Vec3 at = centre_of(cloth.solids.x, k);
    return grown(SolidBox{at, at},
                 radius + 2 * h * cloth.solids.u.segment<3>(6 * k).norm());
}

}  // namespace cloth_sleep

int SleepingCloth::asleep() const
{
    return static_cast<int>(std::count_if(parts_.begin(), parts_.end(),
                                          [](const Part& p) { return p.asleep; }));
}

void SleepingCloth::wake()
{
    for (Part& part : parts_) {
        wakings += part.asleep;
        stale_ = stale_ || part.asleep;
        part.asleep = false, part.rest = 0;
    }
}

//! [parts]
void SleepingCloth::find_parts(const TouchingCloth& cloth)
{
    // triangles had an area when the cloth was made; they need not keep it
    if (changes_ < 0) require_valid(cloth);
    else require_rows(cloth), require_touchable(cloth);
    const auto K = static_cast<std::size_t>(cloth.count());
    std::vector<int> root(K);
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&root](int k) {
        while (root[static_cast<std::size_t>(k)] != k) {
            int& up = root[static_cast<std::size_t>(k)];
            up = root[static_cast<std::size_t>(up)];
            k = up;
        }
        return k;
    };
    const auto moves = [&cloth](int p) {
        return cloth.bodies.inverse_mass[3 * p] > 0;
    };
    cloth_sleep::each_row(cloth, [&](const auto& row) {
        int first = -1;
        for (const int p : row) {
            if (!moves(p)) continue;
            if (first < 0) first = find(p);
            else
                root[static_cast<std::size_t>(std::max(find(p), first))] =
                    std::min(find(p), first),
                                                                first = find(p);
        }
    });
    parts_.clear();
    part_of_.assign(K, -1);
    for (int p = 0; p < cloth.count(); ++p) {
        if (!moves(p)) continue;
        const auto r = static_cast<std::size_t>(find(p));
        if (part_of_[r] < 0) {
            part_of_[r] = parts();
            parts_.emplace_back();
        }
        part_of_[static_cast<std::size_t>(p)] = part_of_[r];
    }
    pins_.assign(parts_.size(), {});
    cloth_sleep::each_row(cloth, [&](const auto& row) {
        for (const int p : row)
            for (const int q : row)
                if (const int k = part_of_[static_cast<std::size_t>(p)];
                    k >= 0 && !moves(q))
                    pins_[static_cast<std::size_t>(k)].push_back(q);
    });
    for (auto& pins : pins_) {
        std::sort(pins.begin(), pins.end());
        pins.erase(std::unique(pins.begin(), pins.end()), pins.end());
    }
    anchor_ = x_ = cloth.bodies.x, f_ = cloth.bodies.f, solids_ = cloth.solids.x;
    air_ = cloth_sleep::air_of(cloth), shapes_ = cloth.shapes;
    changes_ = cloth.changes, rows_ = cloth_sleep::rows_of(cloth);
    stale_ = true;
}
//! [parts]

bool SleepingCloth::near_a_mover(const TouchingCloth& cloth, const Part& part,
                                 Real h) const
{
    const SolidBox around = grown(part.box, 2 * cloth.thickness + still);
    for (Index k = 0; k < cloth.solids.count(); ++k)
        if ((!cloth.solids.u.segment<6>(6 * k).isZero(0) ||
             cloth.solids.inverse_mass[6 * k] > 0 ||
             cloth.solids.x.segment<6>(6 * k) != solids_.segment<6>(6 * k)) &&
            overlap(around, cloth_sleep::box_of(cloth, k, h)))
            return true;
    if (!(cloth.self_thickness > 0)) return false;
    for (const Part& other : parts_)
        if (!other.asleep &&
            overlap(around,
                    grown(other.box, cloth.self_thickness + 2 * h * other.fastest)))
            return true;
    return false;
}

//! [look]
/// What sleeps wakes, if anything that its step depends on has changed.
void SleepingCloth::look(const TouchingCloth& cloth, Real h)
{
    if (cloth.changes != changes_ || cloth_sleep::rows_of(cloth) != rows_ ||
        cloth.bodies.x.size() != x_.size() ||
        cloth.solids.x.size() != solids_.size() ||
        cloth.shapes.size() != shapes_.size())
        find_parts(cloth);
    if (cloth.shapes != shapes_) wake(), shapes_ = cloth.shapes;
    if (cloth_sleep::air_of(cloth) != air_) wake();
    air_ = cloth_sleep::air_of(cloth);
    woken_.assign(parts_.size(), 0);
    const Bodies<3>& bodies = cloth.bodies;
    for (int p = 0; p < cloth.count(); ++p) {
        const int k = part_of_[static_cast<std::size_t>(p)];
        if (k < 0 || !parts_[static_cast<std::size_t>(k)].asleep) continue;
        if (!bodies.u.segment<3>(3 * p).isZero(0) ||
            bodies.x.segment<3>(3 * p) != x_.segment<3>(3 * p) ||
            bodies.f.segment<3>(3 * p) != f_.segment<3>(3 * p))
            woken_[static_cast<std::size_t>(k)] = 1;
    }
    for (bool again = true; again;) {
        again = false;
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            Part& part = parts_[k];
            if (!part.asleep) continue;
            bool wakes = woken_[k] || near_a_mover(cloth, part, h);
            for (const int q : pins_[k])
                wakes = wakes || !bodies.u.segment<3>(3 * q).isZero(0) ||
                        bodies.x.segment<3>(3 * q) != x_.segment<3>(3 * q);
            if (!wakes) continue;
            part.asleep = false, part.rest = 0;
            stale_ = again = true;
            ++wakings;
        }
    }
}
//! [look]

/// The awake parts as a scene of their own, and the pins.
void SleepingCloth::gather(const TouchingCloth& cloth)
{
    const Bodies<3>& all = cloth.bodies;
    if (stale_) {
        particles_.clear();
        std::vector<int> name(part_of_.size(), -1);
        for (int p = 0; p < cloth.count(); ++p)
            if (!asleep(p)) {
                name[static_cast<std::size_t>(p)] =
                    static_cast<int>(particles_.size());
                particles_.push_back(p);
            }
        const int changes = awake_.changes + 1;
        awake_ = TouchingCloth{};
        awake_.changes = changes;
        awake_.bodies.resize(static_cast<Index>(particles_.size()));
        if (cloth.made_at.size() == part_of_.size())
            for (const int p : particles_)
                awake_.made_at.push_back(
                    cloth.made_at[static_cast<std::size_t>(p)]);
        const auto named = [&](auto& row) {
            for (int& p : row)
                if (p >= 0) p = name[static_cast<std::size_t>(p)];
        };
        const auto is_awake = [&](const auto& row) {
            bool any = false;
            for (const int p : row) {
                if (p >= 0 && asleep(p)) return false;
                any = any || (p >= 0 && part_of_[static_cast<std::size_t>(p)] >= 0);
            }
            return any;
        };
        for (ClothSpring s : cloth.springs) {
            std::array row{s.a, s.b};
            if (!is_awake(row)) continue;
            named(row);
            s.a = row[0], s.b = row[1];
            awake_.springs.push_back(s);
        }
        const auto take = [&](const auto& from, auto& to) {
            for (auto row : from)
                if (is_awake(row.p)) named(row.p), to.push_back(row);
        };
        take(cloth.bends, awake_.bends);
        take(cloth.hinges, awake_.hinges);
        for (auto t : cloth.triangles)
            if (is_awake(t)) named(t), awake_.triangles.push_back(t);
        stale_ = false;
    }
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        const Index to = 3 * static_cast<Index>(i), from = 3 * particles_[i];
        awake_.bodies.x.segment<3>(to) = all.x.segment<3>(from);
        awake_.bodies.u.segment<3>(to) = all.u.segment<3>(from);
        awake_.bodies.f.segment<3>(to) = all.f.segment<3>(from);
        awake_.bodies.inverse_mass.segment<3>(to) =
            all.inverse_mass.segment<3>(from);
    }
    awake_.solids = cloth.solids, awake_.shapes = cloth.shapes;
    awake_.gravity = cloth.gravity, awake_.wind = cloth.wind;
    awake_.air = cloth.air, awake_.drag = cloth.drag;
    awake_.thickness = cloth.thickness;
    awake_.self_thickness = cloth.self_thickness;
    awake_.self_friction = cloth.self_friction;
}

//! [give_back]
void SleepingCloth::give_back(TouchingCloth& cloth, const ClothSettings& settings)
{
    for (Part& part : parts_)
        if (!part.asleep)
            part.box = SolidBox{}, part.fastest = 0, part.held = false;
    for (const ClothContact& c : memory.touch.contacts)
        if (const int k = part_of_[static_cast<std::size_t>(
                particles_[static_cast<std::size_t>(c.particle)])];
            k >= 0 && cloth.solids.inverse_mass[6 * c.solid] > 0)
            parts_[static_cast<std::size_t>(k)].held = true;
    cloth.solids = awake_.solids;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        const Index from = 3 * static_cast<Index>(i);
        const int p = particles_[i];
        cloth.bodies.position(p) = awake_.bodies.x.segment<3>(from);
        cloth.bodies.velocity(p) = awake_.bodies.u.segment<3>(from);
        const int k = part_of_[static_cast<std::size_t>(p)];
        if (k < 0) continue;
        Part& part = parts_[static_cast<std::size_t>(k)];
        const Vec3 x = cloth.bodies.position(p);
        part.box = joined(part.box, {x, x});
        part.fastest = std::max(part.fastest, cloth.bodies.velocity(p).norm());
        if ((x - anchor_.segment<3>(3 * p)).squaredNorm() > still * still)
            part.rest = -infinity;  // until its anchors are set again below
    }
    for (std::size_t k = 0; k < parts_.size(); ++k)  // triangles reach to pins
        for (const int q : pins_[k])
            if (Part& part = parts_[k]; !part.asleep) {
                const Vec3 x = cloth.bodies.position(q);
                part.box = joined(part.box, {x, x});
                part.fastest =
                    std::max(part.fastest, cloth.bodies.velocity(q).norm());
            }
    for (Part& part : parts_)
        if (!part.asleep && !part.held) part.rest += settings.h;
    for (int p = 0; p < cloth.count(); ++p) {
        const int k = part_of_[static_cast<std::size_t>(p)];
        if (k < 0) continue;
        const Part& part = parts_[static_cast<std::size_t>(k)];
        if (part.rest < 0)
            anchor_.segment<3>(3 * p) = cloth.bodies.x.segment<3>(3 * p);
        if (!part.asleep && part.rest >= time) cloth.bodies.velocity(p).setZero();
    }
    for (Part& part : parts_) {
        part.rest = std::max(part.rest, Real{0});
        if (part.asleep || part.rest < time || part.held) continue;
        part.asleep = stale_ = true;
        ++sleeps;
    }
    x_ = cloth.bodies.x, f_ = cloth.bodies.f, solids_ = cloth.solids.x;
}
//! [give_back]

void SleepingCloth::step(TouchingCloth& cloth, const ClothSettings& settings)
{
    require_valid(settings);
    if (!(still >= 0 && still < infinity))  // a sentence asks for memory
        require_not_negative(still, "the way of a cloth that counts as still");
    if (!(time >= 0))
        throw std::invalid_argument("the time after which a cloth sleeps is " +
                                    shortest(time) +
                                    " s; it must be zero or positive");
    if (settings.strength < infinity)
        throw std::invalid_argument("the strength of a cloth that may sleep is " +
                                    shortest(settings.strength) +
                                    "; it must be infinite: what tears changes "
                                    "rows while parts are left out");
    if (!cloth.ties.empty())
        throw std::invalid_argument(
            "a cloth that may sleep has " + std::to_string(cloth.ties.size()) +
            " ties; it must have none: what they hold is not left out");
    look(cloth, settings.h);
    gather(cloth);
    rigid::step(awake_, settings, memory);
    skipped += cloth.count() - static_cast<int>(particles_.size());
    give_back(cloth, settings);
}

}  // namespace rigid
