#include "ElementRules.h"

#include "DesignCheck.h"
#include "Kinds.h"
#include "StretchLength.h"
#include "Twins.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace bolster {

namespace {

constexpr double largestNumber = 1e7;
constexpr double shortestLength = 1e-3; // mm: of anything that has a length
constexpr double resolvedShare = 0.35;  // of the edge length: the smallest bending length that a mesh can show
constexpr std::size_t mostDirections = 10'000;

bool isColor(const std::string& text)
{
    const auto isHex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    return text.size() == 7 && text[0] == '#' && std::all_of(text.begin() + 1, text.end(), isHex);
}

bool isEdgeLength(double length)
{
    return length > 0 && length <= largestNumber;
}

} // namespace

double ease(double lengthA, double lengthB)
{
    const auto [shorter, longer] = std::minmax(lengthA, lengthB);
    return shorter > 0 ? longer / shorter - 1 : 0;
}

bool stretchesOverlap(const BSpline2& outline, const Stretch& first, const Stretch& second)
{
    const double period = outline.period();
    const auto extent = [&](const Stretch& stretch) {
        return unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd()) - stretch.from;
    };
    const double offset = second.from - first.from;
    const double ahead = offset - period * std::floor(offset / period); // of the second start, seen from the first
    const double slack = 1e-9 * period;
    const bool startsInside = ahead < extent(first) - slack && ahead < period - slack;
    return startsInside || ahead + extent(second) > period + slack || (period - ahead < slack);
}

// Outlines that run the same way round, seen from their right sides, meet right side to right side when one of them
// is walked backwards.
bool rightSidesMeetReversed(const Patch& a, const Patch& b)
{
    const auto counterClockwise = [](const Patch& patch) {
        return (patch.outline.signedArea() > 0) != patch.wrongSideOut;
    };
    return counterClockwise(a) == counterClockwise(b);
}

ElementRules::ElementRules(const Design& design, Problems& problems)
    : m_design(design)
    , m_problems(problems)
    , m_smallestEdge(smallestEdgeLength(design))
    , m_twins(twinPairs(design))
{
    design.each<Patch>([&](ElementId, const Patch& patch) { m_usedFabrics.insert(patch.fabric); });
}

/// What the descriptions say: limits, references, colours, files, curves with a length.
class FieldRules {
public:
    explicit FieldRules(ElementRules& rules, std::string prefix = {})
        : m_rules(rules)
        , m_prefix(std::move(prefix))
    {}

