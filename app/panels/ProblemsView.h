// The list of everything that is wrong; a click shows the element.
#pragma once

#include "Problem.h"

#include <QListWidget>

namespace bolster {

class Document;
class ProblemSet;

class ProblemsView : public QListWidget {
    Q_OBJECT

public:
    ProblemsView(const ProblemSet& problems, const Document& document, QWidget* parent = nullptr);

    /// Of the problem that is chosen: the key of its message, by which the manual knows it; "" when there is none.
    QString currentKey() const;

signals:
    void chosen(bolster::ElementId element);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void fill();
    QString textOf(const Problem& problem) const;

    const ProblemSet& m_problems;
    const Document& m_document;
};

} // namespace bolster
