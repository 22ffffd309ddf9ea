/// Chapter 30: elastic bodies of tetrahedra on walls, grounds of triangles and rigid bodies; what is heard of a bar.

#include "tests/no_allocation.hpp"
// first: it counts what Eigen asks for

#include "tests/catch.hpp"
#include "tests/sentence.hpp"

#include "chapters/25_world_in_space/mesh_scenes.hpp"
#include "chapters/30_elastic_bodies/elastic_space_scenes.hpp"
#include "chapters/30_elastic_bodies/vibration.hpp"
#include "common/random.hpp"

using namespace rigid;

namespace {

/// A block of rubber of 0.4 m × 0.2 m × 0.3 m, its lower face at the height `low`.
ElasticBody<3> block(StrainLaw law, Real low = 0, Real young = 5e4)
{
    return {block_mesh({-0.2, low, -0.15}, {0.4, 0.2, 0.3}, 4, 2, 3),
            {.young = young, .poisson = 0.3, .law = law}};
}

Vec3 momentum_of(const ElasticBody<3>& body)
{
    VecX p;
    body.model.multiply_mass(body.v, p);
    Vec3 sum(0, 0, 0);
    for (int i = 0; i < body.model.nodes(); ++i) sum += p.segment<3>(3 * i);
    return sum;
}

Vec3 velocity_of(const ElasticBody<3>& body) { return momentum_of(body) / body.model.mass(); }

Real energy_of(const ElasticSpace& scene)
{
    const ElasticBody<3>& body = scene.elastic;
    return body.kinetic_energy() + body.elastic_energy() + body.potential_energy() + energy(scene);
}

/// The deepest that a surface node is below the plane y = 0, less the skin [m].
Real lowest(const ElasticSpace& scene)
{
    Real least = infinity;
    for (int i = 0; i < scene.elastic.model.nodes(); ++i)
        least = std::min(least, scene.elastic.at(i).y() - scene.skin);
    return least;
}

/// Turns a scene about a point of the world: where all of it is, its walls and its weight.
void turn(ElasticSpace& scene, const Mat3& R)
{
    ElasticBody<3>& body = scene.elastic;
    for (int i = 0; i < body.model.nodes(); ++i) {
        body.x.segment<3>(3 * i) = R * Vec3(body.x.segment<3>(3 * i));
        body.v.segment<3>(3 * i) = R * Vec3(body.v.segment<3>(3 * i));
    }
    body.gravity = R * body.gravity, scene.gravity = R * scene.gravity;
    for (SolidWall& wall : scene.walls) wall.normal = R * wall.normal;
}

}  // namespace

TEST_CASE("the surface of a mesh is closed and looks outward", "[house]")
{
    for (ElasticMesh<3> mesh : {block_mesh({0, 0, 0}, {1, 2, 3}, 2, 3, 2), ball_mesh({0, 0, 0}, 1, 1, 2)})
        for (int order = 1; order <= 2; ++order) {
            if (order == 2) mesh = quadratic(mesh);
            require_valid(mesh);
            Real inside = 0, volume = 0;
            for (int e = 0; e < mesh.count(); ++e) inside += measure_of(mesh, e);
            Vec3 area(0, 0, 0);
            for (const auto& [a, b, c] : surface_triangles(mesh)) {
                area += cross(mesh.at(b) - mesh.at(a), mesh.at(c) - mesh.at(a)) / 2;
                volume += Vec3(mesh.at(a)).dot(cross(mesh.at(b), mesh.at(c))) / 6;  // Gauss
            }
            CHECK(volume == Approx(inside).epsilon(1e-12));
            CHECK(area.norm() < 1e-12);
        }
}