    template <class Form, class Value>
    void field(const Field&, const Form&, const Value&)
    {}
    void field(const Field& f, const Number& form, const double& value)
    {
        if (f.counts && form.checked)
            m_rules.inRange(at(f), value, form.least, form.most);
    }
    template <class Vector>
    void field(const Field& f, const Coordinates& form, const Vector& values)
    {
        for (const double value : values)
            if (f.counts && !m_rules.inRange(at(f), value, form.least, form.most))
                break;
    }
    void field(const Field& f, const Color& form, const std::string& value)
    {
        if (!form.mayBeEmpty || !value.empty())
            m_rules.color(at(f), value);
    }
    void field(const Field& f, const FileName&, const std::string& value)
    {
        if (auto problem = f.counts ? elementFileProblem(value) : std::nullopt)
            m_rules.error(at(f), std::move(*problem));
    }
    void field(const Field& f, const Turn&, const Quat& value)
    {
        if (!(std::abs(value.norm() - 1) <= 1e-6))
            m_rules.error(at(f), {QT_TRANSLATE_NOOP(
                                      "Message", "must be a quaternion [w, x, y, z] of length 1, not of length %1"),
                                  {numberText(value.norm())}});
    }
    template <class T>
    void field(const Field& f, const Refers<T>& form, const ElementId& id)
    {
        if constexpr (!std::is_same_v<T, AnyKind>) // whoever cares for links has rules of his own
            if (f.counts && form.checked && (id != noElement || form.need == Need::Needed))
                m_rules.reference<T>(at(f), id);
    }
    template <class T>
    void field(const Field& f, const Refers<T>&, const std::vector<ElementId>& ids)
    {
        for (std::size_t i = 0; i < ids.size(); ++i)
            m_rules.reference<T>(at(f) + "[" + std::to_string(i) + "]", ids[i]);
    }
    template <int Dim>
    void field(const Field& f, const Curve& form, const BSpline<Dim>& curve)
    {
        if (f.counts && !form.outline)
            m_rules.needsLength(at(f) + ".points", curve);
    }
    void field(const Field&, const Directions&, const Orientation& orientation) { m_rules.directions(orientation); }
    void field(const Field& f, const Planes&, const std::vector<HalfSpace>& planes)
    {
        for (std::size_t i = 0; i < planes.size(); ++i)
            if (!(planes[i].normal.norm() > 0))
                m_rules.error(
                    at(f) + "[" + std::to_string(i) + "]",
                    {QT_TRANSLATE_NOOP("Message", "the first three numbers are the plane's normal; not all of them "
                                                  "may be 0")});
    }
    template <class T>
    void group(const Field& f, const T& value)
    {
        FieldRules(m_rules, at(f) + ".").part({}, value);
    }
    template <class T>
    void group(const Field& f, const std::optional<T>& value)
    {
        if (value)
            group(f, *value);
    }
    template <class T>
    void part(const Field&, const T& value)
    {
        Description<T>::of(*this, value);
    }
    template <class Walk>
    void within(const Field& f, Walk walk)
    {
        FieldRules inner(m_rules, at(f) + ".");
        walk(inner);
    }
    template <class T>
    void list(const Field& f, const Entries&, const std::vector<T>& entries)
    {
        for (std::size_t i = 0; i < entries.size(); ++i)
            FieldRules(m_rules, at(f) + "[" + std::to_string(i) + "].").part({}, entries[i]);
    }
    template <class T>
    void usual(const T&)
    {}

private:
    std::string at(const Field& f) const { return m_prefix + f.key; }

    ElementRules& m_rules;
    std::string m_prefix;
};

void ElementRules::check(ElementId id, const Element& element)
{
    m_id = id;
    m_label = elementLabel(id, element);
    FieldRules fields(*this);
    std::visit(
        [&]<class T>(const T& value) {
            fields.part({}, value);
            if constexpr (requires { rules(value); })
                rules(value);
        },
        element);
    twin(element);
}

/// A link matters to editing alone, so nothing about it makes an element unusable.
void ElementRules::twin(const Element& element)
{
    const Twin* link = twinLink(element);
    if (!link)
        return;
    const auto pair = m_twins.find(m_id);
    if (pair == m_twins.end()) {
        warn("twin.of",
             {QT_TRANSLATE_NOOP("Message", "element %1 cannot be its twin: that must be another %2 which "
                                           "is nobody else's; until then it has none"),
              {std::to_string(number(link->of)), elementLabel(kindName(element), noElement, "")}});
        return;
    }
    for (const int point : link->released) {
        const auto exists = [&](const auto* curve, int first) {
            return curve && point >= first && point < first + curve->pointCount();
        };
        const BSpline2* plane = planeCurve(element);
        if (!exists(plane, 0) && !exists(spaceCurve(element), plane ? firstTwinSpacePoint : 0))
            warn("twin.released", {QT_TRANSLATE_NOOP("Message", "there is no point %1"), {std::to_string(point)}});
    }
    const std::string other = elementLabel(pair->second, *m_design.element(pair->second));
    const int unlike = unlikePoints(*m_design.element(pair->second), element, symmetryOf(m_design));
    if (unlike < 0)
        warn("twin", {QT_TRANSLATE_NOOP("Message", "its points and knots are not those of %1; the next edit of one "
                                                   "of them makes it the mirror image"),
                      {other}});
    else if (unlike > 0)
        warn("twin", {QT_TRANSLATE_NOOP("Message", "%1 of its points are no mirror images of those of %2; release "
                                                   "them, or move them"),
                      {std::to_string(unlike), other}});
}

void ElementRules::error(std::string field, Message message)
{
    m_problems.push_back({m_id, m_label, std::move(field), std::move(message), Severity::Error});
}

void ElementRules::warn(std::string field, Message message)
{
    m_problems.push_back({m_id, m_label, std::move(field), std::move(message), Severity::Warning});
}

