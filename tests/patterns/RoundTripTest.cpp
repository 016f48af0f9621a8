// What is written is read again: outlines, notches, holes, grain, names, quantities, allowances.
#include "ArcLength.h"
#include "CutMarks.h"
#include "CutPattern.h"
#include "DartEdits.h"
#include "DesignCheck.h"
#include "DrawingReaders.h"
#include "DxfWriter.h"
#include "ImportedDesigns.h"
#include "PatternDesign.h"
#include "SeamEdits.h"
#include "SeamProposals.h"
#include "SvgWriter.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <set>

namespace bolster {

namespace {

enum class Format { Aama, Astm, Plain, Svg };

std::vector<ElementId> patchesOf(const Design& design)
{
    std::vector<ElementId> found;
    design.each<Patch>([&](ElementId id, const Patch&) { found.push_back(id); });
    return found;
}

/// The sample with all that a cutter may be told.
Design withMarks(const Design& start)
{
    Design design = start;
    const auto add = [&](auto value) {
        design = design.with({{}, {{design.nextId(), nullptr, makeElement(std::move(value))}}});
    };
    const std::vector<ElementId> patches = patchesOf(design);
    constexpr CornerJoin joins[] = {CornerJoin::Mitred, CornerJoin::Rounded, CornerJoin::Square};
    for (std::size_t i = 0; i < patches.size(); ++i) {
        Patch patch = *design.find<Patch>(patches[i]);
        patch.cutting.quantity = static_cast<double>(1 + i % 3);
        patch.cutting.pair = i % 2 == 1;
        constexpr Nap naps[] = {Nap::OneWay, Nap::TwoWays, Nap::Any};
        patch.cutting.nap = naps[i % 3];
        patch.cutting.tolerance = i % 2 == 0 ? 2 : 7.5;
        patch.cutting.note = i % 2 == 0 ? "" : "f\u00fcttern";
        patch.allowance = CutAllowance{8.0 + static_cast<double>(i % 4), joins[i % 3]};
        if (i == 1)
            patch.name = "R\u00fcckenk\u00f6rper";
        const BSpline2 outline = patch.outline;
        design = design.with({{}, {{patches[i], nullptr, makeElement(std::move(patch))}}});
        const std::vector<double> corners = outline.corners();
        if (corners.size() > 1 && i % 2 == 0)
            add(EdgeAllowance{{patches[i], corners[0], corners[1]}, i % 4 == 0 ? 20.0 : 0.0});
        const Vec2 middle = outline.boundingBox().center();
        add(DrillHole{"", {patches[i], middle}, 3.5});
        constexpr NotchShape::Kind kinds[] = {NotchShape::Kind::Slit, NotchShape::Kind::V, NotchShape::Kind::T,
                                              NotchShape::Kind::Castle, NotchShape::Kind::U};
        for (int k = 0; k < 5; ++k)
            add(Notch{{patches[i], outline.wrapped(outline.domainStart() + outline.period() * (0.1 + 0.19 * k))},
                      {kinds[k], 5, 6},
                      k == 1});
        InternalLine line;
        line.patch = patches[i];
        line.curve = BSpline2(1, false, {middle + Vec2(-20, 10), middle + Vec2(20, 10), middle + Vec2(25, 20)});
        line.use = i % 2 == 0 ? LineUse::Drawn : LineUse::Cut;
        add(line);
    }
    return design;
}

Drawing written(const CutPattern& pattern, Format format)
{
    if (format == Format::Svg)
        return readSvg(FileBytes(std::string_view(svgText(pattern, {}))));
    const DxfStandard standard = format == Format::Aama   ? DxfStandard::Aama
                                 : format == Format::Astm ? DxfStandard::Astm
                                                          : DxfStandard::Plain;
    return readDxf(FileBytes(std::string_view(dxfText(pattern, {standard, {}, {}, {}}))));
}

/// From an outline to where it was before: pieces are moved and turned on the cutting table.
class Alignment2 {
public:
    Alignment2(const Patch& from, const Patch& to)
    {
        m_turn = Eigen::Rotation2Dd((to.grain - from.grain) * std::numbers::pi / 180);
        // The middles of the areas, of fine polygons.
        m_from = middle(from.outline);
        m_to = middle(to.outline);
    }
    Vec2 operator()(const Vec2& at) const { return m_to + m_turn * (at - m_from); }

private:
    static Vec2 middle(const BSpline2& outline)
    {
        constexpr int count = 20000;
        Vec2 sum = Vec2::Zero();
        double area = 0;
        for (int i = 0; i < count; ++i) {
            const Vec2 a = outline.at(outline.wrapped(outline.domainStart() + outline.period() * i / count));
            const Vec2 b = outline.at(outline.wrapped(outline.domainStart() + outline.period() * (i + 1) / count));
            sum += cross(a, b) / 3 * (a + b);
            area += cross(a, b);
        }
        return sum / area;
    }

