// libFuzzer: any bytes as a problem file, and every solver behind the reader. README.md says how to run it.
//
// A file is refused with a sentence or solved; nothing else may be thrown, and an answer that is called solved must be
// one.
#include "chapters/03_mlcp_formulation/problem_reader.hpp"
#include "tests/properties/all_solvers.hpp"
#include "tests/properties/judge.hpp"
#include "tests/properties/verdicts.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sstream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace rigid;
    using namespace rigid::properties;
    static AllSolvers solvers;
    Mlcp mlcp;
    try {
        std::istringstream file(std::string(data, data + size));
        mlcp = ProblemReader(file).read().mlcp;
    } catch (const std::invalid_argument&) {
        return 0;
    }
    if (mlcp.size() > 8) return 0;  // more rows take more time and are no other code
    const WideProblem problem(mlcp);
    for (const Answer& answer : solvers.solve(mlcp)) {
        if (answer.solution.status != Status::solved) continue;
        const Wide error =
            problem.error(widened(answer.solution.lambda), 11 * static_cast<Wide>(answer.enough));
        if (error <= wrong_from) continue;
        std::fprintf(stderr, "%s says solved, and the residual is %s of what is given\n",
                     answer.solver.c_str(), in_words(error).c_str());
        std::abort();
    }
    return 0;
}
