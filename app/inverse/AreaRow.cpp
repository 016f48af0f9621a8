#include "AreaRow.h"

#include "CoverView.h"
#include "MapLink.h"
#include "NumberBox.h"
#include "SolverLink.h"
#include "Units.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

constexpr double usualRadius = 40; // mm

/// What a round stamp covers of each patch: a disc around the vertex that is nearest to its middle.
std::vector<AreaSpot> spotsUnder(const AreaBrushTool::Stamp& stamp, const SurfaceMesh& surface)
{
    std::vector<AreaSpot> spots;
    for (const SurfaceTopology::PatchRange& range : surface.topology->patches) {
        double nearest = stamp.radius * stamp.radius;
        std::optional<std::uint32_t> found;
        for (std::uint32_t v = range.firstVertex; v < range.firstVertex + range.vertexCount; ++v)
            if (const double square = (surface.positions[v] - stamp.middle).squaredNorm(); square < nearest) {
                nearest = square;
                found = v;
            }
        if (found)
            spots.push_back(
                {range.patch, surface.topology->pattern[*found], std::sqrt(stamp.radius * stamp.radius - nearest)});
    }
    return spots;
}

ShownMapPtr mapOf(const std::vector<AreaSpot>& spots, const SurfaceMesh& surface, const QString& title)
{
    auto map = std::make_shared<ShownMap>();
    map->topology = surface.topology;
    map->values.assign(surface.topology->pattern.size(), std::numeric_limits<float>::quiet_NaN());
    const FitArea area{{}, spots};
    for (const SurfaceTopology::PatchRange& range : surface.topology->patches)
        for (std::uint32_t v = range.firstVertex; v < range.firstVertex + range.vertexCount; ++v)
            if (!spots.empty() && area.has(range.patch, surface.topology->pattern[v]))
                map->values[v] = 100;
    map->kind = MapScale::Kind::Sequential;
    map->limit = 100;
    map->title = title;
    map->unit = AreaRow::tr(" %");
    return map;
}

} // namespace

AreaRow::AreaRow(const Parts& parts, QWidget* parent)
    : QWidget(parent)
    , m_parts(parts)
    , m_only(new QCheckBox(tr("Onl&y in a painted area"), this))
    , m_paint(new QPushButton(tr("Paint"), this))
    , m_clear(new QPushButton(tr("Clear"), this))
    , m_radius(new NumberBox({millimetreSuffix, 0, AreaBrushTool::leastRadius, AreaBrushTool::mostRadius, 5, true},
                             this))
{
    m_only->setToolTip(tr("The form and the limit of strain count only there"));
    m_paint->setToolTip(tr("Drag over the cover in the 3D view; with Shift held down it takes away"));
    m_radius->setToolTip(tr("Radius of the brush"));
    m_radius->setAccessibleName(tr("Radius of the brush"));
    m_radius->display(usualRadius);
    m_paint->setCheckable(true);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins({});
    row->addWidget(m_only);
    row->addWidget(m_paint);
    auto* radius = new QLabel(tr("Radius"), this);
    radius->setBuddy(m_radius);
    row->addWidget(radius);
    row->addWidget(m_radius);
    row->addWidget(m_clear);
    row->addStretch(1);
    connect(m_only, &QCheckBox::toggled, this, &AreaRow::refresh);
    connect(m_paint, &QPushButton::clicked, this, &AreaRow::paint);
    connect(m_clear, &QPushButton::clicked, this, [this] { setSpots({}); });
    connect(m_radius, &NumberBox::entered, this, [this] {
        if (m_paint->isChecked())
            paint();
    });
    connect(&parts.cover, &CoverView::toolChanged, this,
            [this](CoverToolKind kind) { m_paint->setChecked(kind == CoverToolKind::PaintArea); });
    refresh();
}

AreaRow::~AreaRow()
{
    if (m_parts.cover.tool() == CoverToolKind::PaintArea)
        m_parts.cover.setTool(CoverToolKind::Select);
    if (m_seen)
        m_parts.maps.setGuest(nullptr);
}

bool AreaRow::wanted() const
{
    return m_only->isChecked();
}

void AreaRow::paint()
{
    if (m_parts.cover.tool() == CoverToolKind::PaintArea && !m_paint->isChecked()) {
        m_parts.cover.setTool(CoverToolKind::Select);
        return;
    }
    m_only->setChecked(true);
    // The tool may outlive this row for the rest of an event.
    m_parts.cover.startAreaBrush(m_radius->value(), [row = QPointer(this)](const AreaBrushTool::Stamp& stamp) {
        if (row)
            row->take(stamp);
    });
    m_paint->setChecked(true);
    m_parts.cover.activateWindow(); // keys are for the brush from now on
    m_parts.cover.setFocus(Qt::OtherFocusReason);
    refresh();
}

void AreaRow::take(const AreaBrushTool::Stamp& stamp)
{
    const SurfaceMeshPtr surface = m_parts.solver.surface();
    if (!surface || surface->positions.size() != surface->topology->pattern.size())
        return;
    m_radius->display(stamp.radius); // keys change it while it is painted
    if (!stamp.paints)
        return;
    const std::vector<AreaSpot> under = spotsUnder(stamp, *surface);
    if (stamp.erases) {
        std::erase_if(m_spots, [&](const AreaSpot& spot) {
            return std::ranges::any_of(under, [&](const AreaSpot& gone) {
                return gone.patch == spot.patch && (gone.at - spot.at).norm() < gone.radius;
            });
        });
    } else {
        m_spots.insert(m_spots.end(), under.begin(), under.end());
    }
    m_only->setChecked(true);
    refresh();
}

void AreaRow::setSpots(std::vector<AreaSpot> spots)
{
    m_spots = std::move(spots);
    refresh();
}

void AreaRow::refresh()
{
    m_clear->setEnabled(!m_spots.empty());
    const SurfaceMeshPtr surface = m_parts.solver.surface();
    const bool seen = wanted() && surface && surface->positions.size() == surface->topology->pattern.size() &&
                      (!m_spots.empty() || m_paint->isChecked());
    if (seen || m_seen) // whose map is there otherwise is not ours to take away
        m_parts.maps.setGuest(seen ? mapOf(m_spots, *surface, tr("Painted area")) : nullptr);
    m_seen = seen;
}

} // namespace bolster
