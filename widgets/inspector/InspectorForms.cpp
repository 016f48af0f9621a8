#include "InspectorForms.h"

#include "ColourwayForm.h"
#include "CurveForms.h"
#include "CushionForm.h"
#include "CuttingForms.h"
#include "DescribedForm.h"
#include "ElementEdits.h"
#include "FabricForm.h"
#include "FoamForm.h"
#include "FrameForm.h"
#include "Icons.h"
#include "PatchForm.h"
#include "ProblemSet.h"
#include "ScanForm.h"
#include "Selection.h"
#include "SettingsForm.h"
#include "SewingForms.h"
#include "UnusableForm.h"

namespace bolster {

template <class T, class Form, class... Needs>
void InspectorForms::use(Needs&... needs)
{
    m_forms[kindOf<T>()] = std::make_unique<Form>(needs...);
}

/// A kind without a form of its own has the list of its fields.
InspectorForms::InspectorForms(Document& document, const Selection& selection, const ProblemSet& problems,
                               FormWishes wishes)
    : m_document(document)
    , m_selection(selection)
    , m_problems(problems)
    , m_wishes(std::move(wishes))
    , m_points(document, selection)
    , m_edges(document, selection)
    , m_twin(document)
{
    eachWrittenKind([&]<class T>() { use<T, DescribedForm<T>>(document); });
    use<Colourway, ColourwayForm>(document);
    use<Cushion, CushionForm>(document, m_sources, m_wishes);
    use<CutCorner, CutCornerForm>(document);
    use<DrillHole, DrillHoleForm>(document);
    use<EdgeAllowance, EdgeAllowanceForm>(document);
    use<Fabric, FabricForm>(document, m_sources, m_wishes);
    use<FancySeam, FancySeamForm>(document);
    use<FixationCurve, FixationCurveForm>(document);
    use<FixationSeam, FixationSeamForm>(document);
    use<Foam, FoamForm>(document);
    use<Frame, FrameForm>(document, m_sources, m_wishes);
    use<HandleCurve, HandleCurveForm>(document);
    use<InternalLine, InternalLineForm>(document);
    use<Measurement, MeasurementForm>(document, m_sources);
    use<Notch, NotchForm>(document);
    use<OutlineTrim, OutlineTrimForm>(document);
    use<Patch, PatchForm>(document);
    use<Quarantined, UnusableForm>(document);
    use<Scan, ScanForm>(document, m_sources, m_wishes);
    use<Seam, SeamForm>(document);
    use<Settings, SettingsForm>(document);
}

std::unique_ptr<PropertyForm> InspectorForms::make() const
{
    auto form = std::make_unique<PropertyForm>();
    const Selection::Elements& elements = m_selection.elements();
    if (elements.empty())
        m_forms.at(kindOf<Settings>())->add(*form, {settingsId});
    else if (elements.size() == 1 && m_document.design().element(*elements.begin()))
        addElement(*form, *elements.begin());
    else
        addSeveral(*form);
    form->addRoomBelow();
    return form;
}

InspectorForms::Kinds InspectorForms::selectedKinds() const
{
    Kinds kinds;
    for (const ElementId id : m_selection.elements())
        if (const ElementPtr element = m_document.design().element(id))
            kinds[kindOf(*element)].push_back(id);
    return kinds;
}

std::vector<int> InspectorForms::basis() const
{
    std::vector<int> basis;
    for (const auto& [kind, ids] : selectedKinds()) {
        const std::vector<int> numbers = m_forms.at(kind)->rowsDependOn(ids);
        basis.push_back(static_cast<int>(numbers.size()));
        basis.insert(basis.end(), numbers.begin(), numbers.end());
    }
    return basis;
}

void InspectorForms::addSeveral(PropertyForm& form) const
{
    const Kinds kinds = selectedKinds();
    if (kinds.size() > 1)
        form.addHeading(tr("%n elements", nullptr, static_cast<int>(m_selection.elements().size())),
                        icon(QStringLiteral("settings")));
    m_points.add(form);
    m_edges.add(form);
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
    m_points.add(form);
    m_edges.add(form);
    addKind(form, kind, {id});
}

void InspectorForms::addKind(PropertyForm& form, const ElementKind& kind, const Ids& ids) const
{
    m_forms.at(kind)->add(form, ids);
    if (ids.size() == 1) {
        m_twin.add(form, ids.front());
        addNote(form, ids.front());
    }
}

void InspectorForms::addNote(PropertyForm& form, ElementId id) const
{
    if (m_document.design().find<Settings>(id) || m_document.design().find<Quarantined>(id))
        return;
    const auto read = [this, id] {
        const ElementPtr element = m_document.design().element(id);
        return element ? QString::fromStdString(elementNote(*element)) : QString();
    };
    form.addLines(QCoreApplication::translate("Field", noteField.label), read, [this, id](const QString& text) {
        m_document.commit(edits::changeNote(m_document.design(), id, text.toStdString()));
    });
    form.explain(QCoreApplication::translate("Field", noteField.tip));
}

} // namespace bolster
