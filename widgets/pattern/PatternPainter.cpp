#include "PatternPainter.h"

#include "CurvePath.h"
#include "Icons.h"
#include "MeasurePicture.h"
#include "PatternCut.h"
#include "PatternGrid.h"
#include "PatternLabel.h"
#include "PatternMarks.h"
#include "ProblemSet.h"
#include "SeamColors.h"
#include "Selection.h"
#include "Units.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double bandWidth = 4;       // of a seam's colour along the outline
constexpr double leastMeshEdge = 2.5; // finer meshes would only be a grey veil
constexpr double leastPointGap = 5;
constexpr double pointSize = 7;
constexpr double speckSize = 5; // of a patch of which no more is to be seen than its colour

/// Dashes of the selection's colour: it is not selected, but what is done to the selection is done to it.
QPen mirroredPen(const ViewColors& colors)
{
    QPen pen(mixed(colors.canvas, colors.accent, 0.7), 2, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    pen.setDashPattern({4, 2.5});
    return pen;
}

} // namespace

PatternPainter::PatternPainter(QPainter& painter, const Input& input)
    : m_painter(painter)
    , m_in(input)
    , m_matrix(input.transform.matrix())
    , m_visible(input.transform.visible(input.size))
{
    for (const auto& entry : input.scene.stretches())
        m_stretches[entry.second.patch].push_back(&entry);
    for (const auto& entry : input.scene.trims().marks())
        m_trims[entry.second.patch].push_back(&entry);
}

void PatternPainter::paint()
{
    m_painter.fillRect(QRect(QPoint(0, 0), m_in.size), m_in.colors.canvas);
    m_painter.setFont(m_in.font);
    m_painter.setRenderHint(QPainter::Antialiasing);
    if (m_in.layers.grid)
        paintGrid(m_painter, m_in.transform, m_in.size, m_in.colors);
    if (m_in.layers.symmetry && m_in.scene.twins().symmetry)
        paintSymmetryAxis(m_painter, *m_in.scene.twins().symmetry, m_in.transform, m_in.size, m_in.colors);
    if (m_in.cut)
        paintAllowances(m_painter, *m_in.cut, m_in.scene, m_in.transform, m_in.colors);
    for (const auto& [id, patch] : m_in.scene.patches())
        if (visible(patch))
            paintPatch(patch);
    for (const auto& [id, line] : m_in.scene.lines())
        paintLine(line);
    for (const auto& [id, patch] : m_in.scene.patches())
        if (visible(patch) && !tiny(patch))
            paintInside(patch);
    if (m_in.layers.seams)
        paintSeamLinks();
    if (m_in.cut)
        paintCutMarks(m_painter, *m_in.cut, m_in.scene, m_in.transform, m_in.colors, m_in.selection, m_words);
    if (m_in.layers.points)
        paintAllPoints();
    if (m_in.layers.measurements)
        paintMeasures();
    paintScaleBar(m_painter, m_in.transform, m_in.size, m_in.colors);
}

bool PatternPainter::selected(ElementId id) const
{
    return m_in.selection.contains(id);
}

bool PatternPainter::hovered(ElementId id) const
{
    return m_in.selection.hovered() == id;
}

bool PatternPainter::bad(ElementId id) const
{
    return m_in.invalid.contains(id) || m_in.problems.hasError(id);
}

bool PatternPainter::mirrored(ElementId id) const
{
    return m_in.layers.twins && m_in.mirrored.contains(id);
}

bool PatternPainter::hidden(ElementId id) const
{
    return m_in.hidden.contains(id) && !selected(id) && !hovered(id);
}

bool PatternPainter::visible(const PatternPatch& patch) const
{
    const Vec2 margin = Vec2::Constant(m_in.transform.millimetres(20));
    return !patch.path.isEmpty() && Box2(patch.box.min() - margin, patch.box.max() + margin).intersects(m_visible);
}

bool PatternPainter::tiny(const PatternPatch& patch) const
{
    return patch.box.sizes().maxCoeff() * m_in.transform.scale() < speckSize;
}

