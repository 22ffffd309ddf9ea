// The functions of problem_reader.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/problem_reader.hpp"

namespace rigid {

Problem ProblemReader::read()
{
    while (next_line()) {
        const std::string key = words_.front();
        if (!given_.emplace(key, line_).second)
            refuse(quoted(key) + " is there twice, first in line " +
                   std::to_string(given_.at(key)));
        if (key == "name" || key == "n" || key == "solution") read_key(key);
        else read_section(key);
    }
    ++line_;  // what is missing is missing after the last line
    for (const char* key : {"n", "A", "q"})
        if (!given_.count(key))
            refuse("the file ends here, and " + quoted(key) + " is missing");
    require_bounds();
    return std::move(problem_);
}

bool ProblemReader::next_line()
{
    std::string text;
    while (next_text(text)) {
        std::istringstream stream(text.substr(0, text.find('#')));
        words_.clear();
        for (std::string word; stream >> word;) words_.push_back(word);
        if (!words_.empty()) return true;
    }
    return false;
}

bool ProblemReader::next_text(std::string& text)
{
    text.clear();
    std::streambuf& bytes = *in_.rdbuf();
    constexpr int end = std::char_traits<char>::eof();
    int c = bytes.sbumpc();
    if (c == end) return false;
    ++line_;
    for (; c != end && c != '\n'; c = bytes.sbumpc()) {
        if (text.size() == longest_line)
            refuse("the line has more than " + std::to_string(longest_line) +
                   " characters; a row of the largest problem has fewer");
        text.push_back(static_cast<char>(c));
    }
    return true;
}

void ProblemReader::read_key(const std::string& key)
{
    if (words_.size() != 2)
        refuse(quoted(key) + " has " + std::to_string(words_.size() - 1) +
               " values on its line; it must have one");
    const std::string& value = words_[1];
    if (key == "name") problem_.name = value;
    if (key == "n") {
        const auto n = parse_whole(value);
        if (!n || *n < 1 || *n > static_cast<std::uint64_t>(largest_problem))
            refuse("n is " + quoted(value) +
                   "; it must be a whole number from 1 to " +
                   std::to_string(largest_problem));
        const auto rows = static_cast<Index>(*n);
        problem_.mlcp.A.resize(rows, rows);
        problem_.mlcp.lo = VecX::Zero(rows);
        problem_.mlcp.hi = VecX::Constant(rows, infinity);
    }
    if (key == "solution") {
        for (const Uniqueness kind : {Uniqueness::unique, Uniqueness::w_unique,
                                      Uniqueness::any, Uniqueness::none})
            if (value == to_string(kind)) problem_.kind = kind;
        if (problem_.kind == Uniqueness::not_examined)
            refuse("the solution is " + quoted(value) +
                   "; it must be unique, w_unique, any or none");
    }
}

void ProblemReader::read_section(const std::string& key)
{
    const std::map<std::string, VecX*> sections = {{"q", &problem_.mlcp.q},
                                                   {"lo", &problem_.mlcp.lo},
                                                   {"hi", &problem_.mlcp.hi},
                                                   {"z", &problem_.z},
                                                   {"w", &problem_.w}};
    if (key != "A" && !sections.count(key))
        refuse(quoted(key) + " is no key and no section; the keys are name, n "
                             "and solution, the sections "
                             "A, q, lo, hi, z and w");
    if (words_.size() > 1)
        refuse("the name of the section " + quoted(key) +
               " must stand alone on its line");
    if (!given_.count("n"))
        refuse("section " + quoted(key) + " begins before n was given");
    const Index n = problem_.mlcp.A.rows();
    if (key != "A") {
        *sections.at(key) = numbers(key, "section " + quoted(key), n);
        if (key == "lo" || key == "hi") bounds_line_ = line_;
        return;
    }
    std::vector<Eigen::Triplet<Real>> entries;
    for (Index i = 0; i < n; ++i) {
        const VecX line = numbers(key, "row " + std::to_string(i + 1) + " of A", n);
        for (Index j = 0; j < n; ++j)
            if (line[j] < 0 || line[j] > 0)
                entries.emplace_back(static_cast<int>(i), static_cast<int>(j),
                                     line[j]);
    }
    problem_.mlcp.A.setFromTriplets(entries.begin(), entries.end());
}

VecX ProblemReader::numbers(const std::string& key, const std::string& what,
                            Index n)
{
    if (!next_line()) {
        ++line_;
        refuse("the file ends where " + what + " should be");
    }
    if (static_cast<Index>(words_.size()) != n)
        refuse(what + " has " + std::to_string(words_.size()) +
               " entries; it must have " + std::to_string(n));
    VecX result(n);
    for (Index i = 0; i < n; ++i) {
        const std::string& word = words_[static_cast<std::size_t>(i)];
        const auto value = parse_real(word);
        if (value) result[i] = *value;
        else if (key == "hi" && (word == "inf" || word == "+inf"))
            result[i] = infinity;
        else if (key == "lo" && word == "-inf") result[i] = -infinity;
        else
            refuse(what + " has the entry " + quoted(word) +
                   "; it must be a finite number" +
                   (key == "hi"   ? " or inf"
                    : key == "lo" ? " or -inf"
                                  : ""));
    }
    return result;
}

void ProblemReader::require_bounds()
{
    line_ = bounds_line_;
    const Mlcp& mlcp = problem_.mlcp;
    for (Index i = 0; i < mlcp.A.rows(); ++i)
        if (!(mlcp.lo[i] <= mlcp.hi[i]))
            refuse("entry " + std::to_string(i + 1) + " has lo = " +
                   shortest(mlcp.lo[i]) + " and hi = " + shortest(mlcp.hi[i]) +
                   "; lo must not be above hi (without a section lo is 0)");
}

}  // namespace rigid
