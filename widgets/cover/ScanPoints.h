// The points of scans where they stand, for drawing.
#pragma once

#include "Camera.h"
#include "Design.h"
#include "DesignFiles.h"
#include "ViewScene.h"

#include <QPointF>

#include <map>
#include <optional>
#include <set>

namespace bolster {

/// Thinned out where there are more than can be seen; placed anew only when a scan changes.
class ScanPoints {
public:
    void update(const Design& design, const DesignFiles& files);
    /// Of the selected ones what is cut away is shown, too, dimmed. With `own` points that have a colour show it.
    std::vector<ViewScene::PointsLook> looks(const std::set<ElementId>& selected, const ViewColors& colors,
                                             const std::set<ElementId>& hidden, bool own) const;
    /// Of what is not cut away, mm.
    Box3 box(ElementId scan) const;
    Box3 box() const;
    /// The foremost one near the pixel that is not cut away, mm.
    std::optional<Vec3> pointAt(ElementId scan, const Camera& camera, QPointF pixel) const;
    bool hasColors() const; ///< some scan's points have

private:
    using Points = std::vector<Eigen::Vector3f>;
    using Colors = std::vector<std::uint32_t>;
    using Shades = std::vector<float>;
    /// A colour in the shades of the points, made when it is wanted.
    struct Tint {
        Shades shades; ///< 0 to 1; empty: the points have colours of their own
        mutable QRgb base = 0;
        mutable std::shared_ptr<const Colors> made;

        std::shared_ptr<const Colors> of(const QColor& color) const;
    };
    struct Placed {
        Scan scan;
        std::shared_ptr<const PointCloud> cloud;
        std::shared_ptr<const Points> kept;
        std::shared_ptr<const Points> few; ///< of those that are kept
        std::shared_ptr<const Points> cut;
        std::shared_ptr<const Colors> keptColors, fewColors; ///< null: it has none
        std::shared_ptr<const Shades> shades;                ///< of every step-th point of the cloud
        Tint keptTint, fewTint;
        Box3 box;
    };

    /// `shades` of the same cloud, null when they are not known yet.
    static Placed place(const Scan& scan, std::shared_ptr<const PointCloud> cloud,
                        std::shared_ptr<const Shades> shades);

    std::map<ElementId, Placed> m_scans;
};

} // namespace bolster
