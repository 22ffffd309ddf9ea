// The functions of friction_islands.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/friction_islands.hpp"

namespace rigid {

ExactFrictionIslands::Room& ExactFrictionIslands::room_of(Index n)
{
    const auto number = static_cast<std::size_t>(n);
    if (rooms.size() <= number) rooms.resize(number + 1);
    Room& room = rooms[number];
    if (room.mlcp.size() != n) {
        room.mlcp.A = MatX::Ones(n, n).sparseView();
        room.mlcp.q = room.mlcp.lo = room.mlcp.hi = VecX::Zero(n);
        room.solution.lambda = VecX::Zero(n);
    }
    return room;
}

}  // namespace rigid
