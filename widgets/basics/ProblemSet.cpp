#include "ProblemSet.h"

#include "Translated.h"

#include <QStringList>

#include <algorithm>

namespace bolster {

ProblemSet::ProblemSet(QObject* parent)
    : QObject(parent)
{}

void ProblemSet::set(Problems problems)
{
    if (problems == m_all)
        return;
    m_all = std::move(problems);
    m_byElement.clear();
    for (std::size_t i = 0; i < m_all.size(); ++i)
        m_byElement.emplace(m_all[i].element, i);
    emit changed();
}

int ProblemSet::count(Severity severity) const
{
    return static_cast<int>(
        std::ranges::count_if(m_all, [severity](const Problem& p) { return p.severity == severity; }));
}

QString ProblemSet::text(ElementId id) const
{
    QStringList lines;
    const auto [first, last] = m_byElement.equal_range(id);
    for (auto entry = first; entry != last; ++entry)
        lines << asSentence(translated(m_all[entry->second].message));
    lines.removeDuplicates();
    return lines.join(u'\n');
}

std::optional<Severity> ProblemSet::worst(ElementId id) const
{
    std::optional<Severity> result;
    const auto [first, last] = m_byElement.equal_range(id);
    for (auto entry = first; entry != last; ++entry)
        if (!result || m_all[entry->second].severity == Severity::Error)
            result = m_all[entry->second].severity;
    return result;
}

} // namespace bolster
