// The library of fabrics and the colourways of the design.
#pragma once

#include "Document.h"

#include <QWidget>

class QListWidget;
class QListWidgetItem;

namespace bolster {

class Commands;
class FabricLink;
class Selection;

/// Fabrics are dragged from here onto patches. What the buttons do, the actions decide.
class FabricPanel : public QWidget {
    Q_OBJECT

public:
    FabricPanel(Document& document, Selection& selection, FabricLink& link, Commands& commands,
                QWidget* parent = nullptr);

    /// What is chosen here: noElement for none.
    ElementId fabric() const;
    void setFabric(ElementId fabric);
    QListWidget& fabrics() { return *m_fabrics; }
    QListWidget& colourways() { return *m_colourways; }

    /// What a drag of a fabric carries; its data is the number of the element.
    static QString mimeType();

signals:
    void fabricChosen(bolster::ElementId fabric);
    /// Its properties are wanted.
    void editWanted(bolster::ElementId fabric);
    /// noElement: none.
    void colourwayChosen(bolster::ElementId colourway);

private:
    void fill();
    void fillFabrics();
    void fillColourways();
    void followSelection();
    QString describe(ElementId fabric) const;
    void showMenu(const QPoint& at);

    Document& m_document;
    Selection& m_selection;
    FabricLink& m_link;
    Commands& m_commands;
    QListWidget* m_colourways;
    QListWidget* m_fabrics;
};

} // namespace bolster