TEST_CASE("a cantilever of quadratic tetrahedra sags and swings as a beam", "[idea]")
{
    const Real d = 0.1, E = 1e6, rho = 1000, g = 0.01;
    const ElasticMesh<3> mesh = quadratic(block_mesh({0, 0, 0}, {1, d, d}, 12, 1, 1));
    ElasticBody<3> body(mesh, {.young = E, .poisson = 0, .density = rho, .law = StrainLaw::linear});
    int tip = 0;
    for (int i = 0; i < mesh.nodes(); ++i) {
        if (mesh.at(i).x() < 1e-9) body.hold(i);
        if ((mesh.at(i) - Vec3(1, d / 2, d / 2)).norm() < 1e-9) tip = i;
    }
    REQUIRE(tip > 0);
    body.gravity = {0, -g, 0};
    ElasticSolver<3> solver;
    solver.rest(body);
    REQUIRE(solver.report.status == Status::solved);
    // q L⁴/8EI + (6/5) q L²/2GA, q = ρ g A, G = E/2; the mesh is a little stiffer
    const Real bent = rho * g * d * d / (8 * E * d * d * d * d / 12), sheared = 1.2 * rho * g / E;
    CHECK(-body.at(tip).y() + mesh.at(tip).y() == Approx(bent + sheared).epsilon(0.01));
    const Vibration<3> found = vibrations_of(body, 4);
    REQUIRE(found.status == Status::solved);
    const Real betas[] = {1.875104068711961, 4.694091132974175};
    for (int k = 0; k < 2; ++k) {
        const Real omega = betas[k] * betas[k] * std::sqrt(E * d * d / 12 / rho);
        // each in two directions; turning and shear lower it by (βd)²·3.4/24, by Timoshenko
        const Real lower = betas[k] * betas[k] * d * d * 3.4 / 24;
        for (const int i : {2 * k, 2 * k + 1})
            CHECK(found.omega[i] == Approx(omega * (1 - lower)).epsilon(0.3 * lower + 0.01));
    }
}

TEST_CASE("discs of friction in a full matrix obey Coulomb's law", "[idea]")
{
    // rows of random bodies: A = Σ rows of a random matrix, definite; the answer by its own law, row by row
    Random random(3);
    for (int round = 0; round < 60; ++round) {
        const std::size_t contacts = 1 + static_cast<std::size_t>(round % 5), m = 3 * contacts;
        DenseCones problem;
        problem.begin(m);
        // fewer columns than rows in every third: A is singular then, as of a box on four corners
        const std::size_t columns = round % 3 == 0 ? m - contacts : m + 2;
        std::vector<Real> B(m * columns);
        for (Real& b : B) b = random.uniform(-1, 1);
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t j = 0; j < m; ++j) {
                Real sum = 0;
                for (std::size_t k = 0; k < columns; ++k) sum += B[i * columns + k] * B[j * columns + k];
                problem.A[i * m + j] = sum;
            }
        VecX speed(static_cast<Index>(columns));
        for (Index k = 0; k < speed.size(); ++k) speed[k] = random.uniform(-1, 1);
        const Real mu = 0.2 + 0.2 * static_cast<Real>(round % 4);
        for (std::size_t i = 0; i < m; ++i) {
            Real sum = 0;  // q = B u: an answer is there
            for (std::size_t k = 0; k < columns; ++k)
                sum += B[i * columns + k] * speed[static_cast<Index>(k)];
            problem.q[static_cast<Index>(i)] = sum;
            if (i % 3 == 0) problem.rows[i].lo = 0;
            else {
                problem.feedback[i].friction = mu;
                problem.feedback[i].bounding = -static_cast<int>(i % 3);
            }
        }
        Solution found;
        problem.solve(1e-10, false, found);
        REQUIRE(found.status == Status::solved);
        for (std::size_t c = 0; c < contacts; ++c) {
            Vec3 w;
            for (std::size_t i = 0; i < 3; ++i) {
                w[static_cast<Index>(i)] = problem.q[static_cast<Index>(3 * c + i)];
                for (std::size_t j = 0; j < m; ++j)
                    w[static_cast<Index>(i)] +=
                        problem.A[(3 * c + i) * m + j] * found.lambda[static_cast<Index>(j)];
            }
            const Vec3 lambda = found.lambda.segment<3>(static_cast<Index>(3 * c));
            const Real slip = w.tail<2>().norm(), drag = lambda.tail<2>().norm();
            // within what the residual of 1e-10 leaves, times λ and w of up to some tens
            CHECK(lambda[0] >= 0);
            CHECK(w[0] > -1e-8);
            CHECK(lambda[0] * w[0] < 1e-7);
            CHECK(drag <= mu * lambda[0] * (1 + 1e-8) + 1e-10);
            if (slip > 1e-6 && lambda[0] > 1e-6) {
                CHECK(drag == Approx(mu * lambda[0]).epsilon(1e-6));
                CHECK(Vec2(lambda.tail<2>()).dot(Vec2(w.tail<2>())) == Approx(-slip * drag).epsilon(1e-6));
            }
        }
    }
}

