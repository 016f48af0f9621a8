#include "Gesture.h"

#include "Document.h"
#include "FollowEdits.h"

#include <utility>

namespace bolster {

Gesture::Gesture(Document& document, Purpose purpose)
    : m_document(&document)
    , m_purpose(purpose)
{
    document.cancelGesture();
    document.m_gesture = this;
    m_start = document.design();
}

Gesture::~Gesture()
{
    if (m_letGo)
        commit();
    else
        cancel();
}

void Gesture::update(Edit edit)
{
    if (!m_document)
        return;
    m_edit = edits::withFollowers(m_start, std::move(edit));
    Design provisional = m_start.with(m_edit);
    m_document->m_breakage = edits::brokenBy(m_start, m_edit);
    m_document->show(std::move(provisional));
}

void Gesture::commit()
{
    if (!m_document)
        return;
    m_letGo = false;
    // Detached first: the document goes from the provisional design straight to the committed design, without a way
    // back.
    Document& document = *std::exchange(m_document, nullptr);
    if (const std::optional<edits::Breakage> broken = document.m_breakage) {
        document.cancelGesture();
        emit document.refused(broken->why);
        return;
    }
    document.m_gesture = nullptr;
    document.commit(std::move(m_edit));
    emit document.gestureEnded();
}

void Gesture::cancel()
{
    m_letGo = false;
    if (m_document)
        m_document->cancelGesture();
}

} // namespace bolster
