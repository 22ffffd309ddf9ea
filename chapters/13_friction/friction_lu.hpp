/// \file friction_lu.hpp
/// The factor of a guess: the rows of A that are active, with the columns of sliding friction added to those of their normals.
///
///     λ_f = s μ λ_n  for a row that slides     ⇒     B_in = A_in + Σ s μ A_if,     B = L U
///
/// (13.8). B is not symmetric, but it has no entry where A has none: both rows of a contact move the same two bodies. So
/// chapter 9's elimination tree serves both triangles, and the factor costs twice what L D Lᵀ does.
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

    //! [factor]
    /// Factors the active rows. A pivot that is nothing gets its share of the
    /// diagonal instead: what that leaves behind, the steps of (13.10) take away.
    /// \param active  1: the row is an unknown
    /// \param tie     s μ of each box whose row slides, else 0
    /// \param shift   added to the diagonal, ε A_ii
    /// \param afresh  even if there is a factor of these rows
    void factor(const std::vector<char>& active, const VecX& tie, const VecX& shift,
                bool afresh = false)
    {
        if (!afresh && factored_ && active == active_ && tie == tie_) return;
        active_ = active;
        tie_ = tie;
        factored_ = true;
        old_ = false;
        ++factorisations;
        add_ties();
        const Elimination& e = elimination;
        const auto n = static_cast<int>(active.size());
        order_.clear();
        for (int k = 0; k < n; ++k) {
            const int i = at(e.order, k);
            at(end_, k) = at(e.column_begin, k);
            pivot_[k] = 0;  // zero = not active
            if (!at(active, i)) continue;
            for (int p = at(e.lower_begin, k); p < at(e.lower_begin, k + 1); ++p) {
                const int place = at(e.lower_value, p);
                row_y_[at(e.lower_column, p)] = at(B_, place);
                column_y_[at(e.lower_column, p)] = at(B_, at(mirror_, place));
            }
            Real d = at(B_, at(e.diagonal_value, k)) + shift[i];
            for (int p = at(e.row_begin, k); p < at(e.row_begin, k + 1); ++p) {
                const int j = at(e.row_columns, p);
                const Real y = row_y_[j], u = column_y_[j];
                row_y_[j] = column_y_[j] = 0;
                if (pivot_[j] == 0 || (y == 0 && u == 0)) continue;
                const Real l = y / pivot_[j];
                const int last = at(end_, j);
                changed += last - at(e.column_begin, j);
                for (int r = at(e.column_begin, j); r < last; ++r) {
                    row_y_[at(row_, r)] -= l * at(upper_, r);
                    column_y_[at(row_, r)] -= at(lower_, r) * u;
                }
                d -= l * u;
                at(row_, last) = k;
                at(lower_, last) = l;
                at(upper_, last) = u;
                at(end_, j) = last + 1;
            }
            if (!(std::abs(d) > 0.01 * shift[i])) d = d < 0 ? -shift[i] : shift[i];
            pivot_[k] = d;
            order_.push_back(k);
        }
    }
    //! [factor]

    /// Solves B x = b for the active rows in place.
    void solve(VecX& x)
    {
        const Elimination& e = elimination;
        for (const int k : order_) row_y_[k] = x[at(e.order, k)];
        for (const int j : order_)
            for (int r = at(e.column_begin, j); r < at(end_, j); ++r)
                row_y_[at(row_, r)] -= at(lower_, r) * row_y_[j];
        for (auto place = order_.rbegin(); place != order_.rend(); ++place) {
            const int j = *place;
            Real sum = row_y_[j];
            for (int r = at(e.column_begin, j); r < at(end_, j); ++r)
                sum -= at(upper_, r) * row_y_[at(row_, r)];
            row_y_[j] = sum / pivot_[j];
        }
        for (const int k : order_) {
            x[at(e.order, k)] = row_y_[k];
            row_y_[k] = 0;
        }
    }

    /// The next factor is a new one.
    void forget() { factored_ = false; }

