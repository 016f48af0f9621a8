// Asks what the numbers in a mesh file mean, and shows the size that follows.
#pragma once

#include "FrameGuess.h"

#include <QDialog>

#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;

namespace bolster {

class NumberBox;

class FrameImportDialog : public QDialog {
    Q_OBJECT

public:
    /// `replaced`: the frame that gets this mesh; its placement is kept unless the user wants another one.
    FrameImportDialog(const QString& file, std::shared_ptr<const TriangleMesh> mesh,
                      std::optional<Frame> replaced = {}, QWidget* parent = nullptr);

    /// Name, scale, position and rotation as chosen; no file.
    Frame frame() const;
    void setUnit(FileUnit unit);
    void setUpAxis(UpAxis up);

private:
    void updateSize();

    QString m_name;
    std::shared_ptr<const TriangleMesh> m_mesh;
    std::optional<Frame> m_replaced;
    QCheckBox* m_keep;
    QComboBox* m_unit;
    NumberBox* m_factor;
    QComboBox* m_up;
    QCheckBox* m_onFloor;
    QLabel* m_size;
    QLabel* m_hint;
};

} // namespace bolster
