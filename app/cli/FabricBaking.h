// The maps of a design's fabrics, with the pictures that they are made of.
#pragma once

#include "Design.h"
#include "FabricMaps.h"
#include "Problem.h"
#include "Unfinished.h"

#include <QString>

#include <map>
#include <stop_token>

namespace bolster::cli {

/// What is wrong with the pictures of fabrics that are there; `path`: of a design or project.
Problems pictureProblems(const QString& path, const Design& design, const std::stop_token& stop);

class FabricBaking {
public:
    /// `path`: of a design or project.
    FabricBaking(const QString& path, const Design& design, int threads, std::stop_token stop);

    /// Bakes each fabric once. A picture that is missing or refused is a line on stderr, and a tile that shows it.
    FabricMapsPtr operator()(ElementId id, const Fabric& fabric);

private:
    const Design& m_design;
    WorkFolder m_extracted; ///< of a project
    QString m_folder;
    int m_threads;
    std::stop_token m_stop;
    std::map<ElementId, FabricMapsPtr> m_baked;
};

} // namespace bolster::cli
