// Designs that differ a little from samples.
#pragma once

#include "Freedom.h"
#include "PreparedSheet.h"
#include "TestDesigns.h"

namespace bolster::test {

inline Design changedBy(const Design& design, const Freedom& freedom, double value)
{
    return withFreedoms(design, std::span(&freedom, 1), Eigen::VectorXd::Constant(1, value));
}

/// On triangles of that size, mm, so that covers are soon at rest.
inline Design coarseSample(const std::string& name, double edge)
{
    return withEdgeLength({sample(name), {}}, edge).design;
}

} // namespace bolster::test
