#include "References.h"

#include "Kinds.h"

#include <algorithm>

namespace bolster {

namespace {

/// Walks over what refers to something and passes by all else.
template <class Walker>
class ReferenceWalker {
public:
    template <class Form, class... S>
    void field(const Field&, const Form&, S&...)
    {}
    template <class T, class Ids>
    void field(const Field&, const Refers<T>& form, Ids& ids)
    {
        self().refers(ids, Reference{{}, placeOfKind<T>(), form.need});
    }
    template <class S>
    void group(const Field&, S& value)
    {
        part({}, value);
    }
    template <class S>
    void part(const Field&, S& value)
    {
        if constexpr (requires { *value; }) {
            if (value)
                part({}, *value);
        } else {
            Description<std::remove_const_t<S>>::of(self(), value);
        }
    }
    template <class Walk>
    void within(const Field&, Walk walk)
    {
        walk(self());
    }
    template <class S>
    void list(const Field&, const Entries&, S& entries)
    {
        for (auto& entry : entries)
            part({}, entry);
    }
    template <class S>
    void usual(S&)
    {}

private:
    Walker& self() { return static_cast<Walker&>(*this); }
};

class Gathering : public ReferenceWalker<Gathering> {
public:
    void refers(const ElementId& id, Reference reference)
    {
        reference.id = id;
        if (id != noElement)
            found.push_back(reference);
    }
    void refers(const std::vector<ElementId>& ids, const Reference& reference)
    {
        for (const ElementId& id : ids)
            refers(id, reference);
    }

    std::vector<Reference> found;
};

class Forgetting : public ReferenceWalker<Forgetting> {
public:
    explicit Forgetting(const IsGone& isGone)
        : m_isGone(isGone)
    {}

    void refers(ElementId& id, Reference reference)
    {
        reference.id = id;
        if ((reference.need == Need::Seen || reference.need == Need::Shown) && id != noElement &&
            m_isGone(reference))
            id = {};
    }
    void refers(std::vector<ElementId>& ids, const Reference& reference)
    {
        std::erase_if(ids, [&](ElementId id) { return m_isGone({id, reference.kind, reference.need}); });
    }
    template <class S>
    void list(const Field&, const Entries&, std::vector<S>& entries)
    {
        std::erase_if(entries, [&](const S& entry) {
            Gathering gathering;
            gathering.part({}, entry);
            return std::ranges::any_of(gathering.found, m_isGone);
        });
    }

private:
    const IsGone& m_isGone;
};

class Renumbering : public ReferenceWalker<Renumbering> {
public:
    explicit Renumbering(const std::function<ElementId(const Reference&)>& newId)
        : m_newId(newId)
    {}

    void refers(ElementId& id, Reference reference)
    {
        reference.id = id;
        if (reference.need != Need::Linked && id != noElement)
            id = m_newId(reference);
    }
    void refers(std::vector<ElementId>& ids, const Reference& reference)
    {
        for (ElementId& id : ids)
            refers(id, reference);
    }

private:
    const std::function<ElementId(const Reference&)>& m_newId;
};

} // namespace

std::vector<Reference> references(const Element& element)
{
    Gathering gathering;
    describe(gathering, element);
    return std::move(gathering.found);
}

bool goesAlong(const Element& element, const IsGone& isGone)
{
    const std::vector<Reference> all = references(element);
    const auto isListed = [](const Reference& reference) { return reference.need == Need::Listed; };
    const auto goes = [&](const Reference& reference) {
        return reference.need == Need::Needed && isGone(reference);
    };
    const auto stays = [&](const Reference& reference) { return isListed(reference) && !isGone(reference); };
    return std::ranges::any_of(all, goes) ||
           (std::ranges::any_of(all, isListed) && std::ranges::none_of(all, stays));
}

ElementPtr without(const ElementPtr& element, const IsGone& isGone)
{
    Element rest = *element;
    Forgetting forgetting(isGone);
    describe(forgetting, rest);
    return rest == *element ? element : std::make_shared<const Element>(std::move(rest));
}

Element renumbered(Element element, const std::function<ElementId(const Reference&)>& newId)
{
    Renumbering renumbering(newId);
    describe(renumbering, element);
    return element;
}

} // namespace bolster
