// Two colourways of the design side by side.
#pragma once

#include "DesignFiles.h"
#include "Document.h"

#include <QWidget>

#include <array>

class QComboBox;

namespace bolster {

class FabricLink;
class SolverLink;
class VersionPane;

class ColourwayWindow : public QWidget {
    Q_OBJECT

public:
    /// `solver` is that of the document: colourways change nothing of the shape.
    ColourwayWindow(Document& document, const DesignFiles& files, FabricLink& link, SolverLink& solver,
                    QWidget* parent = nullptr);

    /// The design as it is made beside what it shows, or beside the first of its colourways.
    void compare();
    QComboBox& choice(int side) { return *m_sides[static_cast<std::size_t>(side)].choice; }
    VersionPane& pane(int side) { return *m_sides[static_cast<std::size_t>(side)].pane; }

private:
    struct Side {
        QComboBox* choice;
        VersionPane* pane;
    };

    void refill();
    void display(const Side& side);

    Document& m_document;
    const DesignFiles& m_files;
    FabricLink& m_link;
    std::array<Side, 2> m_sides;
    bool m_following = false; ///< one view the other
};

} // namespace bolster
