// The functions of water_field.hpp.
#include "chapters/29_waves/water_field.hpp"

#include "chapters/29_waves/water_faces.hpp"

#include <algorithm>
#include <array>

namespace rigid {

namespace {

void require_cells(const WaterField& water)
{
    if (water.nx < 1 || water.ny < 1)
        throw std::invalid_argument("the water has " + std::to_string(water.nx) +
                                    " by " + std::to_string(water.ny) +
                                    " cells; it must have one or more each way");
}

}  // namespace

WaterField::WaterField(Index nx_, Index ny_, Real width, Real still_depth)
    : nx(nx_), ny(ny_), dx(width)
{
    require_cells(*this);
    if (!(still_depth >= 0) || !std::isfinite(still_depth))
        throw std::invalid_argument("the depth of the water is " +
                                    shortest(still_depth) +
                                    " m; it must be zero or positive and finite");
    bed = VecX::Zero(nx * ny);
    depth = VecX::Constant(nx * ny, still_depth);
    u = VecX::Zero((nx + 1) * ny);
    v = VecX::Zero(nx * (ny + 1));
    require_valid(*this);
}

void require_valid(const WaterField& water)
{
    require_cells(water);
    require_positive("the width of a cell", water.dx, " m");
    require_positive("gravity", water.g, " m/s²");
    require_positive("the density of the water", water.density, " kg/m³");
    const Index nx = water.nx, ny = water.ny;
    const auto sized = [nx, ny](const VecX& list, Index wanted, const char* name) {
        if (list.size() != wanted)
            throw std::invalid_argument(
                std::string(name) + " has " + std::to_string(list.size()) +
                " entries; water of " + std::to_string(nx) + " by " +
                std::to_string(ny) + " cells needs " + std::to_string(wanted));
        require_finite(list, name);
    };
    sized(water.bed, nx * ny, "bed");
    sized(water.depth, nx * ny, "depth");
    sized(water.u, (nx + 1) * ny, "u");
    sized(water.v, nx * (ny + 1), "v");
    for (Index k = 0; k < nx * ny; ++k)
        if (water.depth[k] < 0)
            throw std::invalid_argument("depth[" + std::to_string(k) + "] is " +
                                        shortest(water.depth[k]) +
                                        " m; it must be zero or positive");
}

Real volume(const WaterField& water)
{
    Real sum = 0;
    for (Index k = 0; k < water.depth.size(); ++k) sum += water.depth[k];
    return sum * water.dx * water.dx;
}

namespace {

/// Calls visit(velocity, cell, cell) for each face between two cells.
template <class Velocities, class Visit>
void for_each_face(Velocities& u, Velocities& v, Index nx, Index ny,
                   const Visit& visit)
{
    for (Index j = 0; j < ny; ++j)
        for (Index i = 0; i < nx; ++i) {
            const Index k = j * nx + i;
            if (i > 0) visit(u[j * (nx + 1) + i], k - 1, k, 0);
            if (j > 0) visit(v[k], k - nx, k, 1);
        }
}

}  // namespace

Vec2 momentum(const WaterField& water)
{
    Vec2 sum(0, 0);
    for_each_face(water.u, water.v, water.nx, water.ny,
                  [&](Real speed, Index l, Index r, int along) {
                      sum[along] += (water.depth[l] + water.depth[r]) / 2 * speed;
                  });
    return water.density * water.dx * water.dx * sum;
}

Real energy(const WaterField& water)
{
    Real kinetic = 0, potential = 0;
    for_each_face(water.u, water.v, water.nx, water.ny,
                  [&](Real speed, Index l, Index r, int) {
                      kinetic +=
                          (water.depth[l] + water.depth[r]) / 2 * speed * speed;
                  });
    for (Index k = 0; k < water.depth.size(); ++k)
        potential += water.depth[k] * (water.depth[k] + 2 * water.bed[k]);
    return water.density * water.dx * water.dx * (kinetic + water.g * potential) /
           2;
}

Real stable_step(const WaterField& water)
{
    const Index nx = water.nx;
    Real fastest = 0;
    for (Index j = 0; j < water.ny; ++j) {
        const auto u = water.u.segment(j * (nx + 1), nx + 1).array().abs();
        const auto speed =
            u.head(nx).max(u.tail(nx)) +
            water.v.segment(j * nx, nx)
                .array()
                .abs()
                .max(water.v.segment((j + 1) * nx, nx).array().abs()) +
            (2 * water.g * water.depth.segment(j * nx, nx).array()).sqrt();
        fastest = std::max(fastest, speed.maxCoeff());
    }
    return water.dx / fastest;
}

namespace {

/// As of a row of columns (shallow_water.cpp).
void require_fits(WaterField& water, Real h)
{
    const Index cells = water.nx * water.ny;
    const bool sized =
        water.looked_at && water.nx > 0 && water.ny > 0 && water.dx > 0 &&
        water.g > 0 && water.bed.size() == cells && water.depth.size() == cells &&
        water.u.size() == cells + water.ny && water.v.size() == cells + water.nx;
    if (!sized) require_valid(water);
    water.looked_at = true;
    const Real fastest = largest(water.u, -infinity) + largest(water.v, -infinity) +
                         std::sqrt(2 * water.g * largest(water.depth, 0));
    if (h * fastest <= water.dx) return;
    if (!(fastest < infinity)) require_valid(water);
    require_shorter(h, stable_step(water));
}

/// The stages of a step, each for one row. Of what a stage hands on the last four rows are
/// kept; that they lie in the cache is why the memory is gone over once.
class FieldStep {
public:
    FieldStep(WaterField& water, Real h)
        : nx_(water.nx), ny_(water.ny), h_(h), lambda_(h / water.dx),
          gain_(h * water.g / water.dx), bed_(water.bed.data()),
          depth_(water.depth.data()), u_(water.u.data()), v_(water.v.data())
    {
        const Index width = nx_ + 1;
        water.rows.resize(35 * width);
        Real* next = water.rows.data();
        for (Rows* const kept :
             {&level_, &give_, &qx_, &qy_, &turned_, &rising_, &Pu_, &Pv_})
            for (Real*& row : *kept) row = next, next += width;
        middle_ = next, corner_ = next + width, ones_ = next + 2 * width;
        std::fill_n(ones_, width, Real{1});
    }

