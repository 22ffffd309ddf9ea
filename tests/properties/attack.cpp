// A random attack on every solver of chapters 3, 4, 5 and 9: nothing that they say may be false.
//
//     solver_attack [--problems N] [--seed S] [--kind K] [--solver NAME] [--all]
//
// Prints the first problem on which a verdict is false, as a problem file, and ends with 1. `--all` goes on and counts.
#include "chapters/03_mlcp_formulation/problem_reader.hpp"
#include "tests/properties/random_attack.hpp"
#include "tests/properties/verdicts.hpp"

#include <chrono>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <map>

namespace {

using namespace rigid;
using namespace rigid::properties;

void write_problem(std::ostream& out, const std::string& name, const Mlcp& mlcp)
{
    const MatX A = mlcp.A;
    const auto line = [&](const VecX& numbers) {
        for (Index i = 0; i < numbers.size(); ++i) out << (i ? " " : "") << shortest(numbers[i]);
        out << '\n';
    };
    out << "name " << name << "\nn " << mlcp.size() << "\nA\n";
    for (Index i = 0; i < mlcp.size(); ++i) line(A.row(i).transpose());
    out << "q\n";
    line(mlcp.q);
    out << "lo\n";
    line(mlcp.lo);
    out << "hi\n";
    line(mlcp.hi);
}

struct Wanted {
    std::uint64_t problems = 60000, seed = 1;
    std::string kind, solver;
    bool all = false;
};

/// False, and a sentence, for what makes no sense.
bool parse(int argc, char** argv, Wanted& wanted)
{
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k], value = k + 1 < argc ? argv[k + 1] : "";
        const auto number = parse_whole(value);
        if (word == "--all") wanted.all = true;
        else if (word == "--solver" && !value.empty()) {
            wanted.solver = value;
            ++k;
        } else if ((word == "--problems" || word == "--seed") && number) {
            (word == "--seed" ? wanted.seed : wanted.problems) = *number;
            ++k;
        } else if (word == "--kind" && std::find(std::begin(attack_kinds), std::end(attack_kinds), value) !=
                                           std::end(attack_kinds)) {
            wanted.kind = value;
            ++k;
        } else {
            std::cerr << "\"" << word << " " << value
                      << "\" is no option; there are --problems N, --seed S, --solver NAME, --all and --kind "
                         "with one of:";
            for (const auto kind : attack_kinds) std::cerr << " \"" << kind << "\"";
            std::cerr << '\n';
            return false;
        }
    }
    return true;
}

}  // namespace

int main(int argc, char** argv)
{
    Wanted wanted;
    if (!parse(argc, argv, wanted)) return 2;
    AllSolvers solvers;
    Tally tally;
    std::map<std::string, long> wrong;
    const auto start = std::chrono::steady_clock::now();
    for (std::uint64_t sample = 0; sample < wanted.problems; ++sample) {
        const auto kind = static_cast<Index>(sample % static_cast<std::uint64_t>(attack_kind_count));
        if (!wanted.kind.empty() && attack_kinds[kind] != wanted.kind) continue;
        Random random(wanted.seed * 1'000'003 + sample);  // each problem can be made alone
        const Attack attack = random_attack(kind, random);
        std::vector<std::string> sentences;
        try {
            sentences = false_verdicts(attack.mlcp, attack.whole, solvers.solve(attack.mlcp), tally);
        } catch (const std::exception& failure) {
            sentences.push_back(std::string("a solver throws: ") + failure.what());
        }
        if (!wanted.solver.empty())
            std::erase_if(sentences, [&](const std::string& s) { return s.rfind(wanted.solver, 0) != 0; });
        if (sentences.empty()) continue;
        for (const std::string& sentence : sentences)
            ++wrong[attack.kind + ": " + sentence.substr(0, sentence.find(','))];
        if (wanted.all) continue;
        for (const std::string& sentence : sentences) std::cout << "# " << sentence << '\n';
        std::cout << "# kind \"" << attack.kind << "\", sample " << sample << ", seed " << wanted.seed
                  << '\n';
        write_problem(std::cout, "attack_" + std::to_string(wanted.seed) + "_" + std::to_string(sample),
                      attack.mlcp);
        return 1;
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    for (const auto& [what, count] : wrong) std::cout << count << " times  " << what << '\n';
    std::printf("%llu problems, %ld verdicts in %.1f s: %ld solved, %ld infeasible, %ld on how many answers "
                "there are; "
                "%ld problems with all answers known exactly\n",
                static_cast<unsigned long long>(wanted.problems), tally.verdicts, seconds.count(),
                tally.solved, tally.infeasible, tally.counted, tally.exact);
    return wrong.empty() ? 0 : 1;
}