TEST_CASE("a box on a soft block in space presses it by m g H over E A", "[idea]")
{
    // ν = 0 and no weight of its own: a column under pressure is a bar
    ElasticSpace scene(ElasticBody<3>(block_mesh({-0.2, 0, -0.2}, {0.4, 0.5, 0.4}, 2, 3, 2),
                                      {.young = 2e4, .poisson = 0, .law = StrainLaw::linear}));
    for (int i = 0; i < scene.elastic.model.nodes(); ++i)
        if (scene.elastic.at(i).y() < 1e-9) scene.elastic.hold(i);
    scene.elastic.stiffness_damping = 0.05;
    const Real start = 0.5 + scene.skin + 0.1;  // a plate that is wider than the column
    add_body(scene, {solid_box({0.5, 0.2, 0.5})}, 10 / 0.05, {0, start, 0});
    ElasticSolids contacts;
    for (int n = 0; n < 300; ++n) contacts.step(scene, 1.0 / 60);
    CHECK(contacts.report.status == Status::solved);
    const Real sunk = 10 * 9.81 * 0.5 / (2e4 * 0.16);
    // what the pushing out of overlaps leaves is less than a part in two hundred
    CHECK(start - scene.bodies.x[1] == Approx(sunk).epsilon(5e-3));
    Real weight = 0;
    for (std::size_t i = 0; i < contacts.rows.size(); ++i)
        if (contacts.rows[i].rigid.bounded_by < 0)
            weight += contacts.solution.lambda[static_cast<Index>(i)] * 60;
    CHECK(weight == Approx(98.1).epsilon(1e-3));
}

TEST_CASE("an impact in space keeps the momentum of both and makes no energy", "[idea]")
{
    for (const StrainLaw law : {StrainLaw::corotational, StrainLaw::neo_hookean}) {
        ElasticSpace scene(
            ElasticBody<3>(ball_mesh({0, 0, 0}, 0.3, 1, 2), {.young = 3e4, .poisson = 0.3, .law = law}));
        scene.gravity = {0, 0, 0};
        for (int i = 0; i < scene.elastic.model.nodes(); ++i) scene.elastic.v[3 * i] = 3;
        const Index box = add_body(scene, {solid_box({0.3, 0.4, 0.5})}, 500, {0.6, 0.1, 0.05});
        scene.friction = {0.5};
        const auto momentum = [&]() -> Vec3 {
            return momentum_of(scene.elastic) +
                   Vec3(scene.bodies.velocity(box).head<3>() / scene.bodies.inverse_mass[0]);
        };
        const Vec3 before = momentum();
        ElasticSolids contacts;
        contacts.tolerance = 1e-11;
        Real last = energy_of(scene);
        const Real first = last;
        for (int n = 0; n < 40; ++n) {
            contacts.step(scene, 1.0 / 120);
            REQUIRE(contacts.report.status == Status::solved);
            const Real now = energy_of(scene);
            CHECK(now < last + 1e-6 * first);  // what the tolerances of a step leave
            last = now;
        }
        CHECK(scene.bodies.u[0] > 0.5);                              // it was hit
        CHECK((momentum() - before).norm() < 1e-7 * before.norm());  // what Newton leaves, 40 times
    }
}

