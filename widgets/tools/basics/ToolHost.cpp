#include "ToolHost.h"

#include "Document.h"

#include <QKeyEvent>

#include <exception>

namespace bolster {

ToolHost::ToolHost(Document& document, QWidget& view)
    : m_document(document)
    , m_view(view)
{}

void ToolHost::announce()
{
    if (const QString text = prompt(); text != m_prompt) {
        m_prompt = text;
        emit promptChanged(text);
    }
    emit refreshed();
}

bool ToolHost::guard(const std::function<bool()>& handle)
{
    try {
        return handle();
    } catch (const std::exception& error) {
        m_document.cancelGesture();
        restart();
        emit failed(tr("This could not be done, and nothing was changed: %1").arg(QString::fromUtf8(error.what())));
        refresh();
        return true;
    }
}

bool ToolHost::takeBack()
{
    for (const ToolKey& key : current().keys())
        if (key.key == Qt::Key_Backspace) {
            const QKeyEvent press(QEvent::KeyPress, Qt::Key_Backspace, Qt::NoModifier);
            return guard([&] { return current().keyPress(press); });
        }
    return false;
}

void ToolHost::askForMenu(const QPoint& global, bool onSomething)
{
    if (const ToolKeys keys = current().keys(); !keys.empty())
        emit toolMenuWanted(global, keys);
    else
        emit contextMenuWanted(global, onSomething);
}

} // namespace bolster
