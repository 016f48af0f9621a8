// What the description of a kind says of a field that a form shows.
#pragma once

#include "Design.h"
#include "Kinds.h"
#include "NumberBox.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace bolster {

/// " mm"; as behind a number.
QString unitSuffix(Unit unit);

struct DescribedField {
    Field field;
    std::optional<Number> number;
    std::optional<Words> words;
    std::optional<Coordinates> coordinates;
    std::size_t refersTo = std::variant_npos; ///< place of the kind in Element
    bool file = false;

    QString label() const;
    QString tip() const;
    QStringList choices() const;
    /// Of a number, or of each of the coordinates.
    NumberBox::Range range() const;
    /// Of a choice that refers to nothing.
    static QString noneText();
    bool hasSlider() const { return number && number->box.sliderMost > 0; }
};

template <class Form>
DescribedField described(const Field& field, const Form& form)
{
    DescribedField said;
    said.field = field;
    if constexpr (std::is_same_v<Form, Number>)
        said.number = form;
    else if constexpr (std::is_same_v<Form, Words>)
        said.words = form;
    else if constexpr (std::is_same_v<Form, Coordinates>)
        said.coordinates = form;
    else if constexpr (requires { typename Form::Kind; })
        said.refersTo = placeOfKind<typename Form::Kind>();
    said.file = std::is_same_v<Form, FileName>;
    return said;
}

/// The elements of the kind at this place in Element with their names, for a choice; first none of them, if that
/// has a name.
struct ElementChoice {
    std::vector<ElementId> ids;
    QStringList names;
};
ElementChoice elementsToChoose(const Design& design, std::size_t kind, const QString& none = {});
/// -1 for nothing, and for what is not among them.
int placeOf(const std::vector<ElementId>& ids, std::optional<ElementId> id);

/// Finds the field at an address.
class FieldFinder {
public:
    explicit FieldFinder(const void* address)
        : m_address(address)
    {}

    template <class Form, class Value>
    void field(const Field& f, const Form& form, const Value& here)
    {
        if (static_cast<const void*>(&here) != m_address)
            return;
        found = described(f, form);
    }
    template <class T>
    void group(const Field&, const T& value)
    {
        part({}, value);
    }
    template <class T>
    void group(const Field&, const std::optional<T>& value)
    {
        if (value)
            part({}, *value);
    }
    template <class T>
    void part(const Field&, const T& value)
    {
        Description<T>::of(*this, value);
    }
    template <class Walk>
    void within(const Field&, Walk walk)
    {
        walk(*this);
    }
    template <class T>
    void list(const Field&, const Entries&, const std::vector<T>&)
    {}
    template <class T>
    void usual(const T&)
    {}

    DescribedField found;

private:
    const void* m_address;
};

/// The field of `value` that lies at this address; an empty key when none does.
template <class T>
DescribedField describedField(const T& value, const void* address)
{
    FieldFinder finder(address);
    finder.part({}, value);
    return finder.found;
}

} // namespace bolster
