#include "InspectorForms.h"

#include "ArcLength.h"
#include "Icons.h"
#include "InspectorSubject.h"
#include "OrientationBoxes.h"
#include "PlacementFields.h"
#include "ProblemSet.h"
#include "Translated.h"
#include "Units.h"

#include <cmath>

namespace bolster {

InspectorForms::InspectorForms(Document& document, Selection& selection, ProblemSet& problems,
                               std::function<void(ElementId)> chooseFile,
                               std::function<void(ElementId, ScanWish)> scanWish, PointAtPieces pointAtPieces)
    : m_document(document)
    , m_selection(selection)
    , m_problems(problems)
    , m_chooseFile(std::move(chooseFile))
    , m_scanWish(std::move(scanWish))
    , m_pointAtPieces(std::move(pointAtPieces))
{}

std::unique_ptr<PropertyForm> InspectorForms::make() const
{
    auto form = std::make_unique<PropertyForm>();
    const Selection::Elements& elements = m_selection.elements();
    if (elements.empty())
        addSettings(*form);
    else if (elements.size() == 1 && m_document.design().element(*elements.begin()))
        addElement(*form, *elements.begin());
    else
        addSeveral(*form);
    form->addRoomBelow();
    return form;
}

InspectorForms::Basis InspectorForms::basis() const
{
    Basis basis;
    const Design& design = m_document.design();
    for (const ElementId id : m_selection.elements())
        if (const Fabric* fabric = design.find<Fabric>(id))
            basis.fabricKinds.push_back(fabric->look.kind);
        else if (const Cushion* cushion = design.find<Cushion>(id))
            basis.frames.push_back(cushion->frame);
    return basis;
}

void InspectorForms::addSeveral(PropertyForm& form) const
{
    std::map<ElementKind, Ids> kinds;
    for (const ElementId id : m_selection.elements())
        if (const ElementPtr element = m_document.design().element(id))
            kinds[kindOf(*element)].push_back(id);
    if (kinds.size() > 1)
        form.addHeading(tr("%n elements", nullptr, static_cast<int>(m_selection.elements().size())),
                        icon(QStringLiteral("settings")));
    addSelectedPoints(form);
    addSelectedEdges(form);
    for (const auto& [kind, ids] : kinds) {
        form.addHeading(ids.size() == 1 ? displayName(m_document.design(), ids.front())
                                        : countedText(m_document.design(), ids),
                        icon(kindIcon(kind)));
        addKind(form, kind, ids);
    }
}

void InspectorForms::addElement(PropertyForm& form, ElementId id) const
{
    const ElementKind kind = kindOf(*m_document.design().element(id));
    form.addHeading(kindWord(kind), icon(kindIcon(kind)));
    form.addNote(
        [this, id] { return m_problems.text(id); },
        [this, id] { return m_problems.hasError(id) ? PropertyForm::Tone::Error : PropertyForm::Tone::Warning; });
    addSelectedPoints(form);
    addSelectedEdges(form);
    addKind(form, kind, {id});
}

void InspectorForms::addKind(PropertyForm& form, ElementKind kind, const Ids& ids) const
{
    if (kind == kindOf<Patch>()) {
        addPatch(form, ids);
    } else if (kind == kindOf<Seam>()) {
        addSeam(form, ids);
        addTrim<Seam>(form, ids);
    } else if (kind == kindOf<FixationCurve>()) {
        addFixationCurve(form, ids);
    } else if (kind == kindOf<FixationSeam>()) {
        addFixationSeam(form, ids);
        addTrim<FixationSeam>(form, ids);
    } else if (kind == kindOf<HandleCurve>()) {
        addHandleCurve(form, ids);
    } else if (kind == kindOf<FancySeam>()) {
        addFancySeam(form, ids);
        addTrim<FancySeam>(form, ids);
    } else if (kind == kindOf<OutlineTrim>()) {
        addOutlineTrim(form, ids);
        addTrim<OutlineTrim>(form, ids);
    } else if (kind == kindOf<Colourway>()) {
        addColourway(form, ids);
    } else if (kind == kindOf<Frame>()) {
        addFrame(form, ids);
    } else if (kind == kindOf<Cushion>()) {
        addCushion(form, ids);
    } else if (kind == kindOf<Foam>()) {
        addFoam(form, ids);
    } else if (kind == kindOf<Scan>()) {
        addScan(form, ids);
    } else if (kind == kindOf<Fabric>()) {
        addFabric(form, ids);
    } else if (kind == kindOf<Quarantined>()) {
        addUnusable(form, ids);
    }
    if (ids.size() == 1)
        addTwin(form, ids.front());
}

void InspectorForms::addSettings(PropertyForm& form) const
{
    form.addHeading(kindWord(kindOf<Settings>()), icon(QStringLiteral("settings")));
    const Settings usual;
    const DescribedField edge = describedField(usual, &usual.edgeLength);
    form.addNumber(
        edge.label(), edge.range(), [this] { return m_document.design().settings().edgeLength; },
        [this](double value) {
            Settings settings = m_document.design().settings();
            settings.edgeLength = value;
            m_document.commit(edits::changeSettings(m_document.design(), settings));
        });
    addSymmetry(form);
    form.addInfo(tr("Patches"), [this] {
        int count = 0;
        double area = 0; // mm^2
        m_document.design().each<Patch>([&](ElementId, const Patch& patch) {
            ++count;
            area += patch.outline.empty() ? 0 : std::abs(patch.outline.signedArea());
        });
        return tr("%1, %2 m\u00b2 in all").arg(count).arg(decimalText(area * 1e-6, 2, true));
    });
    form.addInfo(tr("Seams"), [this] {
        int count = 0;
        double length = 0;
        m_document.design().each<Seam>([&](ElementId, const Seam& seam) {
            ++count;
            length += stretchLength(m_document.design(), seam.a);
        });
        return tr("%1, %2 m in all").arg(count).arg(decimalText(length * 1e-3, 2, true));
    });
    form.addNote([] { return tr("Select something to see its properties."); });
}

void InspectorForms::addFabricChoice(PropertyForm& form, const Ids& ids) const
{
    std::vector<ElementId> fabrics;
    QStringList names;
    m_document.design().each<Fabric>([&](ElementId fabric, const Fabric&) {
        fabrics.push_back(fabric);
        names << displayName(m_document.design(), fabric);
    });
    const InspectorSubject<Patch> patch(m_document, ids, form);
    form.addChoice(
        tr("Fabric"), names,
        [patch, fabrics] {
            const auto fabric = patch.shared([](const Patch& p) { return p.fabric; });
            const auto found = fabric ? std::ranges::find(fabrics, *fabric) : fabrics.end();
            return found == fabrics.end() ? -1 : static_cast<int>(found - fabrics.begin());
        },
        [patch, fabrics](int chosen) {
            patch.change(QT_TRANSLATE_NOOP("Message", "Change the fabric of %1"),
                         [&](Patch& p) { p.fabric = fabrics[static_cast<std::size_t>(chosen)]; });
        });
}

void InspectorForms::addPatch(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Patch> patch(m_document, ids, form);
    patch.name(tr("Name"));
    addFabricChoice(form, ids);
    patch.field(&Patch::grain);
    patch.field(&Patch::pressure);
    patch.field(&Patch::wrongSideOut);
    patch.field(&Patch::position);
    patch.field(&Patch::rotation);
    addPatchSize(form, ids);
    patch.info(tr("Outline"), [](const Design&, const Patch& p) {
        return p.outline.empty() ? QString() : lengthText(ArcLength2(p.outline).total(), 0);
    });
}

void InspectorForms::addSeam(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Seam> seam(m_document, ids, form);
    seam.info(tr("First side"), [](const Design& design, const Seam& s) {
        return tr("%1, %2").arg(displayName(design, s.a.patch), lengthText(stretchLength(design, s.a)));
    });
    seam.info(tr("Second side"), [](const Design& design, const Seam& s) {
        return tr("%1, %2").arg(displayName(design, s.b.patch), lengthText(stretchLength(design, s.b)));
    });
    seam.info(tr("Ease"), [](const Design& design, const Seam& s) {
        const double a = stretchLength(design, s.a);
        const double b = stretchLength(design, s.b);
        return a > 0 && b > 0
                   ? tr("%1, %2").arg(lengthText(std::abs(a - b)), percentText(std::max(a, b) / std::min(a, b) - 1))
                   : QString();
    });
    seam.field(&Seam::continuity);
    seam.field(&Seam::match);
    seam.field(&Seam::reversed);
}

void InspectorForms::addFixationCurve(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<FixationCurve> curve(m_document, ids, form);
    curve.name(tr("Name"));
    curve.info(tr("Length"), [](const Design&, const FixationCurve& c) {
        return c.curve.empty() ? QString() : lengthText(ArcLength3(c.curve).total());
    });
    curve.info(tr("Points"),
               [](const Design&, const FixationCurve& c) { return QString::number(c.curve.pointCount()); });
}

void InspectorForms::addCurveChoice(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<FixationSeam> fixation(m_document, ids, form);
    std::vector<ElementId> curves;
    QStringList names;
    // Something must be held.
    if (fixation.shared([](const FixationSeam& f) { return !f.hasCurve() || !f.orientation.empty(); }) == true) {
        curves.emplace_back();
        names << tr("none");
    }
    m_document.design().each<FixationCurve>([&](ElementId curve, const FixationCurve&) {
        curves.push_back(curve);
        names << displayName(m_document.design(), curve);
    });
    form.addChoice(
        tr("Curve"), names,
        [fixation, curves] {
            const auto shared = fixation.shared([](const FixationSeam& f) { return f.curve; });
            const auto found = shared ? std::ranges::find(curves, *shared) : curves.end();
            return found == curves.end() ? -1 : static_cast<int>(found - curves.begin());
        },
        [fixation, curves](int chosen) {
            fixation.change(QT_TRANSLATE_NOOP("Message", "Change the curve of %1"), [&](FixationSeam& f) {
                f.curve = curves[static_cast<std::size_t>(chosen)];
                f.curveRange.reset();
            });
        });
}

void InspectorForms::addFixationSeam(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<FixationSeam> fixation(m_document, ids, form);
    fixation.info(tr("Outline"), [](const Design& design, const FixationSeam& f) {
        return tr("%1, %2").arg(displayName(design, f.stretch.patch), lengthText(stretchLength(design, f.stretch)));
    });
    addCurveChoice(form, ids);
    fixation.info(tr("On the curve"), [](const Design& design, const FixationSeam& f) {
        const FixationCurve* curve = design.find<FixationCurve>(f.curve);
        if (!curve || curve->curve.empty())
            return QString();
        const ArcLength3 length(curve->curve);
        const double all =
            f.curveRange ? length.between(f.curveRange->first, f.curveRange->second) : length.total();
        return lengthText(all);
    });
    fixation.field(&FixationSeam::match);
    fixation.field(&FixationSeam::reversed);
    OrientationFields::add(form, fixation);
}

void InspectorForms::addFrame(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Frame> frame(m_document, ids, form);
    frame.name(tr("Name"));
    frame.info(tr("File"), [](const Design&, const Frame& f) { return QString::fromStdString(f.file); });
    addPlacementFields(form, frame);
    frame.field(&Frame::contact);
    frame.field(&Frame::contactGap);
    addFrameMaterial(form, ids);
    if (frame.several())
        return;
    addFrameParts(form, ids.front());
    form.addButton(tr("Choose an&other file \u2026"), [this, id = ids.front()] { m_chooseFile(id); });
}

void InspectorForms::addUnusable(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Quarantined> bad(m_document, ids, form);
    bad.info(tr("Problems"), [](const Design&, const Quarantined& q) {
        QStringList lines;
        for (const Problem& problem : q.problems)
            lines << translated(problem);
        return lines.join(u'\n');
    });
    form.addNote([] { return tr("It keeps its text and is saved as it is."); });
}

} // namespace bolster
