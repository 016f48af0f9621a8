#include "NumberField.h"

#include "Kinds.h"

namespace bolster {

namespace {

/// Finds the number that a path leads to, and gives it another value if one is wanted.
class NumberWalker {
public:
    NumberWalker(std::string path, std::optional<double> wanted, std::string before = {})
        : m_path(std::move(path))
        , m_wanted(wanted)
        , m_before(std::move(before))
    {}

    std::optional<double> found;
    std::pair<double, double> limits{-noLimit, noLimit}; // of it

    template <class Form, class... S>
    void field(const Field&, const Form&, S&...)
    {}
    void field(const Field& f, const Number& form, double& value)
    {
        meet(m_before + f.key, value, {form.least, form.most});
    }
    template <class Vector>
    void field(const Field& f, const Coordinates& form, Vector& value)
    {
        for (Eigen::Index axis = 0; axis < value.size(); ++axis)
            meet(m_before + f.key + "." + std::to_string(axis), value[axis], {form.least, form.most});
    }
    template <class S>
    void group(const Field& f, S& value)
    {
        NumberWalker inside(m_path, m_wanted, m_before + f.key + ".");
        inside.part({}, value);
        take(inside);
    }
    template <class S>
    void part(const Field&, S& value)
    {
        if constexpr (requires { *value; }) {
            if (value)
                part({}, *value);
        } else {
            Description<S>::of(*this, value);
        }
    }
    template <class Walk>
    void within(const Field& f, Walk walk)
    {
        NumberWalker inside(m_path, m_wanted, m_before + f.key + ".");
        walk(inside);
        take(inside);
    }
    template <class S>
    void list(const Field&, const Entries&, S&)
    {}
    template <class S>
    void usual(S&)
    {}

private:
    void take(const NumberWalker& inside)
    {
        if (!inside.found)
            return;
        found = inside.found;
        limits = inside.limits;
    }

    void meet(const std::string& path, double& value, const std::pair<double, double>& within)
    {
        if (path != m_path)
            return;
        found = value;
        limits = within;
        if (m_wanted)
            value = *m_wanted;
    }

    std::string m_path;
    std::optional<double> m_wanted;
    std::string m_before; // keys of what it is inside of
};

NumberWalker walked(Element& element, const std::string& path, std::optional<double> wanted)
{
    NumberWalker walker(path, wanted);
    describe(walker, element);
    return walker;
}

} // namespace

std::optional<double> numberAt(const Element& element, const std::string& path)
{
    Element copy = element;
    return walked(copy, path, std::nullopt).found;
}

std::optional<std::pair<double, double>> numberLimits(const Element& element, const std::string& path)
{
    Element copy = element;
    const NumberWalker walker = walked(copy, path, std::nullopt);
    return walker.found ? std::optional(walker.limits) : std::nullopt;
}

ElementPtr withNumber(const Element& element, const std::string& path, double value)
{
    Element copy = element;
    return walked(copy, path, value).found ? std::make_shared<const Element>(std::move(copy)) : nullptr;
}

} // namespace bolster