private:
    /// Where each entry's mirror image is, and where column f of a box meets column n; false if A has no entry there.
    bool use(const SparseMatrix& A, std::span<const FrictionBox> boxes)
    {
        elimination.analyse_pattern(A);
        A_ = &A;
        const auto same = [](const FrictionBox& a, const FrictionBox& b) {
            return a.row == b.row && a.normal == b.normal;
        };
        const bool known = std::equal(boxes.begin(), boxes.end(), boxes_.begin(),
                                      boxes_.end(), same);
        boxes_.assign(boxes.begin(), boxes.end());
        if (known && !elimination.analysed) return fits_;
        factored_ = false;
        const int* const outer = A.outerIndexPtr();
        const int* const inner = A.innerIndexPtr();
        const auto n = static_cast<int>(A.rows());
        next_.assign(outer, outer + n);
        mirror_.resize(static_cast<std::size_t>(A.nonZeros()));
        for (int i = 0; i < n; ++i)
            for (int p = outer[i]; p < outer[i + 1]; ++p)
                at(mirror_, p) = at(next_, inner[p])++;
        meets_.clear();
        fits_ = true;
        for (const FrictionBox& box : boxes_)
            for (auto p = outer[box.row]; p < outer[box.row + 1]; ++p) {
                const int *const begin = inner + outer[inner[p]],
                                 *const end = inner + outer[inner[p] + 1];
                const int* const found =
                    std::lower_bound(begin, end, static_cast<int>(box.normal));
                fits_ = fits_ && found != end && *found == box.normal;
                meets_.push_back(static_cast<int>(found - inner));
            }
        const auto room = static_cast<std::size_t>(elimination.entries());
        row_.resize(room);
        lower_.resize(room);
        upper_.resize(room);
        end_.resize(static_cast<std::size_t>(n));
        pivot_.resize(n);
        row_y_.setZero(n);
        column_y_.setZero(n);
        return fits_;
    }

    /// A with zeros written down where column n gets something of column f.
    void close(const SparseMatrix& A, std::span<const FrictionBox> boxes)
    {
        std::vector<Eigen::Triplet<Real>> entries;
        for (int i = 0; i < A.rows(); ++i) {
            entries.emplace_back(i, i, 0.0);
            for (SparseMatrix::InnerIterator a(A, i); a; ++a)
                entries.emplace_back(i, static_cast<int>(a.col()), a.value());
        }
        for (const FrictionBox& box : boxes)
            for (SparseMatrix::InnerIterator a(A, box.row); a; ++a) {
                const auto i = static_cast<int>(a.col()),
                           n = static_cast<int>(box.normal);
                entries.emplace_back(i, n, 0.0);
                entries.emplace_back(n, i, 0.0);
            }
        closed_.resize(A.rows(), A.cols());
        closed_.setFromTriplets(entries.begin(), entries.end());
    }

    /// (13.8): B in the pattern of A.
    void add_ties()
    {
        const int* const outer = A_->outerIndexPtr();
        const Real* const value = A_->valuePtr();
        B_.assign(value, value + A_->nonZeros());
        std::size_t meets = 0;
        for (std::size_t k = 0; k < boxes_.size(); ++k) {
            const auto f = boxes_[k].row;
            const Real s = tie_[static_cast<Index>(k)];
            for (auto p = outer[f]; p < outer[f + 1]; ++p, ++meets)
                if (s != 0) at(B_, meets_[meets]) += s * value[p];
        }
    }

    const SparseMatrix* A_ = nullptr;
    SparseMatrix closed_;
    std::vector<FrictionBox> boxes_;
    bool fits_ = false, factored_ = false, old_ = false;
    std::vector<int> mirror_, meets_, next_, row_, end_, order_;
    std::vector<Real> B_, lower_, upper_;
    std::vector<char> active_;
    VecX tie_, pivot_, row_y_, column_y_;
};

}  // namespace rigid
