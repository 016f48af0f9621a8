#include "ShownPattern.h"

#include "ArcLength.h"
#include "CutLabelWords.h"
#include "Document.h"
#include "ElementText.h"
#include "HitSelection.h"
#include "LayoutEdits.h"
#include "ProblemSet.h"
#include "SeamColors.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "StretchLength.h"
#include "Units.h"

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

constexpr double grabRadius = 7; ///< pixels
constexpr double badgeRoom = 5;  ///< pixels: so far it moves inwards while its seam is under the pointer

} // namespace

ShownPattern::ShownPattern(const Document& document, const Selection& selection, const ProblemSet& problems,
                           const ViewColors& colors)
    : m_document(document)
    , m_selection(selection)
    , m_problems(problems)
    , m_colors(colors)
    , m_cutJob(
          [](const Design& design, const std::stop_token&) {
              CutOptions options;
              options.chord = 0.2; // finer than a pixel
              options.faceUp = false;
              options.words = cutLabelWords();
              return std::make_shared<const CutPattern>(cutPattern(design, options));
          },
          [this](std::shared_ptr<const CutPattern> cut) {
              m_cut = m_layers.cutting ? std::move(cut) : nullptr;
              emit changed();
          })
{
    connect(&document, &Document::changed, this, &ShownPattern::designChanged);
    connect(&selection, &Selection::changed, this, &ShownPattern::selectionChanged);
    connect(&selection, &Selection::hoverChanged, this, &ShownPattern::selectionChanged);
    connect(&problems, &ProblemSet::changed, this, &ShownPattern::changed);
    m_scene.reset(document.design());
    m_seamColors = seamColors(document.design(), m_colors.dark);
}

void ShownPattern::designChanged(const std::set<ElementId>& ids)
{
    const Design& design = m_document.design();
    const auto elsewhere = [&](ElementId id) { return design.find<FixationCurve>(id) || design.find<Frame>(id); };
    if (!ids.empty() && std::ranges::all_of(ids, elsewhere))
        return; // the pattern stays as it is while a curve is dragged in 3D
    m_scene.update(design, ids);
    m_seamColors = seamColors(design, m_colors.dark);
    requestCut();
    selectionChanged();
}

void ShownPattern::requestCut()
{
    if (m_layers.cutting)
        m_cutJob.request(m_document.design());
}

void ShownPattern::selectionChanged()
{
    m_mirrored = mirroredOfMarked(m_document.design(), m_selection);
    emit changed();
}

void ShownPattern::setSurface(const SurfaceMeshPtr& surface)
{
    m_surface = surface;
    m_mesh.setTopology(surface ? surface->topology : nullptr);
    if (m_layers.mesh)
        emit changed();
}

void ShownPattern::setMap(const ShownMapPtr& map)
{
    m_map.setMap(map);
    emit changed();
}

void ShownPattern::setFabricColors(std::map<ElementId, QColor> colors)
{
    m_scene.setFabricColors(m_document.design(), std::move(colors));
    emit changed();
}

void ShownPattern::setHidden(std::set<ElementId> hidden)
{
    m_hidden = std::move(hidden);
    emit changed();
}

void ShownPattern::setLayers(const PatternLayers& layers)
{
    m_layers = layers;
    if (layers.cutting && !m_cut)
        requestCut();
    if (!layers.cutting)
        m_cut = nullptr;
    emit layersChanged();
    emit changed();
}

void ShownPattern::setColors(const ViewColors& colors)
{
    m_colors = colors;
    designChanged({});
}

PatternHit ShownPattern::hit(const PatternTransform& transform, QPointF pixel) const
{
    return m_scene.hit(
        transform.toLayout(pixel), transform.millimetres(grabRadius),
        [&](ElementId id) { return pointsShown(id, transform); },
        [this](const PatternLine& line) { return m_layers.shows(line); }, m_layers.cutting, m_layers.measurements);
}

PatternHit ShownPattern::hitBadge(QPointF pixel) const
{
    for (auto badge = m_badges.rbegin(); badge != m_badges.rend(); ++badge)
        if (badge->box.adjusted(-badgeRoom, -badgeRoom, badgeRoom, badgeRoom).contains(pixel) &&
            m_scene.patch(badge->patch) && m_scene.stretches().contains(badge->seam))
            return {PatternHit::Kind::Outline, badge->patch, -1, badge->middle, badge->seam};
    return {};
}

std::optional<CoverPoint> ShownPattern::pointOf(const PatternHit& found, const PatternTransform& transform,
                                                QPointF pixel) const
{
    const Patch* patch = m_document.design().find<Patch>(found.patch);
    if (!patch)
        return std::nullopt;
    return CoverPoint{found.patch, fromLayout(*patch, transform.toLayout(pixel))};
}

std::optional<Vec2> ShownPattern::placeOf(const CoverPoint& point) const
{
    const Patch* patch = m_document.design().find<Patch>(point.patch);
    return patch ? std::optional(toLayout(*patch, point.outline)) : std::nullopt;
}

bool ShownPattern::pointsShown(ElementId id, const PatternTransform& transform) const
{
    if (!m_layers.points || !(m_selection.contains(id) || m_selection.hovered() == id))
        return false;
    if (const auto line = m_scene.lines().find(id); line != m_scene.lines().end())
        return m_layers.shows(line->second);
    const PatternPatch* patch = m_scene.patch(id);
    return patch && PatternPainter::pointsReadable(*patch, transform);
}

QString ShownPattern::toolTip(const PatternHit& found) const
{
    if (!found)
        return {};
    const Design& design = m_document.design();
    const ElementId id = found.element();
    QStringList lines{displayName(design, id)};
    if (const Seam* seam = design.find<Seam>(id)) {
        lines << seamSummary(design, *seam);
    } else if (const FixationSeam* fixation = design.find<FixationSeam>(id)) {
        lines << lengthText(stretchLength(design, fixation->stretch));
    } else if (const auto line = m_scene.lines().find(id); line != m_scene.lines().end()) {
        lines << lengthText(ArcLength2(line->second.curve()).total());
    } else if (const Patch* patch = design.find<Patch>(id)) {
        const Vec2 extent = edits::layoutBox(*patch).sizes();
        lines << sizeText(extent.x(), extent.y());
    }
    if (const auto edge = edgeAt(m_scene, found))
        lines << tr("Edge: %1").arg(lengthText(stretchLength(design, edge->stretch)));
    lines << m_problems.text(id);
    lines.removeAll(QString());
    return lines.join(u'\n');
}

void ShownPattern::paint(QPainter& painter, const PatternTransform& transform, const QFont& font, QSize size) const
{
    const std::set<ElementId> invalid = m_document.breakage() ? m_document.breakage()->elements : ChangeSet();
    const PatternPainter::Input input{m_scene, m_mesh,       m_map,      m_selection, m_problems,
                                      invalid, m_seamColors, transform,  m_layers,    m_colors,
                                      font,    size,         m_mirrored, m_hidden,    m_cut.get()};
    PatternPainter picture(painter, input);
    picture.paint();
    m_badges = picture.badges();
}

} // namespace bolster
