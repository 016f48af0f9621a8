#include "FormPattern.h"

#include "ArcLength.h"
#include "DesignCheck.h"
#include "EditBuilder.h"
#include "PatternAdvice.h"
#include "PieceOutlines.h"
#include "PieceRelations.h"
#include "SmoothRows.h"
#include "StretchLength.h"
#include "TwinEdits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double leastShape = 1e-6;    // of a triangle, against the squares of its sides
constexpr double besideEachOther = 60; // mm between patches in the layout
constexpr double rowsWide = 1.5;       // times as wide as high is what lies in rows
constexpr double crossing = 0.3;       // of a direction's length: less of it lies in a piece that it crosses
constexpr double shortestCurve = 0.05; // mm: holds nothing
constexpr double sameShape = 0.5;      // mm: from each other's mirror image are twins

class FormPatternBuilder {
public:
    FormPatternBuilder(const Form& form, const std::vector<FlatPiece>& flat, const FormPatternOrder& order,
                       const std::stop_token& stop)
        : m_form(form)
        , m_order(order)
        , m_stop(stop)
        , m_outlines(form, flat, order.tolerance, stop)
        , m_relations(form)
        , m_builder(Design())
        , m_starts(form.pieces.size())
        , m_rowWidth(rowWidth(flat))
    {}

    FormPattern build()
    {
        addPatches();
        for (std::size_t p = 0; goesOn(p); ++p)
            for (std::size_t r = 0; r < piece(p).rows.size(); ++r)
                addRow(p, r);
        if (m_order.twins)
            linkTwins();
        m_result.design = m_builder.now();
        if (!m_stop.stop_requested())
            m_result.advice = patternAdvice(m_form, m_outlines.flat(), m_order, m_result);
        return std::move(m_result);
    }

private:
    bool goesOn(std::size_t p) const { return p < m_form.pieces.size() && !m_stop.stop_requested(); }
    const FormPiece& piece(std::size_t p) const { return m_form.pieces[p]; }
    const Vec3& formPoint(std::size_t p, std::size_t k) const
    {
        return m_form.points[piece(p).points[piece(p).border[k]]];
    }
    const Vec2& flatPoint(std::size_t p, std::size_t k) const
    {
        return m_outlines.flat()[p].at[piece(p).border[k]];
    }

    /// Not sewn and not held.
    void addPatches()
    {
        Settings settings;
        settings.edgeLength = m_order.edgeLength;
        m_builder.replace(settingsId, settings);
        m_fabric = m_builder.add(m_order.fabric);
        m_result.notes = m_outlines.notes();
        for (std::size_t p = 0; goesOn(p); ++p)
            addPatch(p);
    }

    void addPatch(std::size_t p)
    {
        m_result.patches.push_back(noElement);
        Patch patch;
        patch.outline = m_outlines.outline(p);
        if (patch.outline.empty())
            return;
        m_starts[p] = m_outlines.rowStarts(p);
        patch.name = piece(p).name;
        patch.fabric = m_fabric;
        patch.grain = grainOf(p);
        patch.position = place(patch.outline.boundingBox());
        m_result.patches.back() = m_builder.add(std::move(patch));
    }

    /// Degrees. The direction as each triangle has it, laid flat, on the average.
    double grainOf(std::size_t p) const
    {
        Vec2 sum = Vec2::Zero();
        double area = 0;
        for (const auto& corners : piece(p).triangles) {
            const auto on = [&](std::size_t k) -> const Vec3& {
                return m_form.points[piece(p).points[corners[k]]];
            };
            const auto flat = [&](std::size_t k) -> const Vec2& { return m_outlines.flat()[p].at[corners[k]]; };
            Eigen::Matrix<double, 3, 2> edges;
            edges << on(1) - on(0), on(2) - on(0);
            Eigen::Matrix2d laid;
            laid << flat(1) - flat(0), flat(2) - flat(0);
            const double size = edges.col(0).cross(edges.col(1)).norm() / 2;
            if (!(size > leastShape * edges.squaredNorm())) // which way it lies is not known
                continue;
            area += size;
            sum += size * (laid * (edges.transpose() * edges).inverse() * edges.transpose() * m_order.grain.along);
        }
        if (sum.norm() <= crossing * area) // also where no direction is given
            return m_order.grain.angle;
        const double degrees = std::atan2(sum.y(), sum.x()) * 180 / std::numbers::pi;
        return std::round(10 * (degrees > 0 ? degrees : degrees + 180)) / 10; // a line has no beginning
    }

