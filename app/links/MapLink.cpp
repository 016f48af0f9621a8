#include "MapLink.h"

#include "DesignSession.h"
#include "ElementText.h"
#include "PatternLocator.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

constexpr std::size_t mostSpots = 8;

QString unitOf(CoverMap::Kind kind)
{
    switch (kind) {
    case CoverMap::Kind::Thickness:
    case CoverMap::Kind::Deviation:
        return millimetreSuffix;
    case CoverMap::Kind::Curvature:
        return QStringLiteral(" 1/m");
    default:
        return QStringLiteral(" %");
    }
}

QString shownUnit(const QString& unit)
{
    return unit == millimetreSuffix ? lengthSuffix() : unit;
}

QString figureText(double value, const QString& unit)
{
    const int digits = std::abs(value) >= 100 ? 0 : 1;
    return unit == millimetreSuffix ? steadyLengthText(value, digits) : decimalText(value, digits, true) + unit;
}

/// What negative and positive numbers of a map mean.
struct Sides {
    QString below;
    QString above;
};

Sides sidesOf(const CoverMap& map)
{
    if (map.kind == CoverMap::Kind::Curvature)
        return {MapLink::tr("hollow"), MapLink::tr("bulging")};
    if (map.kind == CoverMap::Kind::Deviation)
        return {MapLink::tr("inside"), MapLink::tr("outside")};
    if (!map.allowed.empty() && map.kind != CoverMap::Kind::Shear)
        return {MapLink::tr("pressed"), MapLink::tr("stretched")};
    return {};
}

const SurfaceTopology::PatchRange* rangeOf(const SurfaceTopology& topology, std::uint32_t vertex)
{
    const auto found = std::ranges::find_if(topology.patches, [vertex](const SurfaceTopology::PatchRange& range) {
        return vertex >= range.firstVertex && vertex < range.firstVertex + range.vertexCount;
    });
    return found == topology.patches.end() ? nullptr : &*found;
}

double valueAt(const ShownMap& map, const PatternPlace& place)
{
    double value = 0;
    for (Eigen::Index k = 0; k < 3; ++k)
        value += place.weights[k] * static_cast<double>(map.values[place.corners[static_cast<std::size_t>(k)]]);
    return value;
}

} // namespace

MapLink::MapLink(DesignSession& session, QObject* parent)
    : QObject(parent)
    , m_session(session)
    , m_job(
          [](const Request& asked, const std::stop_token&) {
              Result result{asked, coverMap(asked.kind, *asked.surface, asked.design, asked.files), {}};
              if (!result.map.allowed.empty())
                  result.spots = worstSpots(result.map, *asked.surface, mostSpots, apart);
              return result;
          },
          [this](const Result& result) { receive(result); })
{
    connect(&session.document(), &Document::changed, this, &MapLink::request);
    connect(&session, &DesignSession::filesChanged, this, &MapLink::request);
    connect(&session, &DesignSession::opened, this, &MapLink::request);
    connect(&NumberStyles::instance(), &NumberStyles::changed, this, &MapLink::request); // spots are told in words
}

MapLink::~MapLink() = default;

QString MapLink::title(CoverMap::Kind kind)
{
    switch (kind) {
    case CoverMap::Kind::Strain:
        return tr("Largest strain");
    case CoverMap::Kind::Along:
        return tr("Strain along the grain");
    case CoverMap::Kind::Across:
        return tr("Strain across the grain");
    case CoverMap::Kind::Shear:
        return tr("Shear");
    case CoverMap::Kind::Curvature:
        return tr("Mean curvature");
    case CoverMap::Kind::Thickness:
        return tr("Distance to the frame");
    case CoverMap::Kind::Deviation:
        return tr("Deviation from the scan");
    }
    return {};
}

PictureLegend MapLink::legend(const CoverMap& map)
{
    const QString unit = unitOf(map.kind);
    const auto limit = static_cast<double>(map.scale.limit);
    const bool both = map.scale.kind == MapScale::Kind::Diverging;
    const auto [below, above] = sidesOf(map);
    const auto end = [](const QString& number, const QString& word) {
        return QStringLiteral("%1 %2").arg(number, word).trimmed().toStdString();
    };
    PictureLegend legend;
    legend.scale = map.scale;
    legend.title = title(map.kind).toStdString();
    legend.lowest = end(both ? figureText(-limit, unit) : decimalText(0, 0, false) + shownUnit(unit), below);
    legend.middle = decimalText(0, 0, false).toStdString();
    legend.highest = end(figureText(limit, unit), above);
    if (!map.allowed.empty())
        legend.over = tr("over the fabric's limit").toStdString();
    return legend;
}