bool ElementRules::inRange(std::string field, double value, double low, double high)
{
    if (value >= low && value <= high)
        return true;
    std::string text = numberText(value);
    if (text == numberText(low) || text == numberText(high))
        text = numberText(value, 17);
    error(std::move(field), {QT_TRANSLATE_NOOP("Message", "is %1, but must lie between %2 and %3"),
                             {text, numberText(low), numberText(high)}});
    return false;
}

void ElementRules::scale(const Placement& placement)
{
    if (!(placement.scale > 0 && placement.scale <= largestNumber))
        error("scale",
              {QT_TRANSLATE_NOOP("Message", "is %1, but must be positive: millimetres per unit of the file"),
               {numberText(placement.scale)}});
}

template <class T>
const T* ElementRules::reference(std::string field, ElementId id)
{
    const ElementPtr element = m_design.element(id);
    if (const T* found = element ? std::get_if<T>(element.get()) : nullptr)
        return found;
    const std::string wanted = elementLabel(kindName(Element{T{}}), noElement, "");
    const std::string given = std::to_string(number(id));
    if (!element)
        error(std::move(field),
              {QT_TRANSLATE_NOOP("Message", "there is no element %1; name a %2"), {given, wanted}});
    else if (std::holds_alternative<Quarantined>(*element))
        error(std::move(field),
              {QT_TRANSLATE_NOOP("Message", "element %1 cannot be read; repair it or name another %2"),
               {given, wanted}});
    else
        error(std::move(field), {QT_TRANSLATE_NOOP("Message", "%1 is no %2; name another element"),
                                 {elementLabel(id, *element), wanted}});
    return nullptr;
}

void ElementRules::rules(const Settings& settings)
{
    if (settings.symmetry && !settings.symmetry->planeUsable())
        warn("symmetry.plane", {QT_TRANSLATE_NOOP("Message", "the plane needs a normal that is not 0, and numbers "
                                                             "within 1e7; x = 0 is used instead")});
    if (settings.symmetry && !settings.symmetry->axisUsable())
        warn("symmetry.axis", {QT_TRANSLATE_NOOP("Message", "the axis needs a direction that is not 0, and numbers "
                                                            "within 1e7; x = 0 is used instead")});
    if (settings.colourway != noElement && !m_design.find<Colourway>(settings.colourway))
        warn("colourway",
             {QT_TRANSLATE_NOOP("Message", "there is no colourway %1; the patches show their own fabrics"),
              {std::to_string(number(settings.colourway))}});
    if (!isEdgeLength(settings.edgeLength))
        error("edge_length",
              {QT_TRANSLATE_NOOP("Message", "is %1, but must be a positive length of at most %2; 12 mm is usual"),
               {numberText(settings.edgeLength), numberText(largestNumber, 8)}});
    else if (settings.edgeLength < m_smallestEdge)
        error("edge_length",
              {QT_TRANSLATE_NOOP("Message", "%1 mm would make more than 5 million triangles; take at "
                                            "least %2 mm for these patches"),
               {numberText(settings.edgeLength), numberText(std::ceil(m_smallestEdge * 100) / 100)}});
}

void ElementRules::color(std::string field, const std::string& text)
{
    if (!isColor(text))
        error(std::move(field),
              {QT_TRANSLATE_NOOP("Message", "\"%1\" is no colour; write it like #7a4a2b"), {text}});
}

void ElementRules::rules(const Fabric& fabric)
{
    if (!(fabric.bendingLength >= 0 && fabric.bendingLength <= largestNumber))
        return;
    const double edgeLength = m_design.settings().edgeLength;
    const double resolved = resolvedShare * edgeLength;
    if (!m_usedFabrics.contains(m_id) || !isEdgeLength(edgeLength) || fabric.bendingLength >= resolved)
        return;
    const double finest = fabric.bendingLength / resolvedShare;
    if (finest >= m_smallestEdge)
        warn(
            "bending_length",
            {QT_TRANSLATE_NOOP("Message",
                               "the mesh cannot resolve folds as small as a bending length of %1 mm makes "
                               "them: with edges of %2 mm it acts like %3 mm; take an edge length of at most "
                               "%4 mm, or a longer bending length"),
             {numberText(fabric.bendingLength), numberText(edgeLength), numberText(resolved), numberText(finest)}});
    else
        warn("bending_length",
             {QT_TRANSLATE_NOOP("Message",
                                "no mesh can resolve folds as small as a bending length of %1 mm makes them: with "
                                "edges of %2 mm it acts like %3 mm; take a longer bending length"),
              {numberText(fabric.bendingLength), numberText(edgeLength), numberText(resolved)}});
}

