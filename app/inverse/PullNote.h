// Says that a scan pulls at the cover that is shown, which the tools of this folder leave out, and switches that
// off and on.
#pragma once

#include "Design.h"

#include <QLabel>

#include <vector>

namespace bolster {

class Document;

/// What a pattern has to be changed for, and by how much, its own cover says. Hidden until a scan pulls.
class PullNote : public QLabel {
    Q_OBJECT

public:
    explicit PullNote(Document& document, QWidget* parent = nullptr);

private:
    void refresh();
    void switchOver();

    Document& m_document;
    std::vector<ElementId> m_pulling; ///< scans that pull, or did so before
};

} // namespace bolster
