// Arrow keys pressed one after the other: one edit for all of them.
#pragma once

#include "Document.h"
#include "Gesture.h"
#include "Selection.h"

#include <QTimer>

#include <functional>
#include <memory>

namespace bolster {

/// The series ends when no key has come for a while, or when something else is done; nothing of it gets lost then
/// (Gesture::letGo). What would break something is taken back when its key is released, and what came before it
/// stays.
template <class Way>
class NudgeSeries {
public:
    using Move = std::function<Edit(const Design& start, const Way& way)>;

    NudgeSeries()
    {
        constexpr int longEnough = 900; // ms
        m_pause.setSingleShot(true);
        m_pause.setInterval(longEnough);
        QObject::connect(&m_pause, &QTimer::timeout, &m_pause, [this] { end(); });
    }

    bool keyIsDown() const { return m_gesture && m_gesture->active() && !m_gesture->isLetGo(); }

    /// `way` further; `move` makes an edit of the whole way.
    void step(Document& document, const Selection& selection, const Way& way, Move move)
    {
        const auto subject = std::pair(selection.elements(), selection.points());
        if (subject != m_subject)
            end();
        m_pause.stop();
        if (!m_gesture || !m_gesture->active()) {
            m_gesture = std::make_unique<Gesture>(document);
            m_way.setZero();
            m_good.setZero();
            m_subject = subject;
        }
        m_gesture->takeUp();
        m_move = std::move(move);
        m_way += way;
        m_gesture->update(m_move(m_gesture->start(), m_way));
    }

    /// The key was released.
    void release(Document& document)
    {
        if (!keyIsDown())
            return;
        if (const std::optional<edits::Breakage> broken = document.breakage()) {
            m_way = m_good;
            if (m_way.isZero())
                cancel();
            else
                m_gesture->update(m_move(m_gesture->start(), m_way));
            emit document.refused(broken->why);
        }
        if (!m_gesture)
            return;
        m_good = m_way;
        m_gesture->letGo();
        m_pause.start();
    }

    void end()
    {
        m_pause.stop();
        if (const std::unique_ptr<Gesture> nudged = std::move(m_gesture))
            nudged->commit();
    }

    void cancel()
    {
        m_pause.stop();
        if (m_gesture)
            m_gesture->cancel();
        m_gesture.reset();
    }

private:
    std::unique_ptr<Gesture> m_gesture;
    std::pair<Selection::Elements, Selection::Points> m_subject;
    Move m_move;
    Way m_way = Way::Zero();
    Way m_good = Way::Zero(); ///< when the last key was released
    QTimer m_pause;
};

} // namespace bolster