void ElementRules::rules(const Patch& patch)
{
    if (const std::optional<Message>& wrong = outlineProblemOf(m_id, patch.outline))
        error("outline.points", *wrong);
    if (patch.cutting.quantity != std::round(patch.cutting.quantity))
        warn("cutting.quantity",
             {QT_TRANSLATE_NOOP("Message", "is %1, but must be a whole number; %2 are cut"),
              {numberText(patch.cutting.quantity), numberText(std::ceil(patch.cutting.quantity))}});
}

template <int Dim>
bool ElementRules::range(const std::string& fromField, const std::string& toField, const BSpline<Dim>& curve,
                         double from, double to)
{
    const double start = curve.domainStart();
    const double end = curve.domainEnd();
    const auto [low, high] = addressable(curve);
    const std::size_t before = m_problems.size();
    if (inRange(fromField, from, low, high) && curve.closed() && from == high)
        error(fromField, {QT_TRANSLATE_NOOP("Message", "%1 is the end of the curve; write %2, its start"),
                          {numberText(from), numberText(low)}});
    inRange(toField, to, low, high);
    if (m_problems.size() > before)
        return false;
    if (!curve.closed() && !(from < to)) {
        error(toField, {QT_TRANSLATE_NOOP("Message", "is %1, but must be larger than the start of the stretch, %2"),
                        {numberText(to), numberText(from)}});
        return false;
    }
    const double length = unwrappedEnd(from, to, start, end) - from;
    if (length > 0 && length <= curve.period() * (1 + 1e-12) && length >= 1e-9 * curve.period())
        return true;
    error(toField, {QT_TRANSLATE_NOOP("Message", "the stretch from %1 to %2 is empty or longer than the curve"),
                    {numberText(from, 17), numberText(to, 17)}});
    return false;
}

const Patch* ElementRules::stretch(const std::string& prefix, const Stretch& stretch)
{
    const auto* patch = m_design.find<Patch>(stretch.patch);
    if (!patch || patch->outline.empty() ||
        !range(prefix + "from", prefix + "to", patch->outline, stretch.from, stretch.to) ||
        outlineProblemOf(stretch.patch, patch->outline))
        return nullptr; // a bad outline is reported with its patch
    if (lengthOf(stretch, patch->outline) >= shortestLength)
        return patch;
    error(prefix + "to",
          {QT_TRANSLATE_NOOP("Message", "the stretch from %1 to %2 has no length; the outline's points "
                                        "coincide there"),
           {numberText(stretch.from), numberText(stretch.to)}});
    return nullptr;
}

const std::optional<Message>& ElementRules::outlineProblemOf(ElementId id, const BSpline2& outline)
{
    const auto found = m_outlines.find(id);
    return found != m_outlines.end() ? found->second
                                     : m_outlines.emplace(id, outlineProblem(outline)).first->second;
}

double ElementRules::lengthOf(const Stretch& stretch, const BSpline2& outline)
{
    const ArcLength2& lengths = m_lengths.try_emplace(stretch.patch, outline).first->second;
    return lengths.between(stretch.from,
                           unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd()));
}

// Whether no seam before joins the same two stretches.
bool ElementRules::sewsAnew(const Seam& seam)
{
    const auto key = [](const Stretch& s) { return std::tuple(s.patch, s.from, s.to); };
    const std::pair<StretchKey, StretchKey> sides = std::minmax({key(seam.a), key(seam.b)});
    const auto [known, isNew] = m_sewn.try_emplace(sides, m_id, seam.reversed);
    if (isNew)
        return true;
    const auto& [other, reversed] = known->second;
    const std::string name = elementLabel(other, *m_design.element(other));
    if (reversed == seam.reversed)
        warn("", {QT_TRANSLATE_NOOP("Message", "it sews what %1 sews already; remove one of them"), {name}});
    else
        error("reversed",
              {QT_TRANSLATE_NOOP("Message", "it sews the same stretches as %1, but the other way round: "
                                            "each would be folded onto itself; remove one of the two"),
               {name}});
    return false;
}

