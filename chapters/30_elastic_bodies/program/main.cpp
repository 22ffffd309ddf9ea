// Chapter 30. Elastic bodies: the program.
#include "chapters/30_elastic_bodies/elastic_loads.hpp"
#include "chapters/30_elastic_bodies/elastic_sound.hpp"
#include "chapters/30_elastic_bodies/program/elastic_space_run.hpp"

#include <ostream>

namespace rigid {
namespace {

Tunable modulus(Real value)
{
    return {"young", "Pa", "Young's modulus", value,
            1e3,     1e9,  Numbers::real,     OnChange::restarts};
}

Tunable number(const char* name, const char* unit, const char* help, Real value,
               Real low, Real high)
{
    return {name, unit, help, value, low, high, Numbers::real, OnChange::restarts};
}

const std::vector<std::string> laws = {"corotational", "neo_hookean", "linear"};
const std::vector<std::string> all = {"corotational", "neo_hookean", "linear",
                                      "midpoint", "modal"};

/// The mean place of the nodes, by their masses.
Vec2 centre_of(const ElasticBody<2>& body)
{
    Vec2 sum(0, 0);
    for (int i = 0; i < body.model.nodes(); ++i)
        sum += body.model.mass_at(i) * body.at(i);
    return sum / body.model.mass();
}

/// The triangle of section 30.1, with the forces of its corners.
class TriangleRun : public Run {
public:
    TriangleRun(StrainLaw law, Real pull, Real turn)
        : model_(triangle(), {2.5, 0.25, 1, law})
    {
        x_ = model_.mesh().rest;
        x_[2] += pull;
        for (int i = 0; i < 3; ++i) {
            const Vec2 p = x_.segment<2>(2 * i);
            x_.segment<2>(2 * i) = cos(turn) * p + sin(turn) * perpendicular(p);
        }
        force_ = VecX::Zero(6);
        energy_ = model_.add_forces(x_, force_);
    }
    void step(const Settings&, const Input&) override {}
    std::vector<Real> measure() const override
    {
        return {energy_, force_.segment<2>(2).norm()};
    }
    void draw(Canvas& canvas) const override
    {
        const VecX& rest = model_.mesh().rest;
        const auto corners = [](const VecX& x) {
            return std::vector<Vec2>{x.segment<2>(0), x.segment<2>(2),
                                     x.segment<2>(4)};
        };
        canvas.polygon(corners(rest), {Colour::ink, 1.2, 0.8, Paint::dashed});
        canvas.polygon(corners(x_), {Colour::blue, 1.8, 0.25, Paint::filled});
        const char* const names[3] = {"0", "1", "2"};
        const Vec2 beside[3] = {{-0.09, -0.07}, {0.05, -0.08}, {-0.09, 0.03}};
        for (int i = 0; i < 3; ++i) {
            const Vec2 p = x_.segment<2>(2 * i), f = force_.segment<2>(2 * i);
            if (f.norm() > 1e-12) {
                canvas.arrow(p, p + 2 * f, {Colour::red, 2.2, 1});
                canvas.text(p + 2 * f + Vec2(0.03, 0.03), fixed(f.norm(), 2) + " N",
                            14, {Colour::red});
            }
            canvas.text(p + beside[i], names[i], 16);
        }
    }

private:
    static ElasticMesh<2> triangle()
    {
        ElasticMesh<2> mesh;
        mesh.rest = VecX{{0, 0, 1, 0, 0, 1}};
        mesh.elements = {0, 1, 2};
        return mesh;
    }
    ElasticModel<2> model_;
    VecX x_, force_;
    Real energy_ = 0;
};

Demo triangle_demo()
{
    Demo scene;
    scene.name = "triangle";
    scene.summary = "One triangle and its forces";
    scene.view = {{0.5, 0.45}, {0.95, 0.65}};
    scene.methods = {"linear", "corotational", "neo_hookean"};
    scene.tunables = {number("pull", "m", "of corner 1 to the right", 0.1, -0.9, 1),
                      number("turn", "rad", "of all of it", 0, -3.2, 3.2)};
    scene.columns = {{"energy", "J", "of the triangle", Plot::linear},
                     {"force", "N", "at corner 1", Plot::linear}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<TriangleRun>(law_of(settings), settings["pull"],
                                             settings["turn"]);
    };
    return scene;
}

/// How far a cantilever sags, over what (30.15) says.
Demo cantilever_demo()
{
    Tunable through = number("through", "", "boxes through its height", 2, 1, 16),
            order = number("order", "", "of the elements: 1 linear, 2 quadratic", 1,
                           1, 2);
    Tunable parallel =
        number("parallel", "", "1: all diagonals in one direction", 0, 0, 1);
    through.numbers = order.numbers = parallel.numbers = Numbers::whole;
    return elastic_demo(
        "cantilever", "Which triangles let a beam bend?", {{0.5, 0}, {0.7, 0.4}},
        1.0 / 60, {"linear", "corotational", "neo_hookean"},
        {through, order, parallel,
         number("nu", "", "Poisson's ratio", 0, -0.5, 0.4999),
         number("height", "m", "of the beam", 0.1, 0.005, 0.3)},
        {{"ratio", "", "sag over (30.15)", Plot::linear}},
        [](const Settings& settings) {
            const Real d = settings["height"];
            const int n = static_cast<int>(settings["through"]);
            ElasticMesh<2> mesh = rectangle_mesh(
                {0, -d / 2}, {1, d},
                std::max(1, static_cast<int>(std::round(0.1 / d * 10 * n))), n,
                settings["parallel"] > 0 ? Diagonals::parallel
                                         : Diagonals::alternate);
            if (settings["order"] > 1.5) mesh = quadratic(mesh);
            const ElasticMaterial material{
                .young = 1e6, .poisson = settings["nu"], .law = law_of(settings)};
            ElasticScene scene(ElasticBody<2>(mesh, material));
            int tip = 0;
            for (int i = 0; i < mesh.nodes(); ++i) {
                if (mesh.at(i).x() < 1e-9) scene.elastic.hold(i);
                if (mesh.at(i).x() > mesh.at(tip).x() + 1e-9) tip = i;
            }
            // so small a load that all laws agree
            const Real whole = cantilever_sag(material, 1, d, 1),
                       load = 1e-4 / whole;
            add_edge_load(
                scene.elastic, [](const Vec2& p) { return p.x() > 1 - 1e-9; },
                Vec2(0, -load / d));
            ElasticSetup setup{std::move(scene), false, true, 20, {}, {}};
            setup.measure = [tip](const ElasticScene& s) -> std::vector<Real> {
                return {
                    (s.elastic.model.mesh().at(tip).y() - s.elastic.at(tip).y()) /
                    1e-4};
            };
            return setup;
        });
}

Demo strip_demo()
{
    return elastic_demo(
        "strip", "A strip falls under its own weight", {{0.6, -0.3}, {0.9, 0.9}},
        1.0 / 60, all, {modulus(3e5)},
        {{"x", "m", "of the tip", Plot::linear},
         {"y", "m", "of the tip", Plot::linear}},
        [](const Settings& settings) {
            ElasticSetup setup{strip_scene(law_of(settings), settings["young"]),
                               false,
                               false,
                               20,
                               {},
                               {}};
            const ElasticMesh<2>& mesh = setup.scene.elastic.model.mesh();
            int tip = 0;
            for (int i = 0; i < mesh.nodes(); ++i)
                if ((mesh.at(i) - Vec2(1, 0)).norm() < 1e-9) tip = i;
            setup.measure = [tip](const ElasticScene& s) -> std::vector<Real> {
                return {s.elastic.at(tip).x(), s.elastic.at(tip).y()};
            };
            return setup;
        });
}

Demo spinning_demo()
{
    return elastic_demo(
        "spin", "A disc turns: which law lets it be?", {{0, 0}, {1, 1}}, 1.0 / 60,
        all,
        {modulus(1e5), number("omega", "rad/s", "its angular velocity", 6, 0, 40)},
        {{"size", "m", "distance of a node of the rim from the middle",
          Plot::linear}},
        [](const Settings& settings) {
            ElasticSetup setup{spinning_scene(law_of(settings), settings["young"],
                                              settings["omega"]),
                               false,
                               false,
                               20,
                               {},
                               {}};
            setup.measure = [](const ElasticScene& s) -> std::vector<Real> {
                return {
                    (s.elastic.at(s.elastic.model.nodes() - 1) - s.elastic.at(0))
                        .norm()};
            };
            return setup;
        });
}

std::vector<Column> centre_columns()
{
    return {{"x", "m", "of its centre", Plot::linear},
            {"y", "m", "of its centre", Plot::linear}};
}

std::vector<Real> centre_measures(const ElasticScene& s)
{
    const Vec2 centre = centre_of(s.elastic);
    return {centre.x(), centre.y()};
}

Demo ball_demo()
{
    return elastic_demo(
        "ball", "A soft ball rolls down a slope", {{1.2, -0.1}, {1.9, 1.1}},
        1.0 / 120, laws,
        {modulus(3e4), number("slope", "rad", "angle of the slope", 0.2, 0, 0.6)},
        centre_columns(), [](const Settings& settings) {
            return ElasticSetup{
                ball_scene(law_of(settings), settings["young"], settings["slope"]),
                true,
                false,
                20,
                centre_measures,
                {}};
        });
}

Demo jelly_demo()
{
    return elastic_demo(
        "jelly", "Jelly falls down stairs", {{1.3, 0.9}, {1.7, 1.2}}, 1.0 / 120,
        {"neo_hookean", "corotational", "linear"}, {modulus(2e4)}, centre_columns(),
        [](const Settings& settings) {
            return ElasticSetup{jelly_scene(law_of(settings), settings["young"]),
                                true,
                                false,
                                20,
                                centre_measures,
                                {}};
        });
}

Demo gripper_demo()
{
    return elastic_demo(
        "gripper", "Two soft fingers lift a box", {{0, 0.6}, {0.9, 0.8}}, 1.0 / 120,
        laws, {modulus(5e4), number("mass", "kg", "of the box", 20, 1, 200)},
        {{"height", "m", "of the box", Plot::linear}},
        [](const Settings& settings) {
            ElasticSetup setup{gripper_scene(law_of(settings), settings["young"],
                                             settings["mass"]),
                               true,
                               false,
                               20,
                               {},
                               move_gripper};
            setup.measure = [](const ElasticScene& s) -> std::vector<Real> {
                return {s.bodies.x[1]};
            };
            return setup;
        });
}

Demo bridge_demo()
{
    return elastic_demo(
        "bridge", "A car crosses a bridge that bends", {{0, 0}, {3.6, 1.2}},
        1.0 / 120, laws,
        {modulus(1e7), number("speed", "m/s", "of the car", 2, 0, 8)},
        {{"car", "m", "where the car is", Plot::linear},
         {"sag", "m", "of the middle of the bridge", Plot::linear}},
        [](const Settings& settings) {
            ElasticSetup setup{bridge_with_car(law_of(settings), settings["young"],
                                               settings["speed"]),
                               true,
                               false,
                               20,
                               {},
                               {}};
            const ElasticMesh<2>& mesh = setup.scene.elastic.model.mesh();
            int middle = 0;
            for (int i = 0; i < mesh.nodes(); ++i)
                if ((mesh.at(i) - Vec2(0, 0)).norm() < 1e-9) middle = i;
            setup.measure = [middle](const ElasticScene& s) -> std::vector<Real> {
                return {s.bodies.x[6], -s.elastic.at(middle).y()};
            };
            return setup;
        });
}

Demo bar_demo()
{
    return elastic_demo(
        "bar", "A bar is struck at one end", {{0, 0}, {0.7, 0.3}}, 1e-4,
        {"modal", "midpoint", "corotational"}, {modulus(1e9)},
        {{"end", "m", "height of its left end", Plot::linear}},
        [](const Settings& settings) {
            ElasticSetup setup{struck_bar(law_of(settings), settings["young"]),
                               false,
                               false,
                               20,
                               {},
                               {}};
            setup.measure = [](const ElasticScene& s) -> std::vector<Real> {
                return {s.elastic.at(0).y()};
            };
            return setup;
        });
}

const std::vector<std::string> turning = {"corotational", "neo_hookean"};

Demo solid_ball_demo()
{
    return solid_demo(
        "ball_in_space", "A soft ball rolls down a slope",
        {{0.9, -0.1}, {1.5, 0.9}}, 1.0 / 60, turning,
        {modulus(3e4), number("slope", "rad", "angle of the slope", 0.2, 0, 0.6),
         number("mu", "", "friction", 0.8, 0, 2)},
        {{"x", "m", "of its centre", Plot::linear},
         {"y", "m", "of its centre", Plot::linear}},
        [](const Settings& settings) {
            ElasticSpaceSetup setup{
                soft_ball_scene(law_of(settings), settings["young"],
                                settings["slope"], settings["mu"]),
                {{0, 0, 0}, 7, 0.3, 0.15},
                0,
                {},
                {}};
            setup.measure = [](const ElasticSpace& s) -> std::vector<Real> {
                const Vec3 p = middle_of(s.elastic);
                return {p.x(), p.y()};
            };
            return setup;
        });
}

Demo solid_jelly_demo()
{
    return solid_demo(
        "jelly_in_space", "Jelly falls down stairs of triangles",
        {{0.1, -0.1}, {1.3, 0.9}}, 1.0 / 120, {"neo_hookean", "corotational"},
        {modulus(2e4)},
        {{"x", "m", "of its centre", Plot::linear},
         {"y", "m", "of its centre", Plot::linear}},
        [](const Settings& settings) {
            ElasticSpaceSetup setup{
                space_jelly_scene(law_of(settings), settings["young"]),
                {{0.4, 0.6, 0}, 6, 0.6, 0.35},
                0,
                {},
                {}};
            setup.measure = [](const ElasticSpace& s) -> std::vector<Real> {
                const Vec3 p = middle_of(s.elastic);
                return {p.x(), p.y()};
            };
            return setup;
        });
}

Demo fingers_demo()
{
    return solid_demo(
        "fingers", "Soft fingers in space lift a box", {{0, 0}, {0.9, 0.7}},
        1.0 / 60, turning,
        {modulus(5e4), number("mass", "kg", "of the box", 8, 1, 100)},
        {{"height", "m", "of the box", Plot::linear}},
        [](const Settings& settings) {
            ElasticSpaceSetup setup{soft_fingers_scene(law_of(settings),
                                                       settings["young"],
                                                       settings["mass"]),
                                    {{0, 0.4, 0}, 4, 0.5, 0.3},
                                    1,
                                    {},
                                    move_fingers};
            setup.measure = [](const ElasticSpace& s) -> std::vector<Real> {
                return {s.bodies.x[1]};
            };
            return setup;
        });
}

Demo mattress_demo()
{
    return solid_demo(
        "mattress", "A box falls onto a mattress", {{0, 0}, {0.7, 0.5}}, 1.0 / 60,
        turning, {modulus(4e4), number("mass", "kg", "of the box", 12, 1, 100)},
        {{"height", "m", "of the box", Plot::linear}},
        [](const Settings& settings) {
            ElasticSpaceSetup setup{mattress_scene(law_of(settings),
                                                   settings["young"],
                                                   settings["mass"]),
                                    {{0, 0.2, 0}, 3, 0.6, 0.4},
                                    0.6,
                                    {},
                                    {}};
            setup.measure = [](const ElasticSpace& s) -> std::vector<Real> {
                return {s.bodies.x[1]};
            };
            return setup;
        });
}

/// Two seconds of a bar of steel, 0.3 m × 6 mm, that is struck at one end.
void write_bar(std::ostream& file)
{
    ElasticBody<2> bar = chime();
    write_wave(file, sound_of(bar, 12, 1, 2));
}

}  // namespace
}  // namespace rigid

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "30_elastic_bodies";
        program.title = "Chapter 30. Elastic bodies";
        program.scenes = {triangle_demo(),   cantilever_demo(),  strip_demo(),
                          spinning_demo(),   ball_demo(),        jelly_demo(),
                          gripper_demo(),    bridge_demo(),      bar_demo(),
                          solid_ball_demo(), solid_jelly_demo(), fingers_demo(),
                          mattress_demo()};
        program.own_files = {
            {"--wav", "Write the sound of a struck bar and end", write_bar}};
        return program;
    };
    return run_program(make, argc, argv);
}
