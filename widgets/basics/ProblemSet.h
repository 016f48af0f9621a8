// What is wrong with the elements of the design at the moment, shared by all views.
#pragma once

#include "Problem.h"

#include <QObject>
#include <QString>

#include <map>
#include <optional>

namespace bolster {

class ProblemSet : public QObject {
    Q_OBJECT

public:
    explicit ProblemSet(QObject* parent = nullptr);

    void set(Problems problems);
    const Problems& all() const { return m_all; }
    int count(Severity severity) const;
    bool hasError(ElementId id) const { return worst(id) == Severity::Error; }
    bool hasWarning(ElementId id) const { return worst(id) == Severity::Warning; }
    /// The sentences about an element, one a line; "" when there are none.
    QString text(ElementId id) const;

signals:
    void changed();

private:
    std::optional<Severity> worst(ElementId id) const;

    Problems m_all;
    std::multimap<ElementId, std::size_t> m_byElement;
};

} // namespace bolster