    //! [row]
    /// A row is pushed, and those below it, which have all they need by now, go on.
    void row(Index j)
    {
        if (j < ny_) push(j);
        if (j >= 1 && j <= ny_ + 1) flow(j - 1);
        if (j >= 2 && j <= ny_ + 1) carry(j - 2);
        if (j >= 3) fill(j - 3);
    }
    //! [row]

private:
    using Rows = std::array<Real*, 4>;
    static Real* of(const Rows& kept, Index j)
    {
        return kept[static_cast<std::size_t>(j & 3)];
    }
    Real* depth(Index j) const { return depth_ + j * nx_; }
    Real* u(Index j) const { return u_ + j * (nx_ + 1); }
    Real* v(Index j) const { return v_ + j * nx_; }  ///< of the faces below row j
    CellRow cells(Index j) const
    {
        return {bed_ + j * nx_, depth(j), of(level_, j)};
    }

    /// (29.11): slopes push the faces within a row, and those below it.
    void push(Index j)
    {
        const CellRow here = cells(j);
        Real* __restrict level = of(level_, j);
        for (Index i = 0; i < nx_; ++i) level[i] = here.bed[i] + here.depth[i];
        push_faces<false>(nx_ - 1, here,
                          {here.bed + 1, here.depth + 1, here.level + 1}, gain_,
                          ones_, h_, nullptr, u(j) + 1);
        if (j > 0)
            push_faces<false>(nx_, cells(j - 1), here, gain_, ones_, h_, nullptr,
                              v(j));
    }

    static void flows(Index count, const Real* speed, const Real* before,
                      const Real* behind, Real* __restrict q)
    {
        for (Index f = 0; f < count; ++f)
            q[f] = flow_through(speed[f], before[f], behind[f]);
    }

    /// What flows through the faces within a row, and through those below it. No cell
    /// gives more through its four than it has.
    void flow(Index j)
    {
        if (j < ny_) {
            const Real *const s = u(j), *const r = depth(j), *const below = v(j),
                              *const above = v(j + 1);
            Real* __restrict give = of(give_, j);
            for (Index i = 0; i < nx_; ++i) {
                const Real parting =
                    lambda_ * ((outwards(s[i + 1]) + outwards(-s[i])) +
                               (outwards(above[i]) + outwards(-below[i])));
                give[i] = parting > 1 ? parting : 1;
            }
            if (Eigen::Map<const VecX>(give, nx_).maxCoeff() > 1)
                for (Index i = 0; i < nx_; ++i) give[i] = r[i] / give[i];
            else
                for (Index i = 0; i < nx_; ++i) give[i] = r[i];
            Real* const q = of(qx_, j);
            flows(1, s, give, give, q);  // through a wall that moves
            flows(nx_ - 1, s + 1, give, give + 1, q + 1);
            flows(1, s + nx_, give + nx_ - 1, give + nx_ - 1, q + nx_);
        }
        flows(nx_, v(j), of(give_, j > 0 ? j - 1 : 0),
              of(give_, j < ny_ ? j : ny_ - 1), of(qy_, j));
    }

    /// The mean of two flows, and what of a velocity they carry with them.
    static void carried(Index count, const Real* q, const Real* other,
                        const Real* before, const Real* behind,
                        Real* __restrict out)
    {
        for (Index i = 0; i < count; ++i)
            out[i] = carried_by((q[i] + other[i]) / 2, before[i], behind[i]);
    }

