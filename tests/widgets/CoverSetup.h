// A 3D view without a graphics card, with a cover made by hand.
#pragma once

#include "CoverMesh.h"
#include "Design.h"
#include "SoftwareRenderer.h"
#include "SurfaceMesh.h"

#include <QMouseEvent>
#include <QWidget>

#include <atomic>
#include <mutex>
#include <thread>

namespace bolster::test {

inline constexpr ElementId fabricId{1};
inline constexpr ElementId leftPatch{2};
inline constexpr ElementId rightPatch{3};
inline constexpr ElementId curveId{4};
inline constexpr ElementId seamId{5};

/// Two squares of 200 mm side by side and a fixation curve above them, y = 100, z = 50, from x = 0 to 400.
Design twoSquares();
/// Their cover: flat in z = 0, the left one from x = 0 to 200, sewn at x = 200.
SurfaceMeshPtr twoSquaresCover();

/// Four triangles for each of a cover, its points raised by `height`.
CoverMeshPtr raisedCover(const SurfaceMeshPtr& surface, float height);

/// Fills the picture with one colour and remembers what it was asked for.
class StubRenderer : public SoftwareRenderer {
public:
    struct Log {
        std::mutex mutex;
        std::vector<Request> requests;
        std::thread::id thread;

        int count()
        {
            const std::lock_guard lock(mutex);
            return static_cast<int>(requests.size());
        }
        Request last()
        {
            const std::lock_guard lock(mutex);
            return requests.back();
        }
    };

    explicit StubRenderer(std::shared_ptr<Log> log)
        : m_log(std::move(log))
    {}
    Picture render(const Request& request, std::stop_token stop) override;

private:
    std::shared_ptr<Log> m_log;
};

/// Pointer events with all their buttons, as a window system sends them.
class Mouse {
public:
    explicit Mouse(QWidget& widget)
        : m_widget(widget)
    {}

    void move(QPointF at, Qt::KeyboardModifiers modifiers = {});
    void press(QPointF at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers modifiers = {});
    void release(QPointF at, Qt::KeyboardModifiers modifiers = {});
    void click(QPointF at, Qt::KeyboardModifiers modifiers = {});
    void doubleClick(QPointF at);
    /// In ten steps.
    void drag(QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = {});
    void wheel(QPointF at, int notches);

private:
    void send(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

    QWidget& m_widget;
    Qt::MouseButton m_pressed = Qt::NoButton;
};

} // namespace bolster::test
