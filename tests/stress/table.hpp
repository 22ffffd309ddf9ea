/// \file table.hpp
/// The table of the stability matrix: written, read again, and held against another one.
#pragma once

#include "common/text.hpp"
#include "tests/stress/judge.hpp"

#include <fstream>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace rigid::stress {

inline constexpr const char* header = "stress,level,method,chapter,value,score,lowest,seeds,why";

/// A cell. `seeds` is 0 where the stress does not apply to the method.
struct Row {
    std::string stress;
    int level = 1;
    std::string method;
    int chapter = 0;
    std::string value;
    Real score = 0;  ///< mean of the scores, as a share of the full one
    int lowest = 0;  ///< the least of the scores
    int seeds = 0;
    std::string why = "";  ///< of the first perturbation with the lowest score
};

inline std::string to_line(const Row& row)
{
    const std::string cell = row.stress + "," + std::to_string(row.level) + "," + row.method + "," +
                             std::to_string(row.chapter) + "," + row.value + ",";
    if (row.seeds == 0) return cell + ",,0,\n";
    return cell + fixed(row.score, 3) + "," + std::to_string(row.lowest) + "," + std::to_string(row.seeds) +
           "," + row.why + "\n";
}

inline const Row* find_row(const std::vector<Row>& table, const std::string& stress, int level,
                           const std::string& method)
{
    for (const Row& row : table)
        if (row.level == level && row.method == method && row.stress == stress) return &row;
    return nullptr;
}

/// The rows of a table, none if there is no such file. Throws std::invalid_argument if it is not such a table.
inline std::vector<Row> read_table(const std::string& file)
{
    std::vector<Row> rows;
    std::ifstream table(file);
    std::string line;
    if (!table || !std::getline(table, line)) return rows;
    if (line != header)
        throw std::invalid_argument("\"" + file + "\" begins with \"" + line +
                                    "\"; a table of this program begins with \"" + header + "\"");
    while (std::getline(table, line)) {
        std::vector<std::string> words;
        std::stringstream stream(line + ",");
        for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
        try {
            rows.push_back({words.at(0), std::stoi(words.at(1)), words.at(2), std::stoi(words.at(3)),
                            words.at(4), words.at(5).empty() ? 0 : std::stod(words.at(5)),
                            words.at(6).empty() ? 0 : std::stoi(words.at(6)), std::stoi(words.at(7)),
                            words.at(8)});
        } catch (const std::exception&) {
            throw std::invalid_argument("\"" + line + "\" in \"" + file + "\" is not a row of \"" + header +
                                        "\"");
        }
    }
    return rows;
}

/// Bad input that got through, and answers that call themselves right and aren't: none of them may be.
/// \return  how many
inline int complain_of_silence(const std::vector<Row>& table, std::ostream& out)
{
    int faults = 0;
    for (const Row& row : table) {
        if (row.seeds == 0 || (row.why != silent && (row.stress != "bad input" || row.lowest == accurate)))
            continue;
        ++faults;
        out << "stress: " << row.method << " under \"" << row.stress << "\", " << row.value << ": "
            << (row.stress == "bad input" ? "bad input is not refused" : row.why) << "\n";
    }
    return faults;
}

/// \param kept  a table of another run
/// \return      how many cells of that run are not the same here
inline int complain_of_differences(const std::vector<Row>& table, const std::string& kept, std::ostream& out)
{
    const std::vector<Row> before = read_table(kept);
    int faults = 0;
    for (const Row& was : before) {
        const Row* is = find_row(table, was.stress, was.level, was.method);
        if (is && to_line(*is) == to_line(was)) continue;
        ++faults;
        out << "stress: " << was.method << " under \"" << was.stress << "\", " << was.value
            << ": the score was " << fixed(was.score, 3) << " (at least " << was.lowest << "), ";
        if (is)
            out << "it is " << fixed(is->score, 3) << " (at least " << is->lowest << ", " << is->why << ")\n";
        else out << "it is gone\n";
    }
    if (table.size() != before.size()) {
        ++faults;
        out << "stress: there are " << table.size() << " cells, and " << before.size() << " in " << kept
            << "\n";
    }
    return faults;
}

}  // namespace rigid::stress
