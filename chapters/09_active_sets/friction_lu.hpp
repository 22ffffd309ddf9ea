/// \file friction_lu.hpp
/// The factor of a guess: the rows of A that are active, with the columns of sliding friction added to those of their normals.
///
///     λ_f = s μ λ_n  for a row that slides     ⇒     B_in = A_in + Σ s μ A_if,     B = L U
///
/// (9.21), which is (13.8). B is not symmetric, but it has no entry where A has none: both rows of a contact move the same
/// two bodies. So one elimination tree serves both triangles, and the factor costs twice what L D Lᵀ does.
#pragma once

#include "chapters/09_active_sets/elimination.hpp"
#include "chapters/09_active_sets/friction_boxes.hpp"

namespace rigid {

class FrictionLu {
    template <class List>
    static auto& at(List& list, int i)
    {
        return list[static_cast<std::size_t>(i)];
    }

public:
    Elimination elimination;
    int factorisations = 0;    ///< since the beginning
    std::int64_t changed = 0;  ///< entries, by them

    /// Finds the pattern, unless it is the one of last time: then the last factor is an old one, and may still do. A must
    /// stay where it is.
    void analyse(const SparseMatrix& A, std::span<const FrictionBox> boxes)
    {
        old_ = true;
        if (use(A, boxes)) return;
        close(A, boxes);
        use(closed_, boxes);
    }
    /// Whether the factor is of an A of the same pattern, but of an earlier solve.
    bool is_old() const { return old_; }
    /// Whether there is a factor, if an old one, of rows of this pattern.
    bool is_of_these_rows() const { return factored_; }

    /// Factors the active rows. A pivot that is nothing gets its share of the
    /// diagonal instead: what that leaves behind, the steps of (13.10) take away.
    /// \param active  1: the row is an unknown
    /// \param tie     s μ of each box whose row slides, else 0
    /// \param shift   added to the diagonal, ε A_ii
    /// \param afresh  even if there is a factor of these rows
    void factor(const std::vector<char>& active, const VecX& tie, const VecX& shift,
                bool afresh = false);

    /// Solves B x = b for the active rows in place.
    void solve(VecX& x);

    /// The next factor is a new one.
    void forget() { factored_ = false; }

private:
    /// Where each entry's mirror image is, and where column f of a box meets column n; false if A has no entry there.
    bool use(const SparseMatrix& A, std::span<const FrictionBox> boxes);

    /// A with zeros written down where column n gets something of column f.
    void close(const SparseMatrix& A, std::span<const FrictionBox> boxes);

    /// (13.8): B in the pattern of A.
    void add_ties();

    const SparseMatrix* A_ = nullptr;
    SparseMatrix closed_;
    std::vector<FrictionBox> boxes_;
    bool fits_ = false, factored_ = false, old_ = false;
    std::vector<int> mirror_, meets_, next_, end_, order_;
    std::vector<Real> B_;
    std::vector<char> active_;
    VecX tie_, pivot_, row_y_, column_y_;
    /// of the entries of both factors, column by column; not filled with zeros: a large part is never used
    Eigen::VectorXi row_;
    VecX lower_, upper_;
};

}  // namespace rigid
