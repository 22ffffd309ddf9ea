/// \file bytes.hpp
/// Numbers as bytes and back, the same on every machine: eight bytes each, the lowest first.
///
/// One list of members serves both ways, so that what is written is what is read:
///
///     template <class Archive> void members(Archive& io, Thing& thing) { io(thing.a, thing.b); }
///
/// Bits are kept as they are: a number comes back as itself, with its sign of zero and its last digit.
#pragma once

#include "common/math.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace rigid {

/// FNV-1a, a number of any bytes.
inline std::uint64_t hash_of(std::string_view bytes)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : bytes)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

//! [writer]
class Writer {
public:
    static constexpr bool reads = false;
    std::string bytes;

    template <class... Things>
    void operator()(Things&&... things)
    {
        (one(things), ...);
    }
    //! [writer]

    template <Number T>
    void one(const T& number)
    {
        std::uint64_t bits = 0;
        if constexpr (std::is_same_v<T, Real>)
            bits = Eigen::numext::bit_cast<std::uint64_t>(number);
        else bits = static_cast<std::uint64_t>(number);
        for (int i = 0; i < 8; ++i)
            bytes.push_back(static_cast<char>(bits >> 8 * i & 0xff));
    }
    /// How many there are, and back.
    std::size_t size(std::size_t count)
    {
        one(count);
        return count;
    }
    void one(const std::string& text)
    {
        one(text.size());
        bytes += text;
    }
    template <int Rows, int Columns>
    void one(const Eigen::Matrix<Real, Rows, Columns>& v)
    {
        one(v.size());
        for (Index i = 0; i < v.size(); ++i) one(v[i]);
    }
    template <class T>
    void one(const std::vector<T>& list)
    {
        one(list.size());
        for (const T& thing : list) one(thing);
    }
    template <class T, std::size_t N>
    void one(const std::array<T, N>& list)
    {
        for (const T& thing : list) one(thing);
    }
    template <class T>
    void one(const std::optional<T>& thing)
    {
        one(thing.has_value());
        if (thing) one(*thing);
    }
    template <class T>
    requires(!Number<T>) void one(const T& thing)
    {
        members(*this, const_cast<T&>(thing));  // a writer changes nothing
    }
};

//! [reader]
/// Throws std::invalid_argument where the bytes end too soon, or hold a number that the
/// thing cannot have.
class Reader {
public:
    static constexpr bool reads = true;
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    template <class... Things>
    void operator()(Things&&... things)
    {
        (one(things), ...);
    }
    bool at_end() const { return bytes_.empty(); }
    //! [reader]

    template <Number T>
    void one(T& number)
    {
        if (bytes_.size() < 8) refuse();
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < 8; ++i)
            bits |= std::uint64_t{static_cast<unsigned char>(bytes_[i])} << 8 * i;
        bytes_.remove_prefix(8);
        if constexpr (std::is_same_v<T, Real>)
            number = Eigen::numext::bit_cast<Real>(bits);
        else {
            number = static_cast<T>(bits);
            if (static_cast<std::uint64_t>(number) != bits) refuse();
        }
    }
    /// How many are to come: no more than bytes are left.
    std::size_t size(std::size_t = 0)
    {
        std::uint64_t count = 0;
        one(count);
        if (count > bytes_.size()) refuse();
        return static_cast<std::size_t>(count);
    }
    void one(std::string& text)
    {
        const std::size_t count = size();
        text.assign(bytes_.substr(0, count));
        bytes_.remove_prefix(count);
    }
    template <int Rows, int Columns>
    void one(Eigen::Matrix<Real, Rows, Columns>& v)
    {
        const auto count = static_cast<Index>(size());
        if constexpr (Rows == Eigen::Dynamic) v.resize(count);
        else if (count != v.size()) refuse();
        for (Index i = 0; i < count; ++i) one(v[i]);
    }
    template <class T>
    void one(std::vector<T>& list)
    {
        list.resize(size());
        for (T& thing : list) one(thing);
    }
    template <class T, std::size_t N>
    void one(std::array<T, N>& list)
    {
        for (T& thing : list) one(thing);
    }
    template <class T>
    void one(std::optional<T>& thing)
    {
        bool given = false;
        one(given);
        if (given) one(thing.emplace());
        else thing.reset();
    }
    template <class T>
    requires(!Number<T>) void one(T& thing) { members(*this, thing); }

    [[noreturn]] static void refuse()
    {
        throw std::invalid_argument("the bytes are not those of a world: they end "
                                    "too soon or hold a number "
                                    "that it cannot have");
    }

private:
    std::string_view bytes_;
};

}  // namespace rigid
