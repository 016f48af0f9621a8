// What the files hold that a design refers to.
#pragma once

#include "ElementId.h"
#include "PointCloud.h"
#include "TriangleMesh.h"

#include <map>
#include <memory>

namespace bolster {

/// By element. What is still being read, or cannot be read, is not here; a mesh or cloud that is here never
/// changes.
struct DesignFiles {
    std::map<ElementId, std::shared_ptr<const TriangleMesh>> meshes;
    std::map<ElementId, std::shared_ptr<const PointCloud>> clouds;

    friend bool operator==(const DesignFiles&, const DesignFiles&) = default;
};

} // namespace bolster