TEST_CASE("a soft block holds on a slope below μ and slides above it", "[idea]")
{
    const Real angle = 0.35, g = 9.81;  // tan = 0.365
    for (const Real mu : {0.45, 0.25}) {
        ElasticSpace scene(block(StrainLaw::corotational, 0.005));
        scene.elastic.gravity = {g * std::sin(angle), -g * std::cos(angle), 0};
        scene.walls.push_back({{0, 1, 0}, 0});
        scene.soft_friction = mu;
        scene.elastic.stiffness_damping = 5e-3;
        ElasticSolids contacts;
        const int settle = 60, run = 60;
        const Real h = 1.0 / 120;
        for (int n = 0; n < settle; ++n) contacts.step(scene, h);
        const Vec3 before = velocity_of(scene.elastic);
        for (int n = 0; n < run; ++n) contacts.step(scene, h);
        REQUIRE(contacts.report.status == Status::solved);
        const Vec3 after = velocity_of(scene.elastic);
        if (mu > std::tan(angle))
            CHECK(after.norm() < 1e-4);  // what half a second of damping leaves of 1 m/s
        else
            // its weight is its load: λ_t = μ λ_n at every node, so all of it by a = g (sin α − μ cos α)
            CHECK((after - before).x() / (run * h) ==
                  Approx(g * (std::sin(angle) - mu * std::cos(angle))).epsilon(0.01));
    }
}

TEST_CASE("friction of an elastic body is the same in every direction", "[idea]")
{
    // the same slide turned about the vertical: chapter 25's box of friction would hold √2 too much at 45°
    std::vector<Real> speeds;
    for (const Real about : {0.0, 0.4, 0.785}) {
        ElasticSpace scene(block(StrainLaw::corotational, 0.005));
        scene.elastic.gravity = {0, -9.81, 0};
        scene.walls.push_back({{0, 1, 0}, 0});
        scene.soft_friction = 0.3;
        for (int i = 0; i < scene.elastic.model.nodes(); ++i) scene.elastic.v[3 * i] = 2;
        turn(scene, rotation_matrix(Vec3(0, about, 0)));
        ElasticSolids contacts;
        for (int n = 0; n < 30; ++n) contacts.step(scene, 1.0 / 120);
        speeds.push_back(velocity_of(scene.elastic).norm());
    }
    for (const Real speed : speeds) {
        CHECK(speed < 1.9);
        CHECK(speed == Approx(speeds[0]).epsilon(1e-6));  // tolerances of 30 steps
    }
}

TEST_CASE("a body in space that is held in a fixed one is not thrown out of it", "[idea]")
{
    // a floor that its held face is sunk into, and a post of 4 mm near a node that is held
    for (const bool is_floor : {true, false}) {
        const Real sink = is_floor ? 0.02 : 0;
        ElasticSpace scene(
            ElasticBody<3>(block_mesh({0, -sink, -0.2}, {0.6, 0.3, 0.4}, 3, 2, 2), {.young = 1e5}));
        ElasticBody<3>& body = scene.elastic;
        if (is_floor) body.gravity = scene.gravity;
        for (int i = 0; i < body.model.nodes(); ++i)
            if (is_floor ? body.at(i).y() < 1e-9 - sink : body.at(i).x() < 1e-9) body.hold(i);
        const Real width = is_floor ? 4 : 0.004;
        const Index fixed = add_body(scene, {solid_box({width, 1, width})}, Real{1000},
                                     is_floor ? Vec3(0, -0.5, 0) : Vec3(0.03, -0.48, 0.05));
        scene.bodies.inverse_mass.segment<6>(6 * fixed).setZero();
        ElasticBody<3> alone = body;
        ElasticSolids contacts;
        ElasticSolver<3> solver;
        for (int n = 0; n < 5; ++n) {
            contacts.step(scene, 0.01);
            solver.step(alone, 0.01);
            CHECK(contacts.report.status == Status::solved);
        }
        if (!is_floor) CHECK(!contacts.rows.empty());
        // to the tolerances of both, 1e-8 and 1e-9 of an edge of 0.2 m
        CHECK((body.x - alone.x).cwiseAbs().maxCoeff() < 1e-8);
    }
}

TEST_CASE("a ground of triangles is a wall to an elastic body", "[idea]")
{
    ElasticSpace on_wall(block(StrainLaw::neo_hookean, 0.03)), on_mesh = on_wall;
    on_wall.walls.push_back({{0, 1, 0}, 0});
    on_mesh.meshes = {flat_mesh(3, 3, 0.41)};
    ElasticSolids one, other;
    for (ElasticSpace* const scene : {&on_wall, &on_mesh}) {
        scene->elastic.gravity = scene->gravity;
        for (int i = 0; i < scene->elastic.model.nodes(); ++i) scene->elastic.v[3 * i] = 1;
        for (int n = 0; n < 24; ++n) (scene == &on_wall ? one : other).step(*scene, 1.0 / 120);
    }
    CHECK(lowest(on_wall) < 1e-3);  // it has come down
    CHECK(lowest(on_wall) > -1e-5);
    // corners of triangles under its faces add rows that push no more than its nodes allow
    CHECK((on_wall.elastic.x - on_mesh.elastic.x).cwiseAbs().maxCoeff() < 1e-5);
}

