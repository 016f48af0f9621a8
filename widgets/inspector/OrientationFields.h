// The fields of an inspector form for a held normal.
#pragma once

#include "InspectorSubject.h"

#include <QCoreApplication>

namespace bolster {

class OrientationFields {
    Q_DECLARE_TR_FUNCTIONS(OrientationFields)

public:
    /// T has a member `orientation`.
    template <class T>
    static void add(PropertyForm& form, const InspectorSubject<T>& subject);
};

template <class T>
void OrientationFields::add(PropertyForm& form, const InspectorSubject<T>& subject)
{
    const NumberBox::Range directionRange{QString(), 3, -1e7, 1e7, 0.1};
    const char* const verb = QT_TRANSLATE_NOOP("Message", "Change the normal held by %1");
    const QStringList kinds = {tr("Free"), tr("Normal held"), tr("Tangent plane held")};
    form.addChoice(
        tr("Lean"), kinds,
        [subject] {
            const auto kind = subject.shared([](const T& t) {
                const Orientation& held = t.orientation;
                return held.empty() ? 0 : held.kind == Orientation::Kind::Normal ? 1 : 2;
            });
            return kind.value_or(-1);
        },
        [subject, verb](int choice) {
            subject.change(verb, [choice](T& t) {
                t.orientation.kind = choice == 2 ? Orientation::Kind::Tangent : Orientation::Kind::Normal;
                if (choice == 0)
                    t.orientation.directions.clear();
                else if (t.orientation.empty())
                    t.orientation.directions = {Vec3(0, 0, 1)};
            });
        });
    // A list is edited as a whole by its first direction; what it says along the curve is shown.
    form.addNumbers(
        tr("Direction"), directionRange, 3,
        [subject](int i) {
            return subject.shared([i](const T& t) {
                return t.orientation.empty() ? 0 : static_cast<double>(t.orientation.directions.front()[i]);
            });
        },
        [subject, verb](int i, double value) {
            subject.change(verb, [i, value](T& t) {
                if (t.orientation.empty())
                    t.orientation.directions = {Vec3::Zero()};
                t.orientation.directions.front()[i] = value;
            });
        });
    subject.field(&T::orientation, &Orientation::weight);
    form.addNote([subject] {
        const std::size_t count =
            subject.shared([](const T& t) { return t.orientation.directions.size(); }).value_or(0);
        return count > 1 ? tr("%1 directions, interpolated along the curve; the first is shown.").arg(count)
                         : QString();
    });
}

} // namespace bolster
