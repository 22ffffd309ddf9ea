/// \file calculix.hpp
/// The rest and the vibrations of a linear body of tetrahedra by CalculiX, a program for the statics of solids: the same
/// nodes and elements as a file, `ccx` as a process, and what it prints, seven digits.
#pragma once

#ifdef RIGID_CALCULIX

#include "chapters/30_elastic_bodies/elastic_solver.hpp"
#include "common/text.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

struct CalculixAnswer {
    VecX moved;               ///< u of all nodes under load and weight [m]
    std::vector<Real> omega;  ///< the slowest vibrations [rad/s]
    Real seconds = 0;         ///< of the whole process
};

/// \throws std::runtime_error  where CalculiX cannot be run or says nothing
inline CalculixAnswer by_calculix(const ElasticBody<3>& body, int vibrations)
{
    namespace fs = std::filesystem;
    const ElasticMesh<3>& mesh = body.model.mesh();
    const fs::path folder = fs::temp_directory_path() / "rigid_calculix";
    fs::create_directories(folder);
    const std::string job = (folder / "body").string();
    {
        std::ofstream file(job + ".inp");
        file << "*NODE, NSET=ALL\n";
        for (int i = 0; i < mesh.nodes(); ++i) {
            file << i + 1;
            for (int c = 0; c < 3; ++c) file << ", " << shortest(mesh.at(i)[c]);
            file << '\n';
        }
        // its middle nodes go around the first triangle, then up
        constexpr int order[10] = {0, 1, 2, 3, 4, 6, 5, 7, 8, 9};
        file << "*ELEMENT, TYPE=C3D" << mesh.per_element() << ", ELSET=BODY\n";
        for (int e = 0; e < mesh.count(); ++e) {
            file << e + 1;
            for (int i = 0; i < mesh.per_element(); ++i) file << ", " << mesh.node(e, order[i]) + 1;
            file << '\n';
        }
        const ElasticMaterial& m = body.model.material();
        file << "*MATERIAL, NAME=M\n*ELASTIC\n"
             << shortest(m.young) << ", " << shortest(m.poisson) << "\n*DENSITY\n"
             << shortest(m.density) << "\n*SOLID SECTION, ELSET=BODY, MATERIAL=M\n*BOUNDARY\n";
        for (int i = 0; i < 3 * mesh.nodes(); ++i)
            if (body.fixed[static_cast<std::size_t>(i)])
                file << i / 3 + 1 << ", " << i % 3 + 1 << ", " << i % 3 + 1 << '\n';
        file << "*STEP\n*STATIC\n*CLOAD\n";
        for (int i = 0; i < mesh.nodes(); ++i)
            for (int c = 0; c < 3; ++c)
                if (const Real f = body.load[3 * i + c] + body.model.mass_at(i) * body.gravity[c]; f != 0)
                    file << i + 1 << ", " << c + 1 << ", " << shortest(f) << '\n';
        file << "*NODE PRINT, NSET=ALL\nU\n*END STEP\n*STEP\n*FREQUENCY\n" << vibrations << "\n*END STEP\n";
    }
    CalculixAnswer answer;
    const auto start = std::chrono::steady_clock::now();
    const int code =
        std::system(("cd \"" + folder.string() + "\" && " RIGID_CALCULIX " -i body >body.log 2>&1").c_str());
    answer.seconds = std::chrono::duration<Real>(std::chrono::steady_clock::now() - start).count();
    // lines of four numbers "node ux uy uz", then of five "mode eigenvalue rad/time cycles/time imaginary"
    answer.moved = VecX::Zero(3 * mesh.nodes());
    std::ifstream printed(job + ".dat");
    int found = 0;
    for (std::string line; std::getline(printed, line);) {
        std::istringstream words(line);
        std::vector<Real> numbers;
        for (Real x; words >> x;) numbers.push_back(x);
        if (!words.eof()) continue;
        if (numbers.size() == 4 && answer.omega.empty()) {
            for (int c = 0; c < 3; ++c)
                answer.moved[3 * (static_cast<Index>(numbers[0]) - 1) + c] =
                    numbers[static_cast<std::size_t>(1 + c)];
            ++found;
        }
        if (numbers.size() == 5 && static_cast<int>(answer.omega.size()) < vibrations)
            answer.omega.push_back(numbers[2]);
    }
    if (code != 0 || found != mesh.nodes() || static_cast<int>(answer.omega.size()) != vibrations)
        throw std::runtime_error("CalculiX gave " + std::to_string(found) + " nodes and " +
                                 std::to_string(answer.omega.size()) + " vibrations; " + job +
                                 ".log says why");
    fs::remove_all(folder);
    return answer;
}

}  // namespace rigid

#endif