TEST_CASE("a soft ball in space rolls as a solid one where the slope is gentle", "[idea]")
{
    const Real angle = 0.1;
    ElasticSpace scene = soft_ball_scene(StrainLaw::corotational, 3e5, angle);
    scene.elastic.stiffness_damping = 0;
    ElasticSolids contacts;
    contacts.solver.settings.stale = 0.3;
    const int steps = 72;
    for (int n = 0; n < steps; ++n) {
        contacts.step(scene, 1.0 / 120);
        REQUIRE(contacts.report.status == Status::solved);
    }
    const Vec3 v = velocity_of(scene.elastic);
    const Real along = v.dot(Vec3(std::cos(angle), -std::sin(angle), 0)), t = steps / 120.0;
    const Real rolling = 5.0 / 7 * 9.81 * std::sin(angle) * t, sliding = 9.81 * std::sin(angle) * t;
    CHECK(along < 1.03 * rolling);  // it rolls, it does not slide
    CHECK(along > 0.75 * rolling);  // where it is dented, and at the edges of its triangles, it loses some
    CHECK(along < sliding);
    CHECK(std::abs(v.z()) < 0.02 * along);
}

TEST_CASE("soft fingers in space lift a box", "[idea]")
{
    ElasticSpace scene = soft_fingers_scene(StrainLaw::corotational, 5e4, 8);
    ElasticSolids contacts;
    contacts.solver.settings.stale = 0.3;
    for (int n = 0; n < 84; ++n) {
        move_fingers(scene, n / 60.0);
        contacts.step(scene, 1.0 / 60);
    }
    CHECK(scene.bodies.x[1] ==
          Approx(0.15 + 0.3).margin(0.03));  // 0.6 s at 0.5 m/s, less what the fingers give
}

TEST_CASE("all steps of soft fingers and of a box on a mattress are solved", "[idea]")
{
    for (const bool is_mattress : {false, true}) {
        ElasticSpace scene = is_mattress ? mattress_scene(StrainLaw::corotational, 4e4, 12)
                                         : soft_fingers_scene(StrainLaw::corotational, 5e4, 8);
        ElasticSolids contacts;
        contacts.solver.settings.stale = 0.3;
        for (int n = 0; n < 84; ++n) {
            if (!is_mattress) move_fingers(scene, n / 60.0);
            contacts.step(scene, 1.0 / 60);
            INFO((is_mattress ? "mattress" : "fingers")
                 << ", step " << n << ": rows are off by " << contacts.solution.residual << " m/s");
            CHECK(contacts.report.status == Status::solved);
        }
    }
}

TEST_CASE("jelly goes down stairs of triangles and a box comes to rest on a mattress", "[idea]")
{
    ElasticSpace jelly = space_jelly_scene(StrainLaw::neo_hookean, 2e4);
    ElasticSolids contacts;
    contacts.solver.settings.stale = 0.3;
    for (int n = 0; n < 90; ++n) {
        contacts.step(jelly, 1.0 / 120);
        REQUIRE(contacts.report.residual < 1e-6);
    }
    Vec3 centre(0, 0, 0);
    for (int i = 0; i < jelly.elastic.model.nodes(); ++i)
        centre += jelly.elastic.model.mass_at(i) * jelly.elastic.at(i) / jelly.elastic.model.mass();
    CHECK(centre.x() > 0);    // over the first edge
    CHECK(centre.y() < 1.0);  // it started at 1.1 m
    CHECK(std::abs(centre.z()) < 0.02);
    Real depth = 0;
    for (int e = 0; e < jelly.elastic.model.points(); ++e)
        depth = std::min(depth, jelly.elastic.model.deformation(jelly.elastic.x, e).determinant());
    CHECK(depth >= 0);  // nothing is inside out

    ElasticSpace mattress = mattress_scene(StrainLaw::corotational, 4e4, 12);
    ElasticSolids other;
    other.solver.settings.stale = 0.3;
    for (int n = 0; n < 150; ++n) other.step(mattress, 1.0 / 60);
    CHECK(mattress.bodies.u.norm() < 0.02);
    // its lowest side lies in the dent: between the floor and the height of the mattress
    CHECK(mattress.bodies.x[1] < 0.2 + 0.1 + 0.005);
    CHECK(mattress.bodies.x[1] > 0.2);
}

