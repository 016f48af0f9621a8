// Asks what the numbers in a mesh file mean, and shows the size that follows.
#pragma once

#include "FrameGuess.h"

#include <QDialog>

#include <memory>

class QCheckBox;
class QComboBox;
class QLabel;

namespace bolster {

class NumberBox;

class FrameImportDialog : public QDialog {
    Q_OBJECT

public:
    FrameImportDialog(const QString& file, std::shared_ptr<const TriangleMesh> mesh, QWidget* parent = nullptr);

    /// Name, scale, position and rotation as chosen; no file.
    Frame frame() const;
    void setUnit(FileUnit unit);
    void setUpAxis(UpAxis up);

private:
    void updateSize();

    QString m_name;
    std::shared_ptr<const TriangleMesh> m_mesh;
    QComboBox* m_unit;
    NumberBox* m_factor;
    QComboBox* m_up;
    QCheckBox* m_onFloor;
    QLabel* m_size;
    QLabel* m_hint;
};

} // namespace bolster
