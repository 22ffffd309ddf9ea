/// \file eigen_instances.hpp
/// The functions of Eigen that are slow to compile and that many sources of the book call: factorisations and the
/// kernels of products. Declared here, compiled once in eigen_instances.cpp; one by one, because what nobody calls
/// takes longer than they. Sources of the library include this file first, the precompiled headers have it; no other
/// header does: without it a source compiles its own copies, with the same bits.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#ifndef RIGID_INSTANCE
#define RIGID_INSTANCE extern template
#endif

// Some of these names are Eigen's own business: only for the versions that have them.
#if EIGEN_VERSION_AT_LEAST(3, 4, 0) && !EIGEN_VERSION_AT_LEAST(3, 4, 90)

namespace rigid::instances {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 32, 32>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 32, 1>;
using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor>;
using Index = Eigen::Index;

using Kernel = Eigen::internal::gebp_traits<double, double>;
using Block = Eigen::internal::blas_data_mapper<double, Index, Eigen::ColMajor, Eigen::Unaligned, 1>;
using ByColumns = Eigen::internal::const_blas_data_mapper<double, Index, Eigen::ColMajor>;
using ByRows = Eigen::internal::const_blas_data_mapper<double, Index, Eigen::RowMajor>;

}  // namespace rigid::instances

namespace Eigen {

RIGID_INSTANCE void PartialPivLU<rigid::instances::Matrix>::compute();
RIGID_INSTANCE void FullPivLU<rigid::instances::SmallMatrix>::computeInPlace();
RIGID_INSTANCE void
FullPivLU<rigid::instances::SmallMatrix>::_solve_impl(const rigid::instances::SmallVector&,
                                                      rigid::instances::SmallVector&) const;
RIGID_INSTANCE void ColPivHouseholderQR<rigid::instances::Matrix>::computeInPlace();
RIGID_INSTANCE void
ColPivHouseholderQR<rigid::instances::Matrix>::_solve_impl(const rigid::instances::Vector&,
                                                           rigid::instances::Vector&) const;
RIGID_INSTANCE void SimplicialCholeskyBase<SimplicialLDLT<rigid::instances::Columns>>::ordering(
    const rigid::instances::Columns&, const rigid::instances::Columns*&, rigid::instances::Columns&);
RIGID_INSTANCE void
SimplicialCholeskyBase<SimplicialLDLT<rigid::instances::Columns>>::analyzePattern_preordered(
    const rigid::instances::Columns&, bool);
RIGID_INSTANCE void
SimplicialCholeskyBase<SimplicialLDLT<rigid::instances::Columns>>::factorize_preordered<true>(
    const rigid::instances::Columns&);

namespace internal {

namespace ri = rigid::instances;

RIGID_INSTANCE void minimum_degree_ordering<double, int>(SparseMatrix<double, ColMajor, int>&,
                                                         PermutationMatrix<Dynamic, Dynamic, int>&);
RIGID_INSTANCE struct partial_lu_impl<double, ColMajor, int, Dynamic>;
RIGID_INSTANCE struct gebp_kernel<double, double, Index, ri::Block, ri::Kernel::mr, ri::Kernel::nr, false,
                                  false>;
RIGID_INSTANCE struct gemm_pack_lhs<double, Index, ri::ByColumns, ri::Kernel::mr, ri::Kernel::LhsProgress,
                                    ri::Kernel::LhsPacket4Packing, ColMajor, false>;
RIGID_INSTANCE struct gemm_pack_lhs<double, Index, ri::ByRows, ri::Kernel::mr, ri::Kernel::LhsProgress,
                                    ri::Kernel::LhsPacket4Packing, RowMajor, false>;
RIGID_INSTANCE struct gemm_pack_rhs<double, Index, ri::ByColumns, ri::Kernel::nr, ColMajor, false>;
RIGID_INSTANCE struct gemm_pack_rhs<double, Index, ri::ByRows, ri::Kernel::nr, RowMajor, false>;
RIGID_INSTANCE struct general_matrix_vector_product<Index, double, ri::ByColumns, ColMajor, false, double,
                                                    ri::ByColumns, false>;
RIGID_INSTANCE struct general_matrix_vector_product<Index, double, ri::ByRows, RowMajor, false, double,
                                                    ri::ByRows, false>;
RIGID_INSTANCE struct general_matrix_vector_product<Index, double, ri::ByRows, RowMajor, false, double,
                                                    ri::ByColumns, false>;

}  // namespace internal
}  // namespace Eigen

#endif
