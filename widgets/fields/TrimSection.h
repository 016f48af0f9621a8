// The rows of the form of whatever has a trim: stitches and piping.
#pragma once

#include "Icons.h"
#include "InspectorSubject.h"

#include <QCoreApplication>

namespace bolster {

class TrimSection {
    Q_DECLARE_TR_FUNCTIONS(TrimSection)

public:
    /// T has a member `trim`.
    template <class T>
    static void add(PropertyForm& form, const InspectorSubject<T>& subject);
};

template <class T>
void TrimSection::add(PropertyForm& form, const InspectorSubject<T>& subject)
{
    const auto field = [&](auto member) { subject.field(&T::trim, member); };
    form.addHeading(tr("Stitching"), icon(QStringLiteral("seam")));
    field(&SeamTrim::stitch);
    subject.colorField(tr("Colour of the thread"), &T::trim, &SeamTrim::thread);
    field(&SeamTrim::stitchLength);
    field(&SeamTrim::stitchDistance);
    field(&SeamTrim::threadWidth);
    if constexpr (std::is_same_v<T, Seam>) {
        field(&SeamTrim::allowance);
        field(&SeamTrim::valley);
    }
    form.addHeading(tr("Piping"), icon(QStringLiteral("outline-trim")));
    field(&SeamTrim::pipingRadius);
    subject.reference(tr("As the patch"), &T::trim, &SeamTrim::pipingFabric);
}

} // namespace bolster