    /// The momentum at a face when flows have carried theirs away on all four sides.
    struct Through {
        const Real *in, *out;
    };
    void remains(Index count, const Real* before, const Real* behind,
                 const Real* speed, Through along, Through across,
                 Real* __restrict P) const
    {
        for (Index f = 0; f < count; ++f)
            P[f] = (before[f] + behind[f]) / 2 * speed[f] -
                   lambda_ * ((along.out[f] - along.in[f]) +
                              (across.out[f] - across.in[f]));
    }

    //! [carry]
    /// (29.24) for the faces within row j, and for those below it. Momentum along x passes
    /// the middles of cells (`middle`) and their corners (`turned`); that along y the
    /// middles (`rising`) and the corners (`corner`).
    void carry(Index j)
    {
        const Real *const s = u(j), *const up = j + 1 < ny_ ? u(j + 1) : s,
                          *const w = v(j), *const r = depth(j),
                          *const qx = of(qx_, j), *const qy = of(qy_, j),
                          *const qy_above = of(qy_, j + 1);
        if (j == 0) carried(nx_ - 1, qy, qy + 1, s + 1, s + 1, of(turned_, 0) + 1);
        carried(nx_ - 1, qy_above, qy_above + 1, s + 1, up + 1,
                of(turned_, j + 1) + 1);
        carried(nx_, qx, qx + 1, s, s + 1, middle_);
        remains(nx_ - 1, r, r + 1, s + 1, {middle_, middle_ + 1},
                {of(turned_, j) + 1, of(turned_, j + 1) + 1}, of(Pu_, j) + 1);

        carried(nx_, qy, qy_above, w, v(j + 1), of(rising_, j));
        if (j == 0) return;
        const Real* const q = of(qx_, j - 1);
        carried(1, q, qx, w, w, corner_);
        carried(nx_ - 1, q + 1, qx + 1, w, w + 1, corner_ + 1);
        carried(1, q + nx_, qx + nx_, w + nx_ - 1, w + nx_ - 1, corner_ + nx_);
        remains(nx_, depth(j - 1), r, w, {of(rising_, j - 1), of(rising_, j)},
                {corner_, corner_ + 1}, of(Pv_, j));
    }
    //! [carry]

    //! [fill]
    /// (29.23), and velocities from their momenta.
    void fill(Index j)
    {
        const Real *const qx = of(qx_, j), *const qy = of(qy_, j),
                          *const qy_above = of(qy_, j + 1), *const Pu = of(Pu_, j),
                          *const Pv = of(Pv_, j);
        Real* __restrict r = depth(j), * __restrict s = u(j), * __restrict w = v(j);
        for (Index i = 0; i < nx_; ++i) {
            const Real left =
                r[i] - lambda_ * ((qx[i + 1] - qx[i]) + (qy_above[i] - qy[i]));
            r[i] = left > 0 ? left : 0;
        }
        for (Index f = 1; f < nx_; ++f) s[f] = velocity_of(Pu[f], r[f - 1], r[f]);
        if (j == 0) return;
        const Real* const below = depth(j - 1);
        for (Index i = 0; i < nx_; ++i) w[i] = velocity_of(Pv[i], below[i], r[i]);
    }
    //! [fill]

    Index nx_, ny_;
    Real h_, lambda_, gain_;
    const Real* bed_;
    Real *depth_, *u_, *v_;
    Rows level_{}, give_{}, qx_{}, qy_{}, turned_{}, rising_{}, Pu_{}, Pv_{};
    Real *middle_ = nullptr, *corner_ = nullptr, *ones_ = nullptr;
};

}  // namespace

void step(WaterField& water, Real h)
{
    require_step(h);
    require_fits(water, h);
    FieldStep stages(water, h);
    for (Index j = 0; j < water.ny + 3; ++j) stages.row(j);
}

void press(WaterField& water, const Vec2& place, Real radius, Real head, Real h)
{
    require_step(h);
    if (!(radius > 0) || !std::isfinite(radius) || !std::isfinite(head) ||
        !place.allFinite())
        throw std::invalid_argument(
            "the water is pressed at (" + shortest(place.x()) + ", " +
            shortest(place.y()) + ") m within " + shortest(radius) +
            " m by a column of " + shortest(head) +
            " m; they must be finite, the radius positive");
    const auto pressure = [&](Index k) {
        const Vec2 off = water.middle_of(k % water.nx, k / water.nx) - place;
        const Real near = std::max(0.0, 1 - off.squaredNorm() / (radius * radius));
        return head * near * near;
    };
    const Real gain = h * water.g / water.dx;
    for_each_face(water.u, water.v, water.nx, water.ny,
                  [&](Real& speed, Index l, Index r, int) {
                      if ((water.depth[l] + water.depth[r]) / 2 > dry_depth)
                          speed -= gain * (pressure(r) - pressure(l));
                  });
}

}  // namespace rigid
