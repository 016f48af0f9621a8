#include "SewingForms.h"

#include "ArcLength.h"
#include "OrientationBoxes.h"
#include "SeamEase.h"
#include "StretchLength.h"
#include "TrimSection.h"
#include "Units.h"

namespace bolster {

void SeamForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Seam> seam(m_document, ids, form);
    seam.info(tr("First side"), [](const Design& design, const Seam& s) {
        return tr("%1, %2").arg(displayName(design, s.a.patch), lengthText(stretchLength(design, s.a)));
    });
    seam.info(tr("Second side"), [](const Design& design, const Seam& s) {
        return tr("%1, %2").arg(displayName(design, s.b.patch), lengthText(stretchLength(design, s.b)));
    });
    seam.info(tr("Ease"), [](const Design& design, const Seam& s) {
        const SeamEase ease = seamEaseOf(design, s);
        return ease.known() ? tr("%1, %2").arg(lengthText(ease.difference()), percentText(ease.ratio()))
                            : QString();
    });
    seam.field(&Seam::ease);
    seam.field(&Seam::zip);
    seam.field(&Seam::step);
    seam.field(&Seam::continuity);
    seam.field(&Seam::match);
    seam.field(&Seam::reversed);
    TrimSection::add(form, seam);
}

void FixationSeamForm::addCurveChoice(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<FixationSeam> fixation(m_document, ids, form);
    // Something must be held.
    const bool canBeFree =
        fixation.shared([](const FixationSeam& f) { return !f.hasCurve() || !f.orientation.empty(); }) == true;
    const auto [curves, names] = elementsToChoose(m_document.design(), placeOfKind<FixationCurve>(),
                                                  canBeFree ? DescribedField::noneText() : QString());
    form.addChoice(
        tr("Curve"), names,
        [fixation, curves = curves] {
            return placeOf(curves, fixation.shared([](const FixationSeam& f) { return f.curve; }));
        },
        [fixation, curves = curves](int chosen) {
            fixation.change(QT_TRANSLATE_NOOP("Message", "Change the curve of %1"), [&](FixationSeam& f) {
                f.curve = curves[static_cast<std::size_t>(chosen)];
                f.curveRange.reset();
            });
        });
}

void FixationSeamForm::add(PropertyForm& form, const Ids& ids) const
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
    TrimSection::add(form, fixation);
}

void OutlineTrimForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<OutlineTrim> trimmed(m_document, ids, form);
    trimmed.info(tr("Outline"), [](const Design& design, const OutlineTrim& t) {
        return tr("%1, %2").arg(displayName(design, t.stretch.patch), lengthText(stretchLength(design, t.stretch)));
    });
    TrimSection::add(form, trimmed);
}

} // namespace bolster