    Eigen::Rotation2Dd m_turn{0};
    Vec2 m_from, m_to;
};

double farthest(const BSpline2& from, const BSpline2& to, const Alignment2& place)
{
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec2 at = from.at(from.wrapped(from.domainStart() + from.period() * i / 1000));
        worst = std::max(worst, to.closest(place(at)).distance);
    }
    return worst;
}

class RoundTrip : public testing::TestWithParam<std::tuple<std::string, Format>> {};

TEST_P(RoundTrip, KeepsWhatACutterIsTold)
{
    const auto& [name, format] = GetParam();
    const Design design = withMarks(test::sampleDesign(name));
    CutOptions options;
    options.faceUp = false;
    const CutPattern pattern = cutPattern(design, options);
    const Drawing drawing = written(pattern, format);
    EXPECT_TRUE(drawing.unknown.empty()) << drawing.unknown.begin()->first;
    const FoundPattern found = findPieces(drawing, {1, "", 0});
    EXPECT_TRUE(found.open.empty());
    const ImportedPattern imported = patternEdit(Design(), found);
    for (const Message& note : imported.notes)
        ADD_FAILURE() << note.english();
    const Design again = Design().with(imported.edit);
    ASSERT_EQ(imported.patches.size(), pattern.pieces.size());
    const CutPattern cutAgain = cutPattern(again, options);

    for (std::size_t i = 0; i < cutAgain.pieces.size(); ++i) {
        const CutPiece& after = cutAgain.pieces[i];
        const auto original = std::ranges::find(pattern.pieces, after.name, &CutPiece::name);
        ASSERT_NE(original, pattern.pieces.end()) << after.name;
        SCOPED_TRACE(after.name);
        const CutPiece& before = *original;
        EXPECT_EQ(after.quantity, before.quantity);
        EXPECT_EQ(after.pair, before.pair);
        EXPECT_EQ(after.nap, before.nap);
        EXPECT_NEAR(after.tolerance, before.tolerance, 1e-9);
        EXPECT_EQ(after.fabricName, before.fabricName);
        EXPECT_EQ(after.note, before.note);
        const Patch &old = *design.find<Patch>(before.patch), &now = *again.find<Patch>(after.patch);
        const Alignment2 place(now, old);
        EXPECT_LT(farthest(now.outline, old.outline, place), 0.05);
        EXPECT_NEAR(areaOf(after.cut), areaOf(before.cut), 1e-4 * areaOf(before.cut))
            << static_cast<int>(now.allowance->corner) << " " << now.allowance->width;
        EXPECT_NEAR(areaOf(after.sew), areaOf(before.sew), 1e-4 * areaOf(before.sew));
        ASSERT_EQ(after.notches.size(), before.notches.size());
        for (const CutNotch& notch : after.notches) {
            double nearest = 1e9;
            const CutNotch* same = nullptr;
            for (const CutNotch& other : before.notches)
                if (const double off = (place(notch.sewn) - other.sewn).norm(); off < nearest) {
                    nearest = off;
                    same = &other;
                }
            EXPECT_LT(nearest, 0.1);
            EXPECT_EQ(notch.shape.kind, same->shape.kind);
            EXPECT_NEAR(notch.shape.depth, same->shape.depth, 0.01);
            EXPECT_EQ(notch.twice, same->twice);
        }
        ASSERT_EQ(after.holes.size(), 1u);
        EXPECT_LT((place(after.holes[0].at) - before.holes[0].at).norm(), 0.01);
        EXPECT_NEAR(after.holes[0].diameter, 3.5, 1e-3);
        ASSERT_EQ(after.inner.size(), before.inner.size());
        EXPECT_NEAR(lengthOf(after.inner[0].points, false), lengthOf(before.inner[0].points, false), 0.02);
    }
}

/// Sums up how long the parts of an outline are that have another allowance than they had, mm.
double otherwiseCut(const Design& before, const Patch& old, const Design& after, ElementId id,
                    const Alignment2& place)
{
    const MarksByPatch marksBefore = cutMarks(before), marksAfter = cutMarks(after);
    const Patch& now = *after.find<Patch>(id);
    ElementId oldId{};
    before.each<Patch>([&](ElementId other, const Patch& patch) {
        if (&patch == &old)
            oldId = other;
    });
    constexpr int count = 1000;
    double length = 0;
    Vec2 last = now.outline.at(now.outline.domainStart());
    for (int k = 0; k < count; ++k) {
        const auto at = [&](double share) {
            return now.outline.wrapped(now.outline.domainStart() + now.outline.period() * share / count);
        };
        const Vec2 next = now.outline.at(at(k + 1));
        const double there = old.outline.closest(place(now.outline.at(at(k + 0.5)))).parameter;
        const double width = allowanceAt(after, marksAfter, {id, at(k + 0.5)}, std::nullopt);
        if (std::abs(width - allowanceAt(before, marksBefore, {oldId, there}, std::nullopt)) > 0.06)
            length += (next - last).norm();
        last = next;
    }
    return length;
}

/// As it is, and with allowances of all kinds.
TEST(RoundTrips, KeepTheAllowanceOfEveryEdge)
{
    for (const char* const name : {"armchair", "armchair-scan", "box-cushion", "car-seat", "car-seat-cushioned",
                                   "cylinder", "pillow", "room-scan", "trapezoid", "trapezoid-cushion"})
        for (const bool marked : {false, true}) {
            Design design = test::sampleDesign(name);
            design = marked ? withMarks(design) : design;
            CutOptions options;
            options.faceUp = false;
            const CutPattern pattern = cutPattern(design, options);
            for (const Format format : {Format::Aama, Format::Svg}) {
                const ImportedPattern imported =
                    patternEdit(Design(), findPieces(written(pattern, format), {1, "", 0}));
                const Design again = Design().with(imported.edit);
                ASSERT_EQ(imported.patches.size(), pattern.pieces.size()) << name;
                for (const CutPiece& after : cutPattern(again, options).pieces) {
                    const auto original = std::ranges::find(pattern.pieces, after.name, &CutPiece::name);
                    ASSERT_NE(original, pattern.pieces.end()) << after.name;
                    const Patch &old = *design.find<Patch>(original->patch), &now = *again.find<Patch>(after.patch);
                    EXPECT_LT(otherwiseCut(design, old, again, after.patch, Alignment2(now, old)), 4)
                        << name << ": " << after.name << (marked ? ", marked" : "");
                }
            }
        }
}

/// A panel with a dart in an edge that is sewn to another one: notches mark its mouth, on both pieces.
TEST(RoundTrips, KeepNotchesAtTheMouthOfADart)
{
    for (const double allowance : {6.0, 10.0, 25.0})
        for (const double tip : {40.0, 55.0})
            for (const Format format : {Format::Aama, Format::Astm, Format::Plain, Format::Svg}) {
                SCOPED_TRACE(testing::Message() << allowance << " " << tip << " " << static_cast<int>(format));
                Patch left, right;
                left.name = "Left";
                left.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {200, 100}, {0, 100}});
                right.name = "Right";
                right.outline = BSpline2(1, true, {{0, 0}, {150, 0}, {150, 80}, {0, 80}});
                left.allowance = right.allowance = CutAllowance{allowance, CornerJoin::Mitred};
                Design design = Design().with(
                    {{},
                     {{ElementId(1), nullptr, makeElement(left)}, {ElementId(2), nullptr, makeElement(right)}}});
                design = design.with(edits::addSeam(design, {ElementId(1), 1, 2}, {ElementId(2), 3, 4}, true));
                Message problem;
                const Edit dart = edits::addDart(design, {ElementId(1), 1.3, 1.5, {140, tip}}, &problem);
                ASSERT_FALSE(dart.empty()) << problem.english();
                design = design.with(dart);

