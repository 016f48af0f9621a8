// The descriptions of all kinds of elements.
#pragma once

#include "ColourwayFields.h"
#include "CushionFields.h"
#include "DrillHoleFields.h"
#include "Element.h"
#include "FabricFields.h"
#include "FixationFields.h"
#include "MeasurementFields.h"
#include "PatchCurveFields.h"
#include "PatchFields.h"
#include "PlacedFields.h"
#include "SeamFields.h"
#include "SettingsFields.h"

#include <type_traits>
#include <utility>

namespace bolster {

/// It has no fields, only its text.
template <>
struct Description<Quarantined> {
    static constexpr const char* word = "unreadable";
    static constexpr KindNames names{900, QT_TRANSLATE_NOOP("ElementText", "Unusable element"),
                                     QT_TRANSLATE_NOOP("ElementText", "Unusable elements"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 unusable elements"), "warning"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add an unreadable element");
    static SolveCost comes(const Quarantined&) { return SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V&, S&...)
    {}
};

/// Walks over the fields of an element.
template <class V>
void describe(V& walker, const Element& element)
{
    std::visit([&]<class T>(const T& value) { Description<T>::of(walker, value); }, element);
}

/// The same where the walker may change what it walks over.
template <class V>
void describe(V& walker, Element& element)
{
    std::visit([&]<class T>(T& value) { Description<T>::of(walker, value); }, element);
}

/// Calls visit.template operator()<T>() for each kind, in the order of Element.
template <class Visit>
void eachKind(Visit visit)
{
    [&]<std::size_t... I>(std::index_sequence<I...>)
    {
        (visit.template operator()<std::variant_alternative_t<I, Element>>(), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Element>>());
}

/// Its place in Element; npos for AnyKind.
template <class T>
constexpr std::size_t placeOfKind()
{
    std::size_t place = 0, found = std::variant_npos;
    eachKind([&]<class K>() {
        if (std::is_same_v<K, T>)
            found = place;
        ++place;
    });
    return found;
}

/// Whether the text form has elements of this kind: all but the settings, which stand at its head, and what is
/// none.
template <class T>
inline constexpr bool isWritten = !std::is_same_v<T, Settings> && !std::is_same_v<T, Quarantined>;

/// The same for those alone.
template <class Visit>
void eachWrittenKind(Visit visit)
{
    eachKind([&]<class T>() {
        if constexpr (isWritten<T>)
            visit.template operator()<T>();
    });
}

} // namespace bolster