    static double rowWidth(const std::vector<FlatPiece>& pieces)
    {
        double area = 0;
        for (const FlatPiece& flat : pieces) {
            Box2 box;
            for (const Vec2& at : flat.at)
                box.extend(at);
            area += (box.sizes().x() + besideEachOther) * (box.sizes().y() + besideEachOther);
        }
        return rowsWide * std::sqrt(area);
    }

    /// Side by side, in rows from above to below.
    Vec2 place(const Box2& box)
    {
        if (m_cursor.x() > 0 && m_cursor.x() + box.sizes().x() > m_rowWidth) {
            m_cursor = {0, m_cursor.y() - m_rowHeight - besideEachOther};
            m_rowHeight = 0;
        }
        const Vec2 at(m_cursor.x() - box.min().x(), m_cursor.y() - box.max().y());
        m_cursor.x() += box.sizes().x() + besideEachOther;
        m_rowHeight = std::max(m_rowHeight, box.sizes().y());
        return at;
    }

    bool isThere(std::size_t p) const { return m_result.patches[p] != noElement; }

    Stretch stretchOf(std::size_t p, std::size_t r) const
    {
        return {m_result.patches[p], m_starts[p][r], m_starts[p][r + 1 < m_starts[p].size() ? r + 1 : 0]};
    }

    void addRow(std::size_t p, std::size_t r)
    {
        const BorderRow& row = piece(p).rows[r];
        if (!isThere(p))
            return;
        if (!row.isSewn())
            addFixation(p, row, r);
        else if (!isThere(row.matePiece)) // it is left out, as a hole of the form
            addFixation(p, row, r);
        else if (std::pair(row.matePiece, row.mateRow) >= std::pair(static_cast<int>(p), static_cast<int>(r))) {
            addSeam(p, row, r);
            if (m_relations.isClosed(p)) {
                m_result.hasClosed = true;
                addFixation(p, row, r);
            }
        }
    }

    void addSeam(std::size_t p, const BorderRow& row, std::size_t r)
    {
        Seam seam;
        seam.a = stretchOf(p, r);
        seam.b = stretchOf(row.matePiece, row.mateRow);
        // Of a piece with itself, as a tube's, the solver rounds a plain seam by itself, and finds the tube from
        // farther away.
        const bool rounded =
            row.matePiece != static_cast<int>(p) && m_relations.bendAlong(p, row) < m_order.hardEdge;
        seam.continuity = rounded ? Continuity::G1 : Continuity::C0;
        const double a = lengthOf(p, seam.a), b = lengthOf(row.matePiece, seam.b);
        m_result.seams.push_back({m_builder.add(seam), a, b});
    }

    double lengthOf(std::size_t p, const Stretch& stretch) const
    {
        const BSpline2& outline = m_builder.now().find<Patch>(m_result.patches[p])->outline;
        const double end = unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
        return ArcLength2(outline).between(stretch.from, end);
    }

    /// The parameters of the curve are those of the outline, so that each point of the cloth is held where it lies
    /// on the form, also where the cloth is strained along its border.
    void addFixation(std::size_t p, const BorderRow& row, std::size_t r)
    {
        CurveSamples samples;
        std::vector<Vec3> smooth{formPoint(p, row.first)};
        std::vector<Vec2> laid{flatPoint(p, row.first)};
        double at = 0;
        for (std::size_t k = 1; k <= row.count; ++k) {
            const std::size_t index = (row.first + k) % piece(p).border.size();
            smooth.push_back(formPoint(p, index));
            laid.push_back(flatPoint(p, index));
            if (k < row.count && !m_outlines.isCorner(p, index) && !m_outlines.turnsOnForm(p, index))
                continue;
            const CurveSamples part = smoothSamples(smooth, lengthsAlong(laid));
            if (at > 0)
                samples.corners.push_back(at);
            for (std::size_t i = at > 0 ? 1 : 0; i < part.points.size(); ++i) {
                samples.points.push_back(part.points[i]);
                samples.parameters.push_back(at + part.parameters[i]);
            }
            at += part.end;
            smooth = {formPoint(p, index)};
            laid = {flatPoint(p, index)};
        }
        samples.end = at;
        if (lengthsAlong(samples.points).back() < shortestCurve)
            return;
        FixationCurve curve;
        curve.name = m_names.free(piece(p).name);
        curve.curve = fitCurve(samples, m_order.tolerance);
        FixationSeam fixation;
        fixation.stretch = stretchOf(p, r);
        fixation.match = slipOf(p, row) > m_order.tolerance ? Match::Parameter : Match::Length;
        fixation.curve = m_builder.add(std::move(curve));
        m_builder.add(fixation);
    }

