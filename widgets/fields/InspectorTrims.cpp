// What the inspector shows of stitches, piping and colourways.
#include "InspectorForms.h"

#include "Icons.h"
#include "InspectorSubject.h"
#include "Units.h"

#include <algorithm>

namespace bolster {

namespace {

template <class T>
class TrimFields {
public:
    TrimFields(Document& document, PropertyForm& form, const std::vector<ElementId>& ids)
        : m_form(form)
        , m_subject(document, ids, form)
    {}

    void thread(const QString& label, const char* verb) const
    {
        m_form.addColor(
            label, InspectorForms::tr("Colour of the thread"),
            [s = m_subject] {
                return s.shared([](const T& t) { return QColor(QString::fromStdString(t.trim.thread)); });
            },
            [s = m_subject, verb](const QColor& color) {
                s.change(verb, [&](T& t) { t.trim.thread = color.name().toStdString(); });
            });
    }

    /// The first fabric is none: that of the patch.
    void fabric(const QString& label, const QStringList& names, const std::vector<ElementId>& fabrics,
                const char* verb) const
    {
        m_form.addChoice(
            label, names,
            [s = m_subject, fabrics] {
                const auto shared = s.shared([](const T& t) { return t.trim.pipingFabric; });
                const auto found = shared ? std::ranges::find(fabrics, *shared) : fabrics.end();
                return found == fabrics.end() ? -1 : static_cast<int>(found - fabrics.begin());
            },
            [s = m_subject, fabrics, verb](int chosen) {
                s.change(verb, [&](T& t) { t.trim.pipingFabric = fabrics[static_cast<std::size_t>(chosen)]; });
            });
    }

private:
    PropertyForm& m_form;
    InspectorSubject<T> m_subject;
};

} // namespace

template <class T>
void InspectorForms::addTrim(PropertyForm& form, const Ids& ids) const
{
    static constexpr const char* stitching = QT_TRANSLATE_NOOP("Message", "Change the stitching of %1");
    static constexpr const char* piping = QT_TRANSLATE_NOOP("Message", "Change the piping of %1");
    const TrimFields<T> trim(m_document, form, ids);
    const InspectorSubject<T> subject(m_document, ids, form);
    const auto field = [&](auto member) { subject.field(&T::trim, member); };
    form.addHeading(tr("Stitching"), icon(QStringLiteral("seam")));
    field(&SeamTrim::stitch);
    trim.thread(tr("Thread"), stitching);
    field(&SeamTrim::stitchLength);
    field(&SeamTrim::stitchDistance);
    field(&SeamTrim::threadWidth);
    if constexpr (std::is_same_v<T, Seam>) {
        field(&SeamTrim::allowance);
        field(&SeamTrim::valley);
    }

    QStringList names{tr("As the patch")};
    std::vector<ElementId> fabrics{ElementId{}};
    m_document.design().each<Fabric>([&](ElementId fabric, const Fabric&) {
        fabrics.push_back(fabric);
        names << displayName(m_document.design(), fabric);
    });
    form.addHeading(tr("Piping"), icon(QStringLiteral("outline-trim")));
    field(&SeamTrim::pipingRadius);
    trim.fabric(tr("Fabric"), names, fabrics, piping);
}

template void InspectorForms::addTrim<Seam>(PropertyForm&, const Ids&) const;
template void InspectorForms::addTrim<FancySeam>(PropertyForm&, const Ids&) const;
template void InspectorForms::addTrim<FixationSeam>(PropertyForm&, const Ids&) const;
template void InspectorForms::addTrim<OutlineTrim>(PropertyForm&, const Ids&) const;

void InspectorForms::addOutlineTrim(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<OutlineTrim> trimmed(m_document, ids, form);
    trimmed.info(tr("Outline"), [](const Design& design, const OutlineTrim& t) {
        return tr("%1, %2").arg(displayName(design, t.stretch.patch), lengthText(stretchLength(design, t.stretch)));
    });
}

void InspectorForms::addColourway(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Colourway> colourway(m_document, ids, form);
    colourway.name(tr("Name"));
    colourway.info(tr("Fabrics"), [](const Design& design, const Colourway& c) {
        QStringList lines;
        for (const Colourway::Entry& entry : c.fabrics)
            lines << tr("%1: %2").arg(displayName(design, entry.patch), displayName(design, entry.fabric));
        return lines.isEmpty() ? tr("those of the patches") : lines.join(u'\n');
    });
}

} // namespace bolster
