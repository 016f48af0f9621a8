// The short way of the cover from one surface to the next, so that the eye can follow.
#pragma once

#include "SurfaceMesh.h"

#include <QVariantAnimation>

#include <functional>

namespace bolster {

class CoverGlide {
public:
    /// `show` takes each step; the last one is the surface itself.
    explicit CoverGlide(std::function<void(const SurfaceMeshPtr&)> show);

    /// Else the last step comes at once.
    void setAnimated(bool animated) { m_animated = animated; }
    /// Both have the same topology.
    void start(SurfaceMeshPtr from, SurfaceMeshPtr to);
    /// The last step at once, if there are any to come.
    void finish();
    /// No more steps come.
    void stop();

private:
    SurfaceMeshPtr at(double share) const;

    std::function<void(const SurfaceMeshPtr&)> m_show;
    SurfaceMeshPtr m_from, m_to;
    QVariantAnimation m_steps;
    bool m_animated = true;
};

} // namespace bolster
