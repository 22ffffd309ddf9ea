// The functions of friction_lu.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/friction_lu.hpp"

namespace rigid {

//! [factor]
void FrictionLu::factor(const std::vector<char>& active, const VecX& tie,
                        const VecX& shift, bool afresh)
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
                row_y_[row_[r]] -= l * upper_[r];
                column_y_[row_[r]] -= lower_[r] * u;
            }
            d -= l * u;
            row_[last] = k;
            lower_[last] = l;
            upper_[last] = u;
            at(end_, j) = last + 1;
        }
        if (!(std::abs(d) > 0.01 * shift[i])) d = d < 0 ? -shift[i] : shift[i];
        pivot_[k] = d;
        order_.push_back(k);
    }
}
//! [factor]

void FrictionLu::solve(VecX& x)
{
    const Elimination& e = elimination;
    for (const int k : order_) row_y_[k] = x[at(e.order, k)];
    for (const int j : order_)
        for (int r = at(e.column_begin, j); r < at(end_, j); ++r)
            row_y_[row_[r]] -= lower_[r] * row_y_[j];
    for (auto place = order_.rbegin(); place != order_.rend(); ++place) {
        const int j = *place;
        Real sum = row_y_[j];
        for (int r = at(e.column_begin, j); r < at(end_, j); ++r)
            sum -= upper_[r] * row_y_[row_[r]];
        row_y_[j] = sum / pivot_[j];
    }
    for (const int k : order_) {
        x[at(e.order, k)] = row_y_[k];
        row_y_[k] = 0;
    }
}

bool FrictionLu::use(const SparseMatrix& A, std::span<const FrictionBox> boxes)
{
    elimination.analyse_pattern(A);
    A_ = &A;
    const auto same = [](const FrictionBox& a, const FrictionBox& b) {
        return a.row == b.row && a.normal == b.normal;
    };
    const bool known =
        std::equal(boxes.begin(), boxes.end(), boxes_.begin(), boxes_.end(), same);
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
    fits_ = std::all_of(elimination.diagonal_value.begin(),
                        elimination.diagonal_value.end(),
                        [](int place) { return place >= 0; });
    for (const FrictionBox& box : boxes_)
        for (auto p = outer[box.row]; p < outer[box.row + 1]; ++p) {
            const int *const begin = inner + outer[inner[p]],
                             *const end = inner + outer[inner[p] + 1];
            const int* const found =
                std::lower_bound(begin, end, static_cast<int>(box.normal));
            fits_ = fits_ && found != end && *found == box.normal;
            meets_.push_back(static_cast<int>(found - inner));
        }
    const Index room = elimination.entries();
    row_.resize(room);
    lower_.resize(room);
    upper_.resize(room);
    end_.resize(static_cast<std::size_t>(n));
    pivot_.resize(n);
    row_y_.setZero(n);
    column_y_.setZero(n);
    return fits_;
}

void FrictionLu::close(const SparseMatrix& A, std::span<const FrictionBox> boxes)
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

void FrictionLu::add_ties()
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

}  // namespace rigid
