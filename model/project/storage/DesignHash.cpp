#include "DesignHash.h"

#include "DesignJson.h"

namespace bolster {
namespace {

Hash elementHash(ElementId id, const Element& element)
{
    return hashOf(std::to_string(number(id)) + ": " + writeElement(id, element));
}

} // namespace

DesignHash::DesignHash()
{
    m_sum.add(m_elements[settingsId] = elementHash(settingsId, *m_design.element(settingsId)));
}

Hash DesignHash::follow(const Design& design)
{
    for (const ElementId id : differences(m_design, design)) {
        if (const auto known = m_elements.find(id); known != m_elements.end()) {
            m_sum.remove(known->second);
            m_elements.erase(known);
        }
        if (const ElementPtr element = design.element(id))
            m_sum.add(m_elements[id] = elementHash(id, *element));
    }
    m_design = design;
    return m_sum.value();
}

Hash hashOf(const Design& design)
{
    return DesignHash().follow(design);
}

} // namespace bolster
