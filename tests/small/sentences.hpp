/// \file sentences.hpp
/// The sentences whose numbers can be dragged on the site (docs/tools/sentences.py): what each says is computed beside the small
/// program of its chapter, which is so compiled once.
#pragma once

#include <Eigen/Core>

#include <map>
#include <numbers>
#include <string>

using Numbers = std::map<std::string, double>;

/// A sentence of a text, by the name that sentences.csv has for it.
struct Sentence {
    Numbers (*values)(Numbers);
    double tolerance;  ///< relative to a number, or to one

    Sentence(const std::string& name, Numbers (*computes)(Numbers), double off)
        : values(computes), tolerance(off)
    {
        known().emplace(name, this);
    }
    static std::map<std::string, const Sentence*>& known()
    {
        static std::map<std::string, const Sentence*> all;
        return all;
    }
};

inline const Eigen::VectorXd two_zeros = Eigen::VectorXd::Zero(2);  ///< lower bounds of two contacts
constexpr double degree = std::numbers::pi / 180;
