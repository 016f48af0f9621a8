// The cover that the 3D view shows: what of it is hidden, how it is refined, what its patches are made of.
#pragma once

#include "CoverPlaces.h"
#include "ViewScene.h"
#include "VisibleCover.h"

#include <set>

namespace bolster {

class Selection;

/// Fills in the cover of a scene.
class ShownCover {
public:
    /// The scene must outlive it.
    explicit ShownCover(ViewScene& scene)
        : m_scene(scene)
    {}

    /// Null for none, as for one that is broken. `update` shows it.
    void setSurface(SurfaceMeshPtr surface);
    /// With nothing of it hidden.
    const SurfaceMeshPtr& surface() const { return m_surface; }
    /// The same refined, and what lies on that. False: of another surface, so not to be shown.
    bool setRefined(CoverMeshPtr cover, TrimMeshPtr trims);

    /// Without those that are `unseen`.
    void update(bool shown, const std::set<ElementId>& unseen);
    /// `mirrored`: of what is selected or under the pointer.
    void updateLooks(const Design& design, const Selection& selection, const std::set<ElementId>& mirrored);

    /// Of what is shown of the cover, mm.
    Box3 box() const;
    Box3 box(const std::set<ElementId>& patches) const;
    /// The same point on what is shown of the cover, and in the pattern.
    CoverPlaces& places() { return m_places; }
    const CoverPlaces& places() const { return m_places; }

private:
    ViewScene& m_scene;
    SurfaceMeshPtr m_surface;
    CoverMeshPtr m_refined; ///< of another surface: not drawn
    TrimMeshPtr m_trims;    ///< on m_refined
    VisibleCover m_visible;
    CoverPlaces m_places;
};

} // namespace bolster
