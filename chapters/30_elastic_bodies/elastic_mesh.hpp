/// \file elastic_mesh.hpp
/// A body cut into elements: where its nodes are at rest, and which nodes make an element.
///
///     Dim = 1: bars of 2 nodes    Dim = 2: triangles of 3    Dim = 3: tetrahedra of 4
///     quadratic: one more node in the middle of each edge, 3, 6, 10 in total
///
/// The measure of an element (length, area, volume) is det(x₁ − x₀, …)/Dim! and must be
/// positive: its nodes are numbered counterclockwise, in space by the right hand.
#pragma once

#include "chapters/16_soft_constraints/block_solve.hpp"
#include "common/math.hpp"

#include <array>
#include <vector>

namespace rigid {

template <int Dim>
struct ElasticMesh {
    VecX rest;      ///< of the nodes, one behind the other [m], length Dim·N
    int order = 1;  ///< 1: corners alone; 2: and the middles of the edges
    std::vector<int> elements;  ///< per_element() nodes of each, corners first

    static constexpr int corners = Dim + 1;
    static constexpr int most_nodes = (Dim + 1) * (Dim + 2) / 2;
    int per_element() const { return order == 1 ? corners : most_nodes; }
    int nodes() const { return static_cast<int>(rest.size() / Dim); }
    int count() const { return static_cast<int>(elements.size()) / per_element(); }
    int node(int element, int i) const
    {
        return elements[static_cast<std::size_t>(element * per_element() + i)];
    }
    auto at(int node) const { return rest.template segment<Dim>(Dim * node); }
};

/// The pairs of corners that the middle nodes of a quadratic element lie between, in
/// the order of the nodes: (0, 1), (0, 2), (1, 2), (0, 3), …
template <int Dim>
constexpr std::array<std::array<int, 2>, Dim*(Dim + 1) / 2> edges_of_element()
{
    std::array<std::array<int, 2>, Dim*(Dim + 1) / 2> edges{};
    std::size_t n = 0;
    for (int b = 1; b <= Dim; ++b)
        for (int a = 0; a < b; ++a) edges[n++] = {a, b};
    return edges;
}

// The functions that follow throw std::invalid_argument for an element that is not there
// or has nodes that are not.

/// Length, area or volume of an element, negative where it is inverted [m, m², m³].
template <int Dim>
Real measure_of(const ElasticMesh<Dim>& mesh, int element);

/// The mean length of an edge of the first element [m]: what displacements are compared
/// with.
template <int Dim>
Real edge_length(const ElasticMesh<Dim>& mesh);

/// Throws std::invalid_argument, naming element or node and value, unless every element
/// has nodes that there are, and a positive measure (not flat: more than 1e-9 of its
/// longest edge to the power Dim), every node belongs to an element, and the further nodes
/// of a quadratic one are in the middle of its edges.
template <int Dim>
void require_valid(const ElasticMesh<Dim>& mesh);

/// The same body with a node more in the middle of each edge.
template <int Dim>
ElasticMesh<Dim> quadratic(const ElasticMesh<Dim>& mesh);

/// Two meshes as one, with no node in common.
template <int Dim>
ElasticMesh<Dim> joined(const ElasticMesh<Dim>& a, const ElasticMesh<Dim>& b);

// The meshes that follow throw std::invalid_argument for less than one of what they count
// (of a lattice two), naming it and its number.

/// A bar from 0 to `length` of equal elements.
ElasticMesh<1> bar_mesh(Real length, int elements);

enum class Diagonals : unsigned char {
    alternate,  ///< of neighbouring boxes: no direction is preferred, and it locks less
    parallel
};

/// A rectangle with its lower left corner at `corner`: nx·ny boxes of two triangles.
ElasticMesh<2> rectangle_mesh(const Vec2& corner, const Vec2& size, int nx, int ny,
                              Diagonals diagonals = Diagonals::alternate);

/// A disc in rings of triangles around its centre.
ElasticMesh<2> disc_mesh(const Vec2& centre, Real radius, int rings);

/// A quarter of a ring, from the axis x to the axis y: nr·na boxes of two triangles each.
/// \param grading  each layer is so many times as thick as the one within it
ElasticMesh<2> ring_mesh(Real inner, Real outer, int nr, int na, Real grading = 1);

/// Equilateral triangles of side `side` in `rows` rows of `columns` nodes.
ElasticMesh<2> lattice_mesh(Real side, int columns, int rows);

/// A block with its lower corner at `corner`: nx·ny·nz boxes of six tetrahedra around
/// one diagonal.
ElasticMesh<3> block_mesh(const Vec<3>& corner, const Vec<3>& size, int nx, int ny,
                          int nz);

/// A ball: an icosahedron whose triangles are quartered `finer` times, in shells around its
/// centre.
ElasticMesh<3> ball_mesh(const Vec<3>& centre, Real radius, int finer, int shells);

/// The outline of a plane mesh: pairs of nodes with the body to their left, from node to
/// node along the edge (a quadratic edge is two pairs).
std::vector<std::array<int, 2>> outline(const ElasticMesh<2>& mesh);

/// The surface of a mesh in space: triangles of nodes, counterclockwise from outside (a
/// quadratic one is four).
std::vector<std::array<int, 3>> surface_triangles(const ElasticMesh<3>& mesh);

/// The nodes on the surface of a mesh, ascending.
template <int Dim>
std::vector<int> surface_nodes(const ElasticMesh<Dim>& mesh);

#define RIGID_ELASTIC_MESH(D)                                                      \
    extern template Real measure_of(const ElasticMesh<D>&, int);                   \
    extern template Real edge_length(const ElasticMesh<D>&);                       \
    extern template void require_valid(const ElasticMesh<D>&);                     \
    extern template ElasticMesh<D> quadratic(const ElasticMesh<D>&);               \
    extern template ElasticMesh<D> joined(const ElasticMesh<D>&,                   \
                                          const ElasticMesh<D>&);                  \
    extern template std::vector<int> surface_nodes(const ElasticMesh<D>&);
RIGID_ELASTIC_MESH(1)
RIGID_ELASTIC_MESH(2)
RIGID_ELASTIC_MESH(3)
#undef RIGID_ELASTIC_MESH

}  // namespace rigid