                const ImportedPattern imported =
                    patternEdit(Design(), findPieces(written(cutPattern(design, {}), format), {1, "", 0}));
                const Design again = Design().with(imported.edit);
                std::map<std::string, std::vector<Vec2>> places;
                again.each<Notch>([&](ElementId, const Notch& notch) {
                    const Patch& patch = *again.find<Patch>(notch.place.patch);
                    places[patch.name].push_back(patch.outline.at(notch.place.at));
                });
                const std::vector<Vec2>& notches = places["Left"];
                EXPECT_FALSE(places["Right"].empty());
                const Patch* now = nullptr;
                again.each<Patch>(
                    [&](ElementId, const Patch& patch) { now = patch.name == "Left" ? &patch : now; });
                ASSERT_TRUE(now);
                int atMouth = 0;
                for (const double corner : now->outline.corners())
                    for (const Vec2& notch : notches)
                        atMouth += (notch - now->outline.at(corner)).norm() < 1e-6;
                EXPECT_EQ(atMouth, 2) << "exactly at both of its ends";
            }
}

/// Names of the patches and rounded lengths, so that they can be compared when ids and parameters are others.
struct NamedSeam {
    std::set<std::string> names;
    double length = 0;
};

std::vector<NamedSeam> namedSeams(const Design& design)
{
    std::vector<NamedSeam> seams;
    design.each<Seam>([&](ElementId, const Seam& seam) {
        const Patch &a = *design.find<Patch>(seam.a.patch), &b = *design.find<Patch>(seam.b.patch);
        const double end = unwrappedEnd(seam.a.from, seam.a.to, a.outline.domainStart(), a.outline.domainEnd());
        seams.push_back({{a.name, b.name}, ArcLength2(a.outline).between(seam.a.from, end)});
    });
    return seams;
}

