// What covers are compared with: a mesh, or points where the file holds no faces.
#pragma once

#include "CloudImport.h"
#include "MeshImport.h"
#include "Placement.h"

namespace bolster {

/// One of them, or a problem; neither when it was stopped.
struct ImportedForm {
    std::shared_ptr<const TriangleMesh> mesh;
    std::shared_ptr<const PointCloud> cloud;
    Message problem;
    FileFacts said{}; ///< of its numbers and axes
};

/// A damaged mesh is no cloud: what is wrong with it is said.
ImportedForm importForm(const QString& path, const ImportWatch& watch = {});

/// Where this puts it, mm.
ImportedForm placed(const ImportedForm& form, const Placement& placement);

} // namespace bolster
