#include "CurveForms.h"

#include "ArcLength.h"
#include "OrientationBoxes.h"
#include "TrimSection.h"
#include "Units.h"

namespace bolster {

namespace {

template <int Dim>
QString lengthOf(const BSpline<Dim>& curve)
{
    return curve.empty() ? QString() : lengthText(ArcLength<Dim>(curve).total());
}

} // namespace

void FixationCurveForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<FixationCurve> curve(m_document, ids, form);
    curve.name();
    curve.info(tr("Length"), [](const Design&, const FixationCurve& c) { return lengthOf(c.curve); });
    curve.info(tr("Points"),
               [](const Design&, const FixationCurve& c) { return QString::number(c.curve.pointCount()); });
}

void HandleCurveForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<HandleCurve> handle(m_document, ids, form);
    handle.name();
    handle.info(tr("Patch"),
                [](const Design& design, const HandleCurve& h) { return displayName(design, h.patch); });
    handle.info(tr("In the pattern"), [](const Design&, const HandleCurve& h) { return lengthOf(h.curve); });
    handle.info(tr("In space"), [](const Design&, const HandleCurve& h) {
        return h.hasTarget() ? lengthOf(h.target) : tr("free");
    });
    handle.field(&HandleCurve::match);
    handle.field(&HandleCurve::use);
    OrientationFields::add(form, handle);
}

void MeasurementForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Measurement> measured(m_document, ids, form);
    measured.name();
    measured.info(tr("From"),
                  [](const Design& design, const Measurement& m) { return displayName(design, m.from.patch); });
    measured.info(tr("To"),
                  [](const Design& design, const Measurement& m) { return displayName(design, m.to.patch); });
    measured.info(tr("In the pattern"), [](const Design&, const Measurement& m) {
        return m.from.patch == m.to.patch ? lengthText((m.to.position - m.from.position).norm(), 2)
                                          : tr("two patches");
    });
    if (!measured.several())
        measured.info(tr("On the cover"), [this, id = ids.front()](const Design&, const Measurement&) {
            const auto found = m_sources.coverLengths.find(id);
            return found == m_sources.coverLengths.end() ? tr("not yet") : lengthText(found->second, 2);
        });
}

void FancySeamForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<FancySeam> seam(m_document, ids, form);
    seam.name();
    seam.info(tr("Patch"), [](const Design& design, const FancySeam& s) { return displayName(design, s.patch); });
    seam.field(&FancySeam::width);
    seam.field(&FancySeam::depth);
    seam.field(&FancySeam::profile);
    seam.field(&FancySeam::use);
    seam.info(tr("Length"), [](const Design&, const FancySeam& s) { return lengthOf(s.curve); });
    form.addNote([seam] {
        return seam.shared([](const FancySeam& s) { return s.depth < 0; }) == true ? tr("It stands out: a welt.")
                                                                                   : QString();
    });
    TrimSection::add(form, seam);
}

void InternalLineForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<InternalLine> line(m_document, ids, form);
    line.name();
    line.info(tr("Patch"),
              [](const Design& design, const InternalLine& l) { return displayName(design, l.patch); });
    line.field(&InternalLine::purpose);
    line.field(&InternalLine::use);
    line.info(tr("Length"), [](const Design&, const InternalLine& l) { return lengthOf(l.curve); });
}

} // namespace bolster