const PatternPainter::Stretches& PatternPainter::stretchesOf(const PatternPatch& patch) const
{
    static const Stretches none;
    const auto found = m_stretches.find(patch.id);
    return found == m_stretches.end() ? none : found->second;
}

QPainterPath PatternPainter::inPixels(const QPainterPath& path) const
{
    return m_matrix.map(path);
}

void PatternPainter::paintPatch(const PatternPatch& patch)
{
    if (tiny(patch)) {
        paintSpeck(patch);
        return;
    }
    const bool isSelected = selected(patch.id);
    const bool isBad = bad(patch.id);
    if (!isBad && hidden(patch.id)) {
        paintHiddenPatch(patch);
        return;
    }
    const QPainterPath outline = inPixels(patch.path);
    const ViewColors& colors = m_in.colors;

    QColor fill = colors.patchFill(patch.fabric, isSelected                                ? 0.46
                                                 : hovered(patch.id) || mirrored(patch.id) ? 0.38
                                                                                           : 0.30);
    if (isBad)
        fill = mixed(colors.canvas, colors.error, 0.18);
    m_painter.fillPath(outline, fill);
    if (isBad)
        m_painter.fillPath(outline, QBrush(mixed(colors.canvas, colors.error, 0.5), Qt::BDiagPattern));
    paintMap(patch, outline);
    if (m_in.layers.mesh)
        paintMesh(patch);
    if (m_in.layers.seams)
        paintSeamBands(patch, outline);

    if (m_in.layers.seams) {
        paintTrims(patch);
        paintFixations(patch);
    }
    const QColor line = isBad               ? colors.error
                        : isSelected        ? colors.accent
                        : hovered(patch.id) ? colors.hover
                                            : colors.outline;
    m_painter.strokePath(outline, QPen(line, isSelected ? 2 : 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (mirrored(patch.id) && !isBad && !isSelected)
        m_painter.strokePath(outline, mirroredPen(colors));
}

/// There may be a hundred thousand of them.
void PatternPainter::paintSpeck(const PatternPatch& patch)
{
    const ViewColors& colors = m_in.colors;
    const QColor color = bad(patch.id)        ? colors.error
                         : selected(patch.id) ? colors.accent
                         : hovered(patch.id)  ? colors.hover
                                              : colors.patchFill(patch.fabric, hidden(patch.id) ? 0.08 : 0.6);
    m_painter.fillRect(m_matrix.mapRect(patch.path.boundingRect()), color);
}

/// What the 3D view hides is only a sketch here, without its seams.
void PatternPainter::paintHiddenPatch(const PatternPatch& patch)
{
    const QPainterPath outline = inPixels(patch.path);
    m_painter.fillPath(outline, m_in.colors.patchFill(patch.fabric, 0.08));
    QPen pen(m_in.colors.mutedLabel, 1.2, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    pen.setDashPattern({5, 4});
    m_painter.strokePath(outline, pen);
}

void PatternPainter::paintMap(const PatternPatch& patch, const QPainterPath& outline)
{
    const PatternMap::Picture* picture = m_in.map.picture(patch.id);
    if (!picture)
        return;
    // By three points: the layout turns and mirrors.
    const auto place = [&](const QPointF& p) {
        return m_in.transform.toPixels(toLayout(patch.patch(), Vec2(p.x(), p.y())));
    };
    const QPointF origin = place(picture->box.topLeft());
    const QPointF along = place(picture->box.topRight()) - origin, down = place(picture->box.bottomLeft()) - origin;
    const double width = picture->image.width(), height = picture->image.height();
    m_painter.save();
    m_painter.setClipPath(outline, Qt::IntersectClip);
    m_painter.setRenderHint(QPainter::SmoothPixmapTransform);
    m_painter.setTransform(QTransform(along.x() / width, along.y() / width, down.x() / height, down.y() / height,
                                      origin.x(), origin.y()),
                           true);
    m_painter.drawImage(0, 0, picture->image);
    m_painter.restore();
}

void PatternPainter::paintMesh(const PatternPatch& patch)
{
    const double pixels = m_in.mesh.edgeLength() * m_in.transform.scale();
    if (pixels < leastMeshEdge)
        return;
    QColor color = m_in.colors.mesh;
    color.setAlphaF(color.alphaF() * static_cast<float>(std::clamp(pixels / 10, 0.35, 1.0)));
    // Thin, many and short: here smoothing costs much and shows little.
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    m_painter.setPen(color);
    m_painter.drawLines(m_in.mesh.lines(patch.id, patch.patch(), m_in.transform));
    m_painter.setRenderHint(QPainter::Antialiasing, true);
}

void PatternPainter::paintSeamBands(const PatternPatch& patch, const QPainterPath& outline)
{
    m_painter.save();
    // The inner half of a line twice as wide: the band ends exactly at the outline.
    m_painter.setClipPath(outline, Qt::IntersectClip);
    for (const auto* entry : stretchesOf(patch)) {
        const auto& [owner, stretch] = *entry;
        if (stretch.fixation)
            continue;
        const auto color = m_in.seamColors.find(owner);
        if (color == m_in.seamColors.end())
            continue;
        const bool strong = selected(owner) || hovered(owner) || mirrored(owner);
        const QPen pen(bad(owner) ? m_in.colors.error : color->second, 2 * bandWidth * (strong ? 1.75 : 1),
                       Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
        m_painter.strokePath(inPixels(stretch.path), pen);
    }
    m_painter.restore();
}

void PatternPainter::paintTrims(const PatternPatch& patch)
{
    constexpr double leastStitch = 4; // pixels: shorter ones are drawn as a line
    const auto own = m_trims.find(patch.id);
    if (own == m_trims.end())
        return;
    for (const auto* entry : own->second) {
        const auto& [owner, trim] = *entry;
        const bool strong = selected(owner) || hovered(owner) || mirrored(owner);
        const double scale = m_in.transform.scale(), width = std::max(strong ? 2.4 : 1.6, trim.width * scale);
        const QColor color = bad(owner) ? m_in.colors.error : selected(owner) ? m_in.colors.accent : trim.color;
        const QPainterPath path = inPixels(trim.path);
        const auto stroke = [&, stitch = trim.stitch * scale](const QColor& with, double wide) {
            QPen pen(with, wide, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
            if (stitch >= leastStitch)
                pen.setDashPattern({0.75 * stitch / wide, 0.25 * stitch / wide});
            m_painter.strokePath(path, pen);
        };
        stroke(m_in.colors.outline, width + 1.2); // thread and piping may have the colour of the cloth
        stroke(color, width);
    }
}

void PatternPainter::paintFixations(const PatternPatch& patch)
{
    const bool counterClockwise = patch.patch().outline.signedArea() > 0;
    for (const auto* entry : stretchesOf(patch)) {
        const auto& [owner, stretch] = *entry;
        if (!stretch.fixation)
            continue;
        const bool isSelected = selected(owner) || selected(stretch.curve);
        const QColor color = bad(owner)   ? m_in.colors.error
                             : isSelected ? m_in.colors.accent
                                          : m_in.colors.fixation;
        paintFixationMarks(m_painter, inPixels(stretch.path), counterClockwise, color,
                           isSelected || hovered(owner) || hovered(stretch.curve) || mirrored(owner) ||
                               mirrored(stretch.curve));
    }
}

void PatternPainter::paintInside(const PatternPatch& patch)
{
    QRectF written;
    // Words that will be on the piece itself take the place of the view's own.
    if (m_in.layers.labels && !readableLabel(m_in.cut, patch.id, m_in.transform)) {
        const CutPiece* piece = labelledPiece(m_in.cut, patch.id);
        const PatternLabel label = piece ? nameOnPiece(*piece, patch, m_in.transform, m_in.font)
                                         : PatternLabel(patch, m_in.transform, m_in.font);
        const bool faint = hidden(patch.id);
        const bool onMap = !faint && m_in.map.picture(patch.id);
        label.paint(m_painter,
                    {bad(patch.id) ? m_in.colors.error
                     : faint       ? m_in.colors.mutedLabel
                                   : m_in.colors.label,
                     onMap ? m_in.colors.label : m_in.colors.mutedLabel, onMap ? m_in.colors.canvas : QColor()},
                    !m_in.cut); // the piece has its own
        written = label.box();
        if (m_in.cut && !written.isEmpty())
            m_words.push_back(label.frame());
        if (faint && !written.isEmpty()) // until it is shown again
            icon(QStringLiteral("hide"), m_in.colors.mutedLabel)
                .paint(&m_painter, QRectF(written.center().x() - 8, written.top() - 19, 16, 16).toRect());
        const PatternTwins& twins = m_in.scene.twins();
        if (twins.has(patch.id) && !written.isEmpty())
            paintTwinMark(m_painter, {written.center().x(), written.top() - 10},
                          !twins.released.at(patch.id).empty(), m_in.colors.mutedLabel);
    }
    if (m_in.layers.seams && !hidden(patch.id))
        paintSeamArrows(patch, written);
}

void PatternPainter::paintSeamArrows(const PatternPatch& patch, const QRectF& written)
{
    const bool counterClockwise = patch.patch().outline.signedArea() > 0;
    const QRectF view(QPointF(0, 0), m_in.size);
    std::vector<QRectF> taken;
    if (!written.isEmpty())
        taken.push_back(written.adjusted(-2, -1, 2, 1));
    for (const auto* entry : stretchesOf(patch)) {
        const auto& [owner, stretch] = *entry;
        const auto color = m_in.seamColors.find(owner);
        if (color == m_in.seamColors.end())
            continue;
        const QPainterPath path = inPixels(stretch.path);
        if (!view.intersects(path.boundingRect().adjusted(-20, -20, 20, 20)))
            continue;
        SeamArrow arrow{path, counterClockwise != stretch.backwards, selected(owner) || hovered(owner)};
        if (m_in.layers.labels)
            arrow.label = seamLabel(static_cast<std::size_t>(std::distance(m_in.seamColors.begin(), color)));
        const QRectF box = paintSeamArrow(m_painter, arrow, bad(owner) ? m_in.colors.error : color->second, taken);
        const double middle = patch.patch().outline.wrapped((stretch.from + stretch.to) / 2);
        if (!box.isEmpty())
            m_badges.push_back({box, owner, patch.id, middle});
    }
}

void PatternPainter::paintSeamLinks()
{
    const auto& stretches = m_in.scene.stretches();
    for (auto stretch = stretches.begin(); stretch != stretches.end(); ++stretch) {
        const auto other = std::next(stretch);
        const ElementId owner = stretch->first;
        if (other == stretches.end() || other->first != owner || !(selected(owner) || hovered(owner)))
            continue;
        if (const auto color = m_in.seamColors.find(owner); color != m_in.seamColors.end())
            paintSeamLink(m_painter, inPixels(stretch->second.path), inPixels(other->second.path), color->second);
    }
}

bool PatternPainter::pointsReadable(const PatternPatch& patch, const PatternTransform& transform)
{
    const Vec2 extent = patch.box.sizes();
    const double around = 2 * (extent.x() + extent.y()) * transform.scale();
    return around > leastPointGap * static_cast<double>(patch.points.size());
}

void PatternPainter::paintLine(const PatternLine& line)
{
    const PatternPatch* on = m_in.scene.patch(line.patch);
    if (!on || !visible(*on) || !m_in.layers.shows(line))
        return;
    const ViewColors& colors = m_in.colors;
    const QPainterPath path = inPixels(line.path);
    const bool strong = selected(line.id) || hovered(line.id) || mirrored(line.id);
    const QColor own = line.fancy() ? colors.fancySeam : colors.handle;
    const QColor color = bad(line.id)        ? colors.error
                         : selected(line.id) ? colors.accent
                         : hovered(line.id)  ? mixed(own, colors.accent, 0.4)
                         : mirrored(line.id) ? mixed(own, colors.accent, 0.6)
                                             : own;
    double width = 0;
    if (const FancySeam* fancy = line.fancy()) {
        width = fancy->width * m_in.transform.scale();
        m_painter.save();
        m_painter.setClipPath(inPixels(on->path), Qt::IntersectClip);
        paintFancyStrip(m_painter, path, width, color, strong);
        m_painter.restore();
    } else {
        m_painter.strokePath(path, QPen(mixed(color, colors.canvas, 0.7), strong ? 5 : 4));
        m_painter.strokePath(path, QPen(color, strong ? 2.4 : 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    }
    const std::string& name = elementName(*line.element);
    if (m_in.layers.labels && !name.empty())
        paintLineName(m_painter, path, QString::fromStdString(name), width / 2, color, strong);
}

void PatternPainter::paintMeasures()
{
    for (const auto& [id, measure] : m_in.scene.measures().all()) {
        const QColor color = bad(id)        ? m_in.colors.error
                             : selected(id) ? m_in.colors.accent
                             : hovered(id)  ? m_in.colors.hover
                                            : m_in.colors.label;
        paintMeasure(m_painter,
                     {m_in.transform.toPixels(measure.from), m_in.transform.toPixels(measure.to),
                      measure.inOnePatch ? lengthText(measure.length(), 1) : QString(),
                      selected(id) || hovered(id)},
                     color, m_in.colors.canvas);
    }
}

void PatternPainter::paintAllPoints()
{
    for (const auto& [id, patch] : m_in.scene.patches())
        if (visible(patch) && (selected(id) || hovered(id)) && pointsReadable(patch, m_in.transform))
            paintPoints(id, patch.points, patch.corners, patch.patch().outline);
    for (const auto& [id, line] : m_in.scene.lines())
        if (m_in.layers.shows(line) && (selected(id) || hovered(id)))
            paintPoints(id, line.points, line.corners, line.curve());
    paintFollowers();
}

/// Of the selected points: what a drag of them moves elsewhere.
void PatternPainter::paintFollowers()
{
    const PatternTwins& twins = m_in.scene.twins();
    for (const auto& [id, point] : m_in.selection.points())
        if (const auto at = twins.follower(m_in.scene, id, point))
            paintFollower(m_painter, m_in.transform.toPixels(*at), m_in.colors);
}

void PatternPainter::paintPoints(ElementId id, const std::vector<Vec2>& points, const std::vector<char>& corners,
                                 const BSpline2& curve)
{
    QPolygonF pixels;
    for (const Vec2& p : points)
        pixels << m_in.transform.toPixels(p);
    const ViewColors& colors = m_in.colors;
    if (curve.degree() > 1) {
        m_painter.setPen(QPen(mixed(colors.canvas, colors.accent, 0.55), 1, Qt::DotLine));
        m_painter.setBrush(Qt::NoBrush);
        if (curve.closed())
            m_painter.drawPolygon(pixels);
        else
            m_painter.drawPolyline(pixels);
    }
    const QColor line = selected(id) ? colors.accent : colors.hover;
    for (qsizetype i = 0; i < pixels.size(); ++i) {
        const bool chosen = m_in.selection.contains(Selection::Point{id, static_cast<int>(i)});
        m_painter.setPen(QPen(line, 1.4));
        m_painter.setBrush(chosen ? colors.accent : colors.pointFill);
        const double size = chosen ? pointSize + 2 : pointSize;
        const QRectF box(pixels[i] - QPointF(size, size) / 2, QSizeF(size, size));
        if (m_in.scene.twins().isReleased(id, static_cast<int>(i)))
            paintReleasedPoint(m_painter, pixels[i], size);
        else if (corners[static_cast<std::size_t>(i)])
            m_painter.drawRect(box);
        else
            m_painter.drawEllipse(box);
    }
}

} // namespace bolster