void MapLink::setSurface(SurfaceMeshPtr surface)
{
    m_surface = std::move(surface);
    if (!m_surface && m_map)
        forget();
    if (m_guest && (!m_surface || !m_guestHere || !m_guestHere->fits(*m_surface->topology))) {
        carryGuest();
        emit measured();
    }
    request();
}

void MapLink::setGuest(ShownMapPtr map)
{
    if (map == m_guest)
        return;
    m_guest = std::move(map);
    carryGuest();
    emit measured();
}

void MapLink::carryGuest()
{
    m_guestHere.reset();
    if (!m_guest || !m_surface)
        return;
    if (m_guest->fits(*m_surface->topology)) {
        m_guestHere = m_guest;
        return;
    }
    const SurfaceTopology &from = *m_guest->topology, &to = *m_surface->topology;
    auto map = std::make_shared<ShownMap>(*m_guest);
    map->topology = m_surface->topology;
    map->values.assign(to.pattern.size(), std::numeric_limits<float>::quiet_NaN());
    for (const SurfaceTopology::PatchRange& range : to.patches) {
        const auto known = std::ranges::find(from.patches, range.patch, &SurfaceTopology::PatchRange::patch);
        if (known == from.patches.end() || known->triangleCount == 0)
            continue;
        const PatternLocator locator(from, *known);
        for (std::uint32_t v = range.firstVertex; v < range.firstVertex + range.vertexCount; ++v)
            map->values[v] = static_cast<float>(valueAt(*m_guest, locator.locate(to.pattern[v])));
    }
    m_guestHere = std::move(map);
}

void MapLink::setKind(std::optional<CoverMap::Kind> kind)
{
    m_guest.reset();
    m_guestHere.reset();
    if (kind == m_kind)
        return;
    m_kind = kind;
    forget();
    request();
}

void MapLink::forget()
{
    m_map.reset();
    m_spots.clear();
    emit measured();
}

bool MapLink::hasSpots(CoverMap::Kind kind)
{
    return kind == CoverMap::Kind::Strain || kind == CoverMap::Kind::Along || kind == CoverMap::Kind::Across ||
           kind == CoverMap::Kind::Shear;
}

bool MapLink::Spot::over() const
{
    return std::abs(value) > allowed;
}

void MapLink::request()
{
    if (m_kind && m_surface)
        m_job.request({m_surface, *m_kind, m_session.document().design(), m_session.files()});
}

QString MapLink::figure(double value) const
{
    return figureText(value, m_map ? m_map->unit : QString());
}

void MapLink::receive(const Result& result)
{
    if (m_kind != result.request.kind || !m_surface)
        return; // not wanted any more
    const SurfaceTopology& topology = *result.request.surface->topology;
    const CoverMap& measured = result.map;
    auto map = std::make_shared<ShownMap>();
    map->topology = result.request.surface->topology;
    map->values = measured.ofVertex;
    map->allowed = measured.allowed;
    map->kind = measured.scale.kind;
    map->limit = measured.scale.limit;
    map->title = title(measured.kind);
    map->unit = unitOf(measured.kind);
    const auto [below, above] = sidesOf(measured);
    map->below = below;
    map->above = above;
    m_map = std::move(map);
    m_spots.clear();
    for (const CoverSpot& spot : result.spots) {
        const SurfaceTopology::PatchRange* range = rangeOf(topology, spot.vertex);
        if (!range || !result.request.design.find<Patch>(range->patch))
            continue;
        Spot found{{range->patch, topology.pattern[spot.vertex]},
                   static_cast<double>(spot.value),
                   static_cast<double>(measured.allowed[spot.vertex]),
                   displayName(result.request.design, range->patch),
                   {}};
        found.text = tr("%1 in %2").arg(figure(found.value), found.patch);
        if (found.over())
            found.text = tr("%1, over the limit of %2").arg(found.text, figure(found.allowed));
        m_spots.push_back(std::move(found));
    }
    emit this->measured();
}

QString MapLink::reading(const ShownMap& map, const CoverPoint& place)
{
    const SurfaceTopology& topology = *map.topology;
    const auto range = std::ranges::find(topology.patches, place.patch, &SurfaceTopology::PatchRange::patch);
    if (range == topology.patches.end() || range->triangleCount == 0)
        return {};
    const double value = valueAt(map, PatternLocator(topology, *range).locate(place.outline));
    return std::isfinite(value) ? tr("Here: %1").arg(figureText(value, map.unit)) : QString();
}

} // namespace bolster