    /// How far a point of the row would be held off its place if lengths alone counted, mm.
    double slipOf(std::size_t p, const BorderRow& row) const
    {
        std::vector<Vec3> onForm;
        std::vector<Vec2> laid;
        for (std::size_t k = 0; k <= row.count; ++k) {
            const std::size_t index = (row.first + k) % piece(p).border.size();
            onForm.push_back(formPoint(p, index));
            laid.push_back(flatPoint(p, index));
        }
        const std::vector<double> there = lengthsAlong(onForm), here = lengthsAlong(laid);
        const double scale = there.back() / std::max(here.back(), 1e-9);
        double most = 0;
        for (std::size_t k = 0; k < there.size(); ++k)
            most = std::max(most, std::abs(here[k] * scale - there[k]));
        return most;
    }

    /// Pieces that are mirror images of each other at the usual plane of symmetry follow each other from now on.
    void linkTwins()
    {
        for (std::size_t p = 0; goesOn(p); ++p)
            for (std::size_t q = p + 1; goesOn(q); ++q) {
                if (!isThere(p) || !isThere(q) || !m_relations.mirrors(p, q, sameShape) ||
                    !m_relations.mirrors(q, p, sameShape))
                    continue;
                const Edit link = edits::linkTwins(m_builder.now(), m_result.patches[p], m_result.patches[q]);
                if (link.empty())
                    continue;
                const Design linked = m_builder.now().with(link);
                if (checkedWell(linked) && keepsLengths(m_builder.now(), linked))
                    m_builder.apply(link);
            }
    }

    /// A follower gets other corners; with those of very short edges ends of seams could come to lie at wrong ones.
    static bool keepsLengths(const Design& before, const Design& after)
    {
        bool kept = true;
        const auto compare = [&](const Stretch& was, const Stretch& is) {
            kept = kept && std::abs(stretchLength(after, is) - stretchLength(before, was)) <= 2 * sameShape;
        };
        before.each<Seam>([&](ElementId id, const Seam& seam) {
            if (const auto* now = after.find<Seam>(id)) {
                compare(seam.a, now->a);
                compare(seam.b, now->b);
            }
        });
        before.each<FixationSeam>([&](ElementId id, const FixationSeam& seam) {
            if (const auto* now = after.find<FixationSeam>(id))
                compare(seam.stretch, now->stretch);
        });
        return kept;
    }

    static bool checkedWell(const Design& design) { return !hasErrors(checkDesign(design)); }

    const Form& m_form;
    const FormPatternOrder& m_order;
    std::stop_token m_stop;
    PieceOutlines m_outlines;
    PieceRelations m_relations;
    edits::EditBuilder m_builder;
    edits::Names<FixationCurve> m_names{Design()};
    FormPattern m_result;
    ElementId m_fabric = noElement;
    std::vector<std::vector<double>> m_starts; // of each piece: where its rows begin on the outline
    Vec2 m_cursor = Vec2::Zero();
    double m_rowHeight = 0;
    double m_rowWidth;
};

} // namespace

FormPattern formPattern(const Form& form, const std::vector<FlatPiece>& flat, const FormPatternOrder& order,
                        const std::stop_token& stop)
{
    return FormPatternBuilder(form, flat, order, stop).build();
}

std::vector<bool> becomePatches(const Form& form, const std::vector<FlatPiece>& flat, const FormPatternOrder& order,
                                const std::stop_token& stop)
{
    const PieceOutlines outlines(form, flat, order.tolerance, stop);
    std::vector<bool> become;
    for (std::size_t p = 0; p < form.pieces.size(); ++p)
        become.push_back(!stop.stop_requested() && !outlines.outline(p).empty());
    return become;
}

} // namespace bolster
