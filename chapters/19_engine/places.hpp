/// \file places.hpp
/// Ids that stay valid: a place in a list, and how many things had it before.
///
///     valid  ⇔  the place is taken and its generation is that of the id
///
/// A place is used again, so lists do not grow with what has been removed; an id of what was there before is noticed by
/// its generation.
#pragma once

#include "chapters/19_engine/definitions.hpp"

#include <string>
#include <vector>

namespace rigid {

//! [places]
template <class Thing>
struct Places {
    std::vector<std::uint32_t> generation;  ///< of each place, from 1
    std::vector<char> taken;
    std::vector<std::uint32_t> free;  ///< the last one is used next
    int count = 0;                    ///< taken

    std::size_t size() const { return taken.size(); }
    bool has(Id<Thing> id) const
    {
        return id.place < taken.size() && taken[id.place] != 0 &&
               generation[id.place] == id.generation;
    }
    bool has(std::size_t place) const { return taken[place] != 0; }
    Id<Thing> id(std::size_t place) const
    {
        return {static_cast<std::uint32_t>(place), generation[place]};
    }
    /// Of all that are taken, in the order of their places.
    std::vector<Id<Thing>> all() const
    {
        std::vector<Id<Thing>> found;
        for (std::size_t place = 0; place < taken.size(); ++place)
            if (has(place)) found.push_back(id(place));
        return found;
    }
    /// A new place at the end.
    Id<Thing> append()
    {
        generation.push_back(1);
        taken.push_back(1);
        ++count;
        return id(taken.size() - 1);
    }
    /// One that is free.
    Id<Thing> take(std::size_t place)
    {
        std::erase(free, static_cast<std::uint32_t>(place));
        taken[place] = 1;
        ++generation[place];
        if (generation[place] == 0) generation[place] = 1;  // 0 names nothing
        ++count;
        return id(place);
    }
    void give_back(std::size_t place)
    {
        taken[place] = 0;
        free.push_back(static_cast<std::uint32_t>(place));
        --count;
    }
    /// Throws std::invalid_argument unless the id names something that is there.
    /// \param what  "body", "joint", "wall"
    std::size_t require(Id<Thing> id, const char* what) const
    {
        if (has(id)) return id.place;
        const std::string name = std::string("the ") + what + " " +
                                 std::to_string(id.place) + " of generation " +
                                 std::to_string(id.generation);
        if (!id)
            throw std::invalid_argument(std::string("there is no ") + what +
                                        " in the id; it must be one that add_" +
                                        what + "() returned");
        if (id.place < generation.size() && id.generation <= generation[id.place])
            throw std::invalid_argument(name + " was removed");
        throw std::invalid_argument(name + " is not of this world");
    }
};
//! [places]

}  // namespace rigid
