// What a tool of the 3D view writes beside the pointer.
#pragma once

#include "CoverTool.h"

#include <QWidget>

namespace bolster {

/// Lies above its parent without taking the pointer, so that the parent need not be drawn again.
class PointerNote : public QWidget {
    Q_OBJECT

public:
    explicit PointerNote(QWidget* parent);

    /// Nothing hides it.
    void showNote(const std::optional<SceneNote>& note);
    const std::optional<SceneNote>& note() const { return m_note; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<SceneNote> m_note;
};

} // namespace bolster
