/// \file exact.hpp
/// The exact ways to solve an MLCP, the truth of all later tests: `enumerate`, `direct` and `schur`.
#pragma once

#include "chapters/03_mlcp_formulation/direct.hpp"
#include "chapters/03_mlcp_formulation/enumeration.hpp"
#include "chapters/03_mlcp_formulation/schur.hpp"