TEST_CASE("a factor that still serves is kept and the step is the same", "[house]")
{
    ElasticSpace fresh(block(StrainLaw::corotational, 0.02)), kept = fresh;
    for (ElasticSpace* const scene : {&fresh, &kept}) {
        scene->elastic.gravity = scene->gravity;
        scene->walls.push_back({{0, 1, 0}, 0});
        scene->elastic.stiffness_damping = 5e-3;
    }
    ElasticSolids one, other;
    one.tolerance = other.tolerance = 1e-11;
    one.most = other.most = 40;
    other.solver.settings.stale = 0.3;
    int ones = 0, others = 0, at_rest = 0;
    for (int n = 0; n < 60; ++n) {
        one.step(fresh, 1.0 / 120), other.step(kept, 1.0 / 120);
        REQUIRE(one.report.status == Status::solved);
        REQUIRE(other.report.status == Status::solved);
        ones += one.report.factorisations, others += other.report.factorisations;
        if (n >= 40) at_rest += other.report.factorisations;
    }
    // both are answers to 1e-11 in each of 60 steps
    CHECK((fresh.elastic.x - kept.elastic.x).cwiseAbs().maxCoeff() < 1e-7);
    CHECK(ones >= 60);
    CHECK(others < ones / 4);
    CHECK(at_rest <= 2);  // what has settled turns nothing
}

TEST_CASE("a step with contacts in space allocates nothing", "[house]")
{
    ElasticSpace scene = mattress_scene(StrainLaw::corotational, 4e4, 12);
    ElasticSolids contacts;
    contacts.solver.settings.stale = 0.3;
    for (int n = 0; n < 60; ++n) contacts.step(scene, 1.0 / 60);
    REQUIRE(contacts.rows.size() > 6);
    const NoAllocation watch;
    for (int n = 0; n < 5; ++n) contacts.step(scene, 1.0 / 60);
    CHECK(NoAllocation::violations() == 0);
}

TEST_CASE("bad scenes in space are refused and change nothing", "[house]")
{
    ElasticSpace scene = mattress_scene(StrainLaw::corotational, 4e4, 12);
    const VecX before = scene.elastic.x, bodies = scene.bodies.x;
    ElasticSolids contacts;
    CHECK(sentence_of([&] { contacts.step(scene, 0); }) ==
          "the time step h is 0 s; it must be positive and finite");
    scene.gravity[1] = NAN;
    CHECK(sentence_of([&] { contacts.step(scene, 0.01); }) == "gravity is not finite");
    scene.gravity[1] = -9.81;
    scene.soft_friction = -1;
    CHECK(sentence_of([&] { contacts.step(scene, 0.01); }) ==
          "the friction of an elastic scene is -1; it must be zero or positive");
    scene.soft_friction = 0.5, scene.skin = infinity;
    CHECK(sentence_of([&] { contacts.step(scene, 0.01); }) ==
          "the skin of an elastic scene is inf; it must be zero or positive");
    scene.skin = 0.005, contacts.solver.settings.stale = 1.5;
    CHECK(sentence_of([&] { contacts.step(scene, 0.01); }) ==
          "the share that a stale factor has to take the residual to is 1.5; it must be from 0 to 1");
    contacts.solver.settings = {.solve = LinearSolve::conjugate_gradients};
    CHECK(sentence_of([&] { contacts.step(scene, 0.01); }) ==
          "contacts of an elastic body need its factor; choose LinearSolve::direct");
    CHECK(scene.elastic.x == before);
    CHECK(scene.bodies.x == bodies);
}
