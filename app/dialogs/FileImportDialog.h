// Asks what the numbers in a mesh or scan file mean, and shows the size that follows.
#pragma once

#include "FileContent.h"
#include "FileGuess.h"

#include <QDialog>

#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;

namespace bolster {

class NumberBox;

class FileImportDialog : public QDialog {
    Q_OBJECT

public:
    /// `replaced`: where the element stands that gets this content; kept unless the user wants another place.
    FileImportDialog(const QString& file, FileContent content, std::optional<Placement> replaced = {},
                     QWidget* parent = nullptr);

    /// As chosen.
    Placement placement() const;
    void setUnit(FileUnit unit);
    void setUpAxis(UpAxis up);

    void accept() override;

private:
    QString aboutText(const QString& file) const;
    void layOut(const QString& file);
    void connectFields();
    void guess(const QString& file);
    void updateSize();
    void showThinning();
    double largestSize() const; ///< mm: what is usual

    FileContent m_content;
    std::optional<Placement> m_replaced;
    QCheckBox* m_keep;
    QComboBox* m_unit;
    NumberBox* m_factor;
    QComboBox* m_up;
    QCheckBox* m_onFloor;
    QLabel* m_size;
    QLabel* m_hint;
    QLabel* m_thinned; ///< why there are fewer points than in the file
};

} // namespace bolster