void ElementRules::rules(const Seam& seam)
{
    const Patch* a = stretch("a.", seam.a);
    const Patch* b = stretch("b.", seam.b);
    if (!a || !b)
        return;
    if (seam.a.patch == seam.b.patch && stretchesOverlap(a->outline, seam.a, seam.b)) {
        error("b", {QT_TRANSLATE_NOOP("Message",
                                      "the seam would sew a stretch of \"%1\" to itself: %2 to %3 and %4 to %5 "
                                      "overlap; choose two separate stretches"),
                    {a->name, numberText(seam.a.from), numberText(seam.a.to), numberText(seam.b.from),
                     numberText(seam.b.to)}});
        return;
    }
    if (!sewsAnew(seam))
        return;
    if (seam.reversed != rightSidesMeetReversed(*a, *b)) {
        Message message{QT_TRANSLATE_NOOP("Message",
                                          "the seam joins the right side of \"%1\" to the wrong side of \"%2\"; "
                                          "turn \"reversed\" round, or one patch wrong side out"),
                        {a->name, b->name}};
        if (seam.continuity == Continuity::C0)
            warn("reversed", std::move(message));
        else
            error("reversed", std::move(message)); // the surface could not be smooth across it
    }
    const double lengthA = lengthOf(seam.a, a->outline);
    const double lengthB = lengthOf(seam.b, b->outline);
    if (const double ratio = ease(lengthA, lengthB);
        puckers(lengthA, lengthB, seam.ease)) // gathered as it is wanted
        warn("b",
             {QT_TRANSLATE_NOOP("Message", "the sides of the seam are %1 mm (\"%2\") and %3 mm (\"%4\") long: %5 % "
                                           "ease, more than 5 % puckers; make them equal or check the ends of the "
                                           "stretches"),
              {numberText(lengthA), a->name, numberText(lengthB), b->name, numberText(100 * ratio, 3)}});
}

template <int Dim>
void ElementRules::needsLength(std::string field, const BSpline<Dim>& curve)
{
    if (curve.empty() || !(ArcLength<Dim>(curve).total() >= shortestLength))
        error(std::move(field), {QT_TRANSLATE_NOOP("Message", "the curve has no length; move its points apart")});
}

void ElementRules::directions(const Orientation& orientation)
{
    const std::string field = orientation.kind == Orientation::Kind::Normal ? "normal" : "tangent";
    const std::size_t count = orientation.directions.size();
    if (count > mostDirections)
        error(field, {QT_TRANSLATE_NOOP("Message", "there are %1 directions, but at most %2 are possible"),
                      {std::to_string(count), std::to_string(mostDirections)}});
    for (const Vec3& direction : orientation.directions)
        if (!direction.allFinite() || !(direction.norm() >= shortestDirection)) {
            error(field,
                  {QT_TRANSLATE_NOOP("Message", "a direction must be three numbers that are not all 0"), {}});
            return;
        }
    for (std::size_t k = 1; k < count; ++k)
        if (orientation.directions[k - 1].normalized().dot(orientation.directions[k].normalized()) < -0.99) {
            error(field,
                  {QT_TRANSLATE_NOOP("Message", "direction %1 is opposite to the one before, so that it is not "
                                                "known on which way to turn; add one between them"),
                   {std::to_string(k + 1)}});
            return;
        }
}

