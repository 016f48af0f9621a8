// Measures the cover for a map, beside the GUI thread: strain, curvature, foam.
#pragma once

#include "CoverMap.h"
#include "CoverPlaces.h"
#include "LatestJob.h"
#include "PictureLegend.h"
#include "ShownMap.h"

namespace bolster {

class DesignSession;

class MapLink : public QObject {
    Q_OBJECT

public:
    explicit MapLink(DesignSession& session, QObject* parent = nullptr);
    ~MapLink() override;

    void setSurface(SurfaceMeshPtr surface);
    /// Which one is wanted; nothing: none.
    void setKind(std::optional<CoverMap::Kind> kind);
    std::optional<CoverMap::Kind> kind() const { return m_kind; }
    /// What somebody else knows of the cover, on triangles of his own, to be shown in place of any other map; null:
    /// that again. Stays until it is taken back, or another kind is wanted.
    void setGuest(ShownMapPtr map);
    bool hasGuest() const { return m_guest != nullptr; }

    /// Null while nothing is measured.
    const ShownMapPtr& map() const { return m_guest ? m_guestHere : m_map; }
    /// Whether there will be a map soon.
    bool measuring() const { return m_kind && m_surface && !m_map; }
    struct Spot {
        CoverPoint place;
        double value = 0;   ///< in the map's unit
        double allowed = 0; ///< what the fabric may suffer, whichever the sign
        QString patch;      ///< its name
        QString text;       ///< "12.3 % in Seat, over the limit of 8 %"

        bool over() const;
    };
    static constexpr double apart = 60; ///< mm between spots, at least
    /// The worst first, measured by what is allowed; only of strains.
    const std::vector<Spot>& spots() const { return m_guest ? m_noSpots : m_spots; }
    static bool hasSpots(CoverMap::Kind kind);
    /// A number of the map with its unit.
    QString figure(double value) const;
    /// What a map says at a place, "" where nothing is known.
    static QString reading(const ShownMap& map, const CoverPoint& place);

    static QString title(CoverMap::Kind kind);
    /// For a picture; may be asked on any thread.
    static PictureLegend legend(const CoverMap& map);

signals:
    void measured();

private:
    struct Request {
        SurfaceMeshPtr surface;
        CoverMap::Kind kind;
        Design design;
        DesignFiles files;
    };
    struct Result {
        Request request;
        CoverMap map;
        std::vector<CoverSpot> spots;
    };

    void request();
    void receive(const Result& result);
    void carryGuest();
    void forget();

    DesignSession& m_session;
    SurfaceMeshPtr m_surface;
    std::optional<CoverMap::Kind> m_kind;
    ShownMapPtr m_map;
    ShownMapPtr m_guest, m_guestHere; ///< and on the triangles that are shown
    std::vector<Spot> m_spots;
    const std::vector<Spot> m_noSpots;
    LatestJob<Request, Result> m_job; ///< last: it uses the others
};

} // namespace bolster
