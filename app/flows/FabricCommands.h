// What is done with fabrics and colourways: the dialogs around them, each ending in one edit.
#pragma once

#include "DesignSession.h"
#include "Selection.h"

namespace bolster {

class FabricCommands : public QObject {
    Q_OBJECT

public:
    FabricCommands(DesignSession& session, Selection& selection, QWidget* window);

    /// The fabric that is meant: of the selection, or else the one chosen in the library; noElement for none.
    void setChosen(ElementId fabric) { m_chosen = fabric; }
    ElementId fabric() const;
    /// Where files of fabrics are looked for first; "": where the design lies.
    void setFolder(const QString& folder) { m_folder = folder; }

    void add(const Fabric& fabric);
    void duplicate();
    void rename();
    /// Asks what becomes of what is made of it.
    void remove();
    void assign(const std::vector<ElementId>& patches, ElementId fabric);
    void assignToSelection();
    /// Reads a picture and shows it: on a fabric that is there, or on a new one for noElement.
    void choosePicture(ElementId fabric, const QString& path = {});
    void importFabrics(const QString& path = {});
    void exportFabric(const QString& path = {});

    void newColourway();
    void renameColourway();
    void removeColourway();
    void showColourway(ElementId colourway);

signals:
    void done(const QString& what);
    /// It is new.
    void added(bolster::ElementId fabric);

private:
    const Design& design() const { return m_session.document().design(); }
    void askName(ElementId id, const QString& title);
    bool commit(const Edit& edit);
    void fail(const QString& title, const Message& why);
    void readPicture(const QString& file, ElementId fabric);
    void takePicture(const QString& path, ElementId fabric);
    void readFabrics(const QString& file);
    void takeFabrics(const QString& path, const Design& from, const QString& folder);
    void exportTo(const QString& file, const Fabric& fabric);
    QString startFolder() const;

    DesignSession& m_session;
    Selection& m_selection;
    QWidget* m_window;
    ElementId m_chosen = noElement;
    QString m_folder;
};

} // namespace bolster
