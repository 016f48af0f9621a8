// What the description of a kind says of a field that a form shows.
#pragma once

#include "Kinds.h"
#include "NumberBox.h"

#include <QStringList>

#include <optional>

namespace bolster {

struct DescribedField {
    Field field;
    std::optional<Number> number;
    std::optional<Words> words;
    std::optional<Coordinates> coordinates;

    QString label() const;
    QStringList choices() const;
    /// Of a number, or of each of the coordinates.
    NumberBox::Range range() const;
    bool hasSlider() const { return number && number->box.sliderMost > 0; }
};

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
        found.field = f;
        if constexpr (std::is_same_v<Form, Number>)
            found.number = form;
        else if constexpr (std::is_same_v<Form, Words>)
            found.words = form;
        else if constexpr (std::is_same_v<Form, Coordinates>)
            found.coordinates = form;
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
