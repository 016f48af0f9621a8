#include "UsualFields.h"

#include "Kinds.h"

#include <algorithm>

namespace bolster {

namespace {

/// Walks over an element and the usual one in step.
class UsualWalker {
public:
    UsualWalker(const std::vector<std::string>& wrong, std::size_t& mended, std::string prefix = {})
        : m_wrong(wrong)
        , m_mended(mended)
        , m_prefix(std::move(prefix))
    {}

    template <class Form, class Value>
    void field(const Field&, const Form&, Value&, const Value&)
    {}
    template <class T>
    void field(const Field& f, const Refers<T>& form, ElementId& id, const ElementId& usual)
    {
        if (form.need != Need::Needed)
            setBack(f, id, usual);
    }
    template <class Value>
    void field(const Field& f, const Number&, Value& value, const Value& usual)
    {
        setBack(f, value, usual);
    }
    template <class Value>
    void field(const Field& f, const Words&, Value& value, const Value& usual)
    {
        setBack(f, value, usual);
    }
    void field(const Field& f, const Color&, std::string& value, const std::string& usual)
    {
        setBack(f, value, usual);
    }
    void field(const Field& f, const FileName&, std::string& value, const std::string& usual)
    {
        if (!m_prefix.empty()) // an element that is of a file is nothing without it
            m_withoutFile = setBack(f, value, usual) || m_withoutFile;
    }
    template <class T>
    void group(const Field& f, T& value, const T&)
    {
        const T usual = usualOf(value);
        UsualWalker walker = inner(f);
        walker.part(f, value, usual);
        if (walker.m_withoutFile)
            value = T{}; // what is of a file is nothing without it
    }
    template <class T>
    void group(const Field& f, std::optional<T>& value, const std::optional<T>&)
    {
        if (value)
            group(f, *value, *value);
    }
    template <class T>
    void part(const Field& f, T& value, const T& usual)
    {
        if (shapesNothing(f))
            Description<T>::of(*this, value, usual);
    }
    template <class Walk>
    void within(const Field& f, Walk walk)
    {
        UsualWalker walker = inner(f);
        walk(walker);
    }
    template <class T>
    void list(const Field&, const Entries&, std::vector<T>&, const std::vector<T>&)
    {}
    template <class T>
    void usual(T&, const T&)
    {}

private:
    static bool shapesNothing(const Field& f) { return f.cost == SolveCost::Nothing; }

    UsualWalker inner(const Field& f) const { return {m_wrong, m_mended, m_prefix + f.key + "."}; }

    /// Whether it was wrong.
    template <class Value>
    bool setBack(const Field& f, Value& value, const Value& usual)
    {
        if (!shapesNothing(f) || std::ranges::count(m_wrong, m_prefix + f.key) == 0)
            return false;
        value = usual;
        ++m_mended;
        return true;
    }

    const std::vector<std::string>& m_wrong; // each once
    std::size_t& m_mended;                   // of them
    std::string m_prefix;
    bool m_withoutFile = false;
};

} // namespace

ElementPtr withUsualFields(const Element& element, const std::vector<std::string>& fields)
{
    std::vector<std::string> wrong = fields;
    std::ranges::sort(wrong);
    wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
    Element mended = element;
    std::size_t count = 0;
    UsualWalker walker(wrong, count);
    std::visit(
        [&]<class T>(T& value) {
            const T usual = usualOf(value);
            walker.part({}, value, usual);
        },
        mended);
    return count == wrong.size() ? makeElement(std::move(mended)) : nullptr;
}

} // namespace bolster
