/// \file draws.hpp
/// Finds two random draws whose order the language leaves to the compiler.
///
///     Vec2(random.uniform(), random.uniform())      g++ draws the second argument first, clang++ the first
///     random.normal() * random.uniform()            the same for most operators
///
/// Braces, `;`, `&&`, `||`, `?:`, `<<`, `>>`, and a comma outside an argument list do order what they part.
/// A small reader of C++ for the sources of this book: it sees brackets, names and operators, no types.
#pragma once

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

namespace rigid::draws {

struct Token {
    std::string text;
    int line = 1;
};

inline bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The tokens of a source without comments, preprocessor lines, and the insides of literals.
inline std::vector<Token> tokens_of(const std::string& text)
{
    std::vector<Token> tokens;
    int line = 1;
    bool fresh = true;  // nothing but blanks on this line so far
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        const std::string two = text.substr(i, 2);
        if (c == '\n') {
            ++line, ++i;
            fresh = true;
            continue;
        }
        if (std::isspace(static_cast<unsigned char>(c))) {
            ++i;
            continue;
        }
        std::size_t end = i + 1;
        if (two == "//" || (c == '#' && fresh)) end = std::min(text.find('\n', i), text.size());
        else if (two == "/*") end = std::min(text.find("*/", i), text.size() - 2) + 2;
        else if (two == "R\"") {
            const std::size_t open = text.find('(', i);
            const std::string close = ')' + text.substr(i + 2, open - i - 2) + '"';
            end = std::min(text.find(close, open), text.size() - close.size()) + close.size();
        } else if (c == '"' || (c == '\'' && (i == 0 || !is_name(text[i - 1])))) {
            while (end < text.size() && text[end] != c) end += text[end] == '\\' ? 2 : 1;
            tokens.push_back({"literal", line});
            ++end;
        } else if (is_name(c)) {
            while (end < text.size() && (is_name(text[end]) || (text[end] == '\'' && std::isdigit(c)))) ++end;
            tokens.push_back({text.substr(i, end - i), line});
        } else if (two == "&&" || two == "||" || two == "<<" || two == ">>" || two == "::" || two == "->") {
            end = i + 2;
            tokens.push_back({two, line});
        } else tokens.push_back({std::string(1, c), line});
        end = std::min(end, text.size());
        line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                            text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
        i = end;
        fresh = false;
    }
    return tokens;
}

class Finder {
public:
    explicit Finder(const std::string& text) : tokens_(tokens_of(text))
    {
        // What is of type Random, and lambdas without arguments that draw by themselves.
        for (std::size_t i = 0; i + 1 < tokens_.size(); ++i)
            if (at(i) == "Random") generators_.insert(at(i + 1) == "&" ? at(i + 2) : at(i + 1));
        generators_.insert("random");
        find_lambdas();
    }

    /// The lines where the order of two draws is left open.
    std::vector<int> lines()
    {
        std::size_t i = 0;
        while (i < tokens_.size()) {
            list(i, "");
            ++i;  // a closing bracket too many: not ours to judge
        }
        std::sort(lines_.begin(), lines_.end());
        lines_.erase(std::unique(lines_.begin(), lines_.end()), lines_.end());
        return lines_;
    }

private:
    std::string at(std::size_t i) const { return i < tokens_.size() ? tokens_[i].text : ""; }

    void find_lambdas()
    {
        for (std::size_t i = 0; i + 3 < tokens_.size(); ++i) {
            if (at(i) != "auto" || at(i + 2) != "=" || at(i + 3) != "[") continue;
            std::size_t k = i + 3;
            while (k < tokens_.size() && at(k) != "{" && at(k) != ";") ++k;
            int depth = 0;
            for (; k < tokens_.size(); ++k) {
                if (at(k) == "{") ++depth;
                if (at(k) == "}" && --depth == 0) break;
                if (draws_itself(k)) lambdas_.insert(at(i + 1));
                if (depth == 0) break;
            }
        }
    }

    /// random.uniform( …
    bool draws_itself(std::size_t i) const
    {
        const std::string& what = at(i + 2);
        return (at(i + 1) == "." || at(i + 1) == "->") && generators_.count(at(i)) &&
               (what == "uniform" || what == "normal" || what == "index");
    }

    /// Reads up to the closing bracket of `open` ("" = to the end of the file) and says whether it draws. `i` is behind
    /// the opening bracket at first and on the closing one at last.
    bool list(std::size_t& i, const std::string& open)
    {
        bool any = false;
        int in_list = 0;     // arguments so far that draw
        int in_operand = 0;  // operands of this expression so far that draw
        bool argument = false;
        const auto end_argument = [&] {
            if (argument && ++in_list == 2 && open == "(")
                lines_.push_back(tokens_[std::min(i, tokens_.size() - 1)].line);
            argument = false;
            in_operand = 0;
        };
        const auto drew = [&](std::size_t where) {
            any = argument = true;
            if (++in_operand == 2) lines_.push_back(tokens_[where].line);
        };
        for (; i < tokens_.size(); ++i) {
            const std::string& t = at(i);
            if (t == ")" || t == "]" || t == "}") break;
            if (t == "," || t == ";") {
                end_argument();
                if (t == ";") in_list = 0;
            } else if (t == "?" || t == ":" || t == "&&" || t == "||" || t == "<<" || t == ">>") {
                in_operand = 0;
            } else if (t == "=" && at(i + 1) != "=") {
                in_operand = 0;
            } else if (t == "(" || t == "[" || t == "{") {
                const std::size_t opened = i;
                const std::string before = opened > 0 ? at(opened - 1) : "";
                // A body of a function, a lambda or a branch: what it draws is drawn at another time.
                const bool body =
                    t == "{" && (before == ")" || before == "]" || before == "else" || before == "const" ||
                                 before == "override" || before == "mutable" || before == "do");
                const bool test = t == "(" && (before == "if" || before == "while" || before == "for" ||
                                               before == "switch");
                const bool one_draw = counted_;
                counted_ = false;
                ++i;
                const bool inside = list(i, test ? "{" : t);
                if (inside && !body && !test && !one_draw) drew(opened);
                if (body || test) in_operand = 0, argument = body ? argument : false;
            } else if (draws_itself(i)) {
                drew(i);
                i += 2;
                counted_ = at(i + 1) == "(";  // its own arguments belong to this draw
            } else if (lambdas_.count(t) && at(i + 1) == "(" && at(i + 2) == ")") {
                drew(i);
            } else if (generators_.count(t) && (at(i - 1) == "(" || at(i - 1) == ",") &&
                       (at(i + 1) == ")" || at(i + 1) == ",") && open == "(") {
                any = true;  // passed on: the call that gets it draws, after all of its arguments are known
            }
        }
        end_argument();
        return any;
    }

    std::vector<Token> tokens_;
    std::set<std::string> generators_, lambdas_;
    std::vector<int> lines_;
    bool counted_ = false;
};

/// The lines of a source where the order of two draws is left to the compiler.
inline std::vector<int> unordered(const std::string& text) { return Finder(text).lines(); }

}  // namespace rigid::draws
