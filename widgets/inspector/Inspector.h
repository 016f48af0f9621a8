// The properties of what is selected.
#pragma once

#include "InspectorForms.h"

#include <QScrollArea>

namespace bolster {

/// One element: its properties; nothing: those of the whole design; several: how many they are.
class Inspector : public QScrollArea {
    Q_OBJECT

public:
    Inspector(Document& document, Selection& selection, ProblemSet& problems, QWidget* parent = nullptr);
    ~Inspector() override;

    /// The keyboard goes to the first field.
    void focusFirst();
    void setScanFigures(std::map<ElementId, ScanFigures> figures);
    void setFabricPictures(std::map<ElementId, FabricPictures> pictures);
    void setFiles(DesignFiles files);
    /// Of measurements on the cover, mm.
    void setCoverLengths(const std::map<bolster::ElementId, double>& lengths);

signals:
    /// The user wants another file for this element.
    void fileWanted(bolster::ElementId element);
    void scanWish(bolster::ElementId scan, bolster::ScanWish wish);
    /// What was typed is done, or given up: the keyboard may go elsewhere.
    void typed();
    /// The pointer is over these pieces of a frame in a list of its parts, or over none any more.
    void framePiecesPointedAt(bolster::ElementId frame, const std::vector<int>& pieces);

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void rebuild();
    void refresh();

    InspectorForms m_forms;
    std::vector<int> m_basis; ///< that the form was made for
    PropertyForm* m_form = nullptr;
};

} // namespace bolster
