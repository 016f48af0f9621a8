// The form of a kind that needs no other than the list of its fields.
#pragma once

#include "ElementForm.h"
#include "InspectorSubject.h"

namespace bolster {

/// Gives the field of this number of a value to a function, in the order of the description. What the value may be
/// without, and lists, have no numbers.
template <class Use>
class FieldByNumber {
public:
    FieldByNumber(int number, Use use)
        : m_left(number)
        , m_use(use)
    {}

    template <class Form, class Value>
    void field(const Field&, const Form&, Value& value)
    {
        if (m_left-- == 0)
            m_use(value);
    }
    template <class S>
    void group(const Field&, S& value)
    {
        part({}, value);
    }
    template <class T>
    void group(const Field&, std::optional<T>&)
    {}
    template <class T>
    void group(const Field&, const std::optional<T>&)
    {}
    template <class S>
    void part(const Field&, S& value)
    {
        Description<std::remove_const_t<S>>::of(*this, value);
    }
    template <class Walk>
    void within(const Field&, Walk walk)
    {
        walk(*this);
    }
    template <class S>
    void list(const Field&, const Entries&, S&)
    {}
    template <class S>
    void usual(S&)
    {}

private:
    int m_left;
    Use m_use;
};

/// That field, which must be a Value.
template <class Value, class T>
auto& fieldByNumber(T& element, int number)
{
    using Found = std::conditional_t<std::is_const_v<T>, const Value, Value>;
    Found* found = nullptr;
    const auto use = [&](auto& value) {
        if constexpr (std::is_same_v<std::remove_const_t<std::remove_reference_t<decltype(value)>>, Value>)
            found = &value;
    };
    FieldByNumber(number, use).part({}, element);
    return *found;
}

/// Makes a row of each field that there is one for.
template <class T>
class FieldRows {
public:
    explicit FieldRows(const InspectorSubject<T>& subject)
        : m_subject(subject)
    {}

    template <class Form, class Value>
    void field(const Field& f, const Form& form, const Value&)
    {
        const auto at = [number = m_next++](auto& element) -> auto&
        {
            return fieldByNumber<Value>(element, number);
        };
        if (std::string_view(f.key) == noteField.key)
            return; // below every form
        if constexpr (std::is_same_v<Form, Text>) {
            if constexpr (requires(const T& named) { named.name; })
                if (std::string_view(f.key) == nameField.key)
                    return m_subject.name();
            m_subject.textRow(described(f, form), at);
        } else if constexpr (InspectorSubject<T>::template hasRow<Form, Value>) {
            const DescribedField said = described(f, form);
            m_subject.row(said.label(), said, at);
        }
    }
    template <class S>
    void group(const Field&, const S& value)
    {
        part({}, value);
    }
    template <class S>
    void group(const Field&, const std::optional<S>&)
    {}
    template <class S>
    void part(const Field&, const S& value)
    {
        Description<S>::of(*this, value);
    }
    template <class Walk>
    void within(const Field&, Walk walk)
    {
        walk(*this);
    }
    template <class S>
    void list(const Field&, const Entries&, const S&)
    {}
    template <class S>
    void usual(const S&)
    {}

private:
    InspectorSubject<T> m_subject;
    int m_next = 0;
};

template <class T>
class DescribedForm : public ElementForm {
public:
    explicit DescribedForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override
    {
        FieldRows<T> rows(InspectorSubject<T>(m_document, ids, form));
        rows.part({}, T{});
    }

private:
    Document& m_document;
};

} // namespace bolster
