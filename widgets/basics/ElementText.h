// How elements are called in the window.
#pragma once

#include "Design.h"
#include "Kinds.h"

#include <QString>

#include <span>

namespace bolster {

/// A kind of elements; the order is that of lists.
class ElementKind {
public:
    explicit ElementKind(const KindNames& names)
        : m_names(&names)
    {}

    const KindNames& names() const { return *m_names; }

    friend bool operator==(const ElementKind& a, const ElementKind& b) { return a.m_names == b.m_names; }
    friend bool operator<(const ElementKind& a, const ElementKind& b)
    {
        return a.m_names->place < b.m_names->place;
    }

private:
    const KindNames* m_names;
};

template <class T>
ElementKind kindOf()
{
    return ElementKind(Description<T>::names);
}
ElementKind kindOf(const Element& element);
/// "Patches".
QString kindTitle(ElementKind kind);
/// "Patch".
QString kindWord(ElementKind kind);
/// "patch", "seam" ...: the icon in resources/icons.
QString kindIcon(ElementKind kind);

/// The name, or for elements without one what they join: "Seat - Front band". Never empty.
QString displayName(const Design& design, ElementId id);
/// The same for lists, which cut by themselves what is too long: a name is whole.
QString listName(const Design& design, ElementId id);
/// For tool tips, which break no lines by themselves: of 90 letters at most.
QString inShortLines(const QString& text);
/// "3 patches", or "3 elements" if they are of different kinds; of a single one its name.
QString countedText(const Design& design, std::span<const ElementId> ids);
/// The same for the words of an edit, which are kept: the number in English, as `translated` takes it.
std::string countedWords(const Design& design, std::span<const ElementId> ids);
/// The lengths of a seam's two stretches and its ease, or "".
QString seamSummary(const Design& design, const Seam& seam);
/// Arc length of a seam's first stretch, of a fixation's or a trim's, mm; 0 for other elements.
double sewnLength(const Design& design, ElementId id);

} // namespace bolster
