#include "FeelPlayer.h"

#include "CoverView.h"
#include "Document.h"
#include "PatternView.h"
#include "SolverLink.h"

#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

constexpr int frameMs = 16;              // between two moves of a hand's pointer
constexpr int flightMs = 600;            // to a standard view
constexpr int mostWaitMs = 3000;         // for a surface after a drag
constexpr std::size_t mostSurfaces = 20; // that may be on their way to the screen

void keepLongest(WatchedApplication::Longest& longest, const WatchedApplication::Longest& other)
{
    longest.wall = std::max(longest.wall, other.wall);
    if (other.cpu > longest.cpu) {
        longest.cpu = other.cpu;
        longest.what = other.what;
    }
}

} // namespace

FeelPlayer::FeelPlayer(FeelApplication& application, MainWindow& window)
    : m_application(application)
    , m_window(window)
{
    m_clock.start();
    application.watch(&window.patternView(), &window.coverView(),
                      [this](bool pattern, bool cover) { painted(pattern, cover); });
    m_toSolver =
        QObject::connect(&window.solver(), &SolverLink::surfaceChanged, [this](const SurfaceMeshPtr& surface) {
            m_surfaces.emplace_back(surface, m_window.solver().designRevision());
            if (m_surfaces.size() > mostSurfaces)
                m_surfaces.pop_front();
        });
}

FeelPlayer::~FeelPlayer()
{
    QObject::disconnect(m_toSolver);
    m_application.watch(nullptr, nullptr, {});
}

QWidget& FeelPlayer::view(const QString& name)
{
    if (name == QLatin1String("cover"))
        return m_window.coverView();
    return m_window.patternView();
}

void FeelPlayer::play(const FeelEvent& event)
{
    if (event.kind == FeelEvent::Kind::Gesture) {
        finishGesture();
        m_kind = event.text;
        ++m_figures.gestures[m_kind];
        return;
    }
    ++m_figures.events;
    QWidget& target = view(event.widget);
    const QPoint at(static_cast<int>(event.at.x() * target.width()),
                    static_cast<int>(event.at.y() * target.height()));
    send(event, target, at);
    QTest::qWait(event.text == QLatin1String("0") ? flightMs : frameMs);
    if (m_down) {
        keepLongest(m_figures.block, m_application.longestBlock());
        keepLongest(m_figures.paint, m_application.longestPaint());
    }
}

void FeelPlayer::send(const FeelEvent& event, QWidget& view, QPoint at)
{
    switch (event.kind) {
    case FeelEvent::Kind::Press:
        m_application.startWatching();
        m_down = true;
        QTest::mousePress(&view, event.button, {}, at);
        break;
    case FeelEvent::Kind::Move: {
        // QTest::mouseMove sends no pressed buttons.
        const Qt::MouseButtons buttons = m_down ? Qt::MouseButtons(event.button) : Qt::NoButton;
        const double sent = now();
        const std::uint64_t before = m_window.document().revision();
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, buttons, Qt::NoModifier);
        QApplication::sendEvent(&view, &move);
        if (m_down && m_window.document().revision() != before)
            m_moves.push_back({sent, m_window.document().revision(), &view != &m_window.patternView()});
        break;
    }
    case FeelEvent::Kind::Release:
        QTest::mouseRelease(&view, event.button, {}, at);
        m_down = false;
        break;
    case FeelEvent::Kind::Wheel: {
        QWheelEvent wheel(at, view.mapToGlobal(at), {}, QPoint(0, static_cast<int>(120 * event.steps)),
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &wheel);
        break;
    }
    case FeelEvent::Kind::Key: {
        view.setFocus();
        const QKeySequence keys(event.text);
        if (!keys.isEmpty())
            QTest::keyClick(&view, keys[0].key(), keys[0].keyboardModifiers());
        break;
    }
    case FeelEvent::Kind::Gesture:
        break;
    }
}

/// Of the surface that is on the screen; 0: a step on the way from one to the next.
std::uint64_t FeelPlayer::revisionShown() const
{
    const SurfaceMeshPtr shown = m_window.coverView().shownSurface();
    const auto known = std::ranges::find(m_surfaces, shown, &decltype(m_surfaces)::value_type::first);
    return shown && known != m_surfaces.end() ? known->second : 0;
}

void FeelPlayer::painted(bool pattern, bool cover)
{
    const double seen = now();
    const std::uint64_t shown = cover ? revisionShown() : 0;
    std::erase_if(m_moves, [&](Move& move) {
        if (pattern && !std::exchange(move.patternSeen, true))
            m_figures.toPattern.push_back(seen - move.at);
        if (shown < move.revision)
            return false;
        if (m_kind == QLatin1String("outline"))
            m_figures.toSurfaceOutline.push_back(seen - move.at);
        else if (m_kind == QLatin1String("fixation"))
            m_figures.toSurfaceFixation.push_back(seen - move.at);
        return true;
    });
}

void FeelPlayer::finishGesture()
{
    (void)QTest::qWaitFor([this] { return m_window.solver().upToDate(); }, mostWaitMs);
    QTest::qWait(2 * frameMs);
    if (m_kind == QLatin1String("outline") || m_kind == QLatin1String("fixation"))
        m_figures.unseen += static_cast<int>(m_moves.size());
    m_moves.clear();
    m_down = false;
}

} // namespace bolster
