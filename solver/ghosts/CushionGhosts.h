// Cushioning and frame contact as soft targets (paper, section 4.2).
#pragma once

#include "FrameFields.h"
#include "Ghosts.h"
#include "Problem.h"
#include "SolveInput.h"

namespace bolster {

/// Pushes vertices outwards along a field of the frame: f_v = max(0, <n|f>) n, target p + f_v / 2, but never beyond
/// the surface of the field, or a large strength would overshoot from one side to the other.
class CushionGhosts : public GhostSource {
public:
    using Fields = std::vector<std::shared_ptr<const ForceField>>; ///< per sewn component; null: it is not pushed

    /// `strengths` by owner in the fields.
    CushionGhosts(ElementId element, double gamma, const Placement& frame, Fields fields,
                  std::vector<double> strengths);

    double gamma(const SewnMesh::Part& part) const override { return m_fields[part.component] ? m_gamma : 0; }
    void displace(const SheetMoment& sheet, const SewnMesh::Part& part, int begin, int end,
                  Columns& displacements) const override;
    void report(const SheetMoment& sheet, SolveReport& report) const override;
    void draw(FieldPicture& picture) const override;

private:
    Vec3 push(const SheetMoment& sheet, const SewnMesh::Part& part, int vertex) const;

    ElementId m_element;
    double m_gamma;
    Placement m_frame; ///< without the scale, which is in the fields
    Eigen::Matrix3d m_axes;
    Fields m_fields;
    std::vector<double> m_strengths;
};

/// For every enabled cushion that pushes at all. `problems` gets cushions whose fields would be too large or have
/// no voxels, parts too thin for them, and names of parts that the frame does not have. Gives up when stopped.
void addCushionGhosts(const SolveInput& input, const SewnMesh& mesh, FrameFields& fields, WorkerPool& pool,
                      const std::stop_token& stop, Ghosts& ghosts, Problems& problems);

/// For every frame with contact: a cover stays out of the parts that belong to it. `problems` likewise.
void addContactGhosts(const SolveInput& input, const SewnMesh& mesh, FrameFields& fields, WorkerPool& pool,
                      const std::stop_token& stop, Ghosts& ghosts, Problems& problems);

} // namespace bolster
