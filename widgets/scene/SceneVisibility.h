// Which of its parts the 3D view shows. Not a part of the design.
#pragma once

#include "Design.h"

#include <QObject>

#include <set>

namespace bolster {

class SceneVisibility : public QObject {
    Q_OBJECT

public:
    /// What can be shown and hidden as a whole.
    enum class Layer {
        Cover,
        Checker,
        MeshEdges,
        Seams,
        Frames,
        FixationCurves,
        HandleCurves,
        FancySeams,
        Scans,
        ScanPairs,
        ScanColors, ///< of scans whose points have colours of their own
        Ground,
        Field,
        Twins,   ///< the mirror image of what is selected
        Symmetry ///< the plane
    };
    Q_ENUM(Layer)

    using QObject::QObject;

    void setLayerVisible(bolster::SceneVisibility::Layer layer, bool visible);
    bool layerVisible(Layer layer) const { return m_layers.contains(layer); }

    /// What is not shown, until it is shown again.
    void setHidden(std::set<bolster::ElementId> hidden);
    const std::set<ElementId>& hidden() const { return m_hidden; }
    /// Hidden ones, what is drawn in them, and what no layer shows.
    std::set<ElementId> unseen(const Design& design) const;

signals:
    /// Layers or what is hidden.
    void changed();
    /// What is hidden; after `changed`.
    void hiddenChanged();

private:
    std::set<Layer> m_layers{Layer::Cover,          Layer::Checker,      Layer::Seams,      Layer::Frames,
                             Layer::FixationCurves, Layer::HandleCurves, Layer::FancySeams, Layer::Scans,
                             Layer::ScanColors,     Layer::Ground,       Layer::Twins,      Layer::Symmetry};
    std::set<ElementId> m_hidden;
};

} // namespace bolster
