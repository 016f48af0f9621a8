// The list of everything that is wrong; a click shows the element.
#pragma once

#include "ElementId.h"

#include <QListWidget>

namespace bolster {

class ProblemSet;

class ProblemsView : public QListWidget {
    Q_OBJECT

public:
    explicit ProblemsView(const ProblemSet& problems, QWidget* parent = nullptr);

    /// Of the problem that is chosen: the key of its message, by which the manual knows it; "" when there is none.
    QString currentKey() const;

signals:
    void chosen(bolster::ElementId element);

private:
    void fill();

    const ProblemSet& m_problems;
};

} // namespace bolster