/// Pieces whose corners are round where seams end have notches there, so that all are found again.
TEST(RoundTrips, KeepWhereSeamsEndInsideSmoothEdges)
{
    for (const char* const name : {"car-seat", "car-seat-cushioned"})
        for (const Format format : {Format::Aama, Format::Svg}) {
            const Design design = test::sampleDesign(name);
            Design again = Design().with(
                patternEdit(Design(), findPieces(written(cutPattern(design, {}), format), {1, "", 0})).edit);
            again = again.with(sewProposals(again, proposeSeams(again)));
            const std::vector<NamedSeam> found = namedSeams(again), wanted = namedSeams(design);
            std::size_t right = 0;
            for (const NamedSeam& seam : wanted) {
                const bool sewn = std::ranges::any_of(found, [&](const NamedSeam& other) {
                    return other.names == seam.names && std::abs(other.length - seam.length) < 0.02 * seam.length;
                });
                right += sewn;
                if (!sewn && seam.names.contains("Cushion bolster left"))
                    ADD_FAILURE() << name << ": " << *seam.names.begin() << " - " << *seam.names.rbegin();
            }
            EXPECT_GE(right, wanted.size() - 1) << name;
            EXPECT_LE(found.size(), wanted.size() + 2) << "two hems of one length";
        }
}

std::string caseName(const testing::TestParamInfo<std::tuple<std::string, Format>>& tested)
{
    constexpr const char* words[] = {"Aama", "Astm", "Plain", "Svg"};
    return (std::get<0>(tested.param) == "armchair" ? std::string("Armchair") : std::string("CarSeat"))
        .append(words[static_cast<int>(std::get<1>(tested.param))]);
}

INSTANTIATE_TEST_SUITE_P(Samples, RoundTrip,
                         testing::Combine(testing::Values("car-seat", "armchair"),
                                          testing::Values(Format::Aama, Format::Astm, Format::Plain, Format::Svg)),
                         caseName);

} // namespace
} // namespace bolster