void ElementRules::rules(const FixationSeam& seam)
{
    stretch("", seam.stretch);
    if (!seam.hasCurve() && seam.curveRange)
        error("curve_from",
              {QT_TRANSLATE_NOOP("Message", "there is no curve; name one, or leave out curve_from and "
                                            "curve_to"),
               {}});
    if (!seam.hasCurve() && !seam.orientation.empty())
        return;
    const auto* fixation = m_design.find<FixationCurve>(seam.curve);
    if (!fixation || fixation->curve.empty() || !seam.curveRange)
        return;
    const auto [from, to] = *seam.curveRange;
    if (!range("curve_from", "curve_to", fixation->curve, from, to))
        return;
    const double end = unwrappedEnd(from, to, fixation->curve.domainStart(), fixation->curve.domainEnd());
    if (!(ArcLength3(fixation->curve).between(from, end) >= shortestLength))
        error("curve_to", {QT_TRANSLATE_NOOP("Message", "the curve from %1 to %2 has no length"),
                           {numberText(from), numberText(to)}});
}

void ElementRules::rules(const Frame& frame)
{
    scale(frame);
}

void ElementRules::rules(const Foam& foam)
{
    scale(foam);
}

void ElementRules::rules(const Scan& scan)
{
    this->scale(scan);
}

void ElementRules::rules(const HandleCurve& handle)
{
    if ((handle.hasTarget() || handle.orientation.empty()) && handle.target.closed() != handle.curve.closed())
        error("target.closed", {QT_TRANSLATE_NOOP("Message", "the curve in the patch and its target must both be "
                                                             "open or both be closed")});
}

void ElementRules::rules(const Colourway& colourway)
{
    std::set<ElementId> known;
    for (std::size_t i = 0; i < colourway.fabrics.size(); ++i) {
        const ElementId patch = colourway.fabrics[i].patch;
        if (m_design.find<Patch>(patch) && !known.insert(patch).second)
            error("fabrics[" + std::to_string(i) + "].patch",
                  {QT_TRANSLATE_NOOP("Message", "%1 has a fabric in this colourway already; remove "
                                                "one of the two"),
                   {elementLabel(patch, *m_design.element(patch))}});
    }
}

void ElementRules::rules(const OutlineTrim& trimmed)
{
    stretch("", trimmed.stretch);
}

void ElementRules::rules(const EdgeAllowance& allowance)
{
    const Patch* patch = stretch("", allowance.stretch);
    if (!patch)
        return;
    m_design.each<EdgeAllowance>([&](ElementId other, const EdgeAllowance& before) {
        if (other < m_id && before.stretch.patch == allowance.stretch.patch &&
            stretchesOverlap(patch->outline, before.stretch, allowance.stretch))
            error("from",
                  {QT_TRANSLATE_NOOP("Message", "%1 is an allowance of a part of this stretch already; remove "
                                                "one of the two, or make their stretches meet"),
                   {elementLabel(other, *m_design.element(other))}});
    });
}

void ElementRules::rules(const CutCorner& corner)
{
    place(corner.place);
}

void ElementRules::rules(const Notch& notch)
{
    place(notch.place);
}

void ElementRules::place(const OutlinePlace& place)
{
    const Patch* patch = m_design.find<Patch>(place.patch);
    if (patch && !patch->outline.empty())
        inRange("at", place.at, patch->outline.domainStart(), patch->outline.domainEnd());
}

void ElementRules::rules(const DrillHole& hole)
{
    const Patch* patch = m_design.find<Patch>(hole.place.patch);
    if (patch && !patch->outline.empty() && hole.place.position.allFinite() &&
        !patch->outline.boundingBox().contains(hole.place.position))
        warn("position",
             {QT_TRANSLATE_NOOP("Message", "the hole lies outside of \"%1\"; move it inside"), {patch->name}});
}

void ElementRules::rules(const Measurement& measurement)
{
    constexpr double slack = 0.01; // mm: ends lie on outlines
    const auto end = [&](const char* field, const PatchPoint& point) {
        const Patch* patch = m_design.find<Patch>(point.patch);
        if (!patch || patch->outline.empty() || !point.position.allFinite())
            return;
        if (patch->outline.boundingBox().exteriorDistance(point.position) > slack)
            warn(field,
                 {QT_TRANSLATE_NOOP("Message", "it does not lie in \"%1\" any more; measure anew"), {patch->name}});
    };
    end("from", measurement.from);
    end("to", measurement.to);
}

void ElementRules::rules(const Quarantined& quarantined)
{
    m_problems.insert(m_problems.end(), quarantined.problems.begin(), quarantined.problems.end());
}

} // namespace bolster
