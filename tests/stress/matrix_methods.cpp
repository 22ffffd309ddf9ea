#include "chapters/03_mlcp_formulation/direct.hpp"
#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/05_lemke/lemke.hpp"
#include "tests/stress/matrix_step.hpp"

namespace rigid::stress {

namespace {

Method pgs_method(const std::string& name, Sweeps sweeps, Real omega, int most, Real tolerance)
{
    struct Solve {
        PgsSettings settings;
        PgsMemory memory;
        static std::vector<Setting> tunables(PgsSettings& s)
        {
            return {or_infinity("tolerance", &s.tolerance), {"omega", &s.omega}};
        }
        void operator()(const Mlcp& mlcp, const Wish& wish, int first, Solution& solution)
        {
            PgsSettings now = settings;
            spoil_solver(wish, first, tunables(now));
            cold_start(mlcp, solution.lambda);
            pgs(mlcp, now, memory, solution);
        }
    };
    PgsSettings settings;
    settings.sweeps = sweeps;
    settings.omega = omega;
    settings.max_sweeps = most;
    settings.tolerance = tolerance;
    const std::string budget = tolerance > 0 ? "to 1e-6 m/s, " + std::to_string(most) + " sweeps at most"
                                             : std::to_string(most) + " sweeps";
    return matrix_method(4, name, budget, names_of(Solve::tunables(settings)), [settings] {
        return Solve{settings, {}};
    });
}

/// Chapter 4's contrast: only for rows without bounds.
Method cg_method()
{
    struct Solve {
        CgMemory memory;
        void operator()(const Mlcp& mlcp, const Wish& wish, int first, Solution& solution)
        {
            Real tolerance = 1e-9;
            spoil_solver(wish, first, {or_infinity("tolerance", &tolerance)});
            cold_start(mlcp, solution.lambda);
            conjugate_gradients(mlcp, tolerance, 10000, memory, solution);
        }
    };
    Method method = matrix_method(4, "conjugate gradients", "to 1e-9 m/s",
                                  {or_infinity("tolerance", nullptr)}, [] { return Solve{}; });
    method.links_only = true;
    return method;
}

/// Chapter 3's one factorisation: only for rows without bounds.
Method direct_method()
{
    struct Solve {
        void operator()(const Mlcp& mlcp, const Wish& wish, int first, Solution& solution)
        {
            Real tolerance = 1e-10;
            spoil_solver(wish, first, {or_infinity("tolerance", &tolerance)});
            solution = direct(mlcp, tolerance);
        }
    };
    Method method =
        matrix_method(3, "direct", "exact", {or_infinity("tolerance", nullptr)}, [] { return Solve{}; });
    method.links_only = true;
    method.most_rows = 250;
    return method;
}

Method lemke_method()
{
    struct Solve {
        void operator()(const Mlcp& mlcp, const Wish& wish, int first, Solution& solution)
        {
            LemkeSettings settings;
            spoil_solver(wish, first, {or_infinity("tolerance", &settings.tolerance)});
            solution = lemke(mlcp, settings);
        }
    };
    Method method =
        matrix_method(5, "lemke", "exact", {or_infinity("tolerance", nullptr)}, [] { return Solve{}; });
    method.most_rows = 100;
    return method;
}

}  // namespace

std::vector<Method> matrix_methods(int sweeps)
{
    return {direct_method(),
            pgs_method("jacobi", Sweeps::jacobi, 0.5, sweeps, 0),
            pgs_method("gauss_seidel", Sweeps::gauss_seidel, 1, sweeps, 0),
            pgs_method("symmetric", Sweeps::symmetric, 1, sweeps, 0),
            pgs_method("sor 1.3", Sweeps::gauss_seidel, 1.3, sweeps, 0),
            pgs_method("gauss_seidel to the end", Sweeps::gauss_seidel, 1, 5000, 1e-6),
            cg_method(),
            lemke_method()};
}

}  // namespace rigid::stress
