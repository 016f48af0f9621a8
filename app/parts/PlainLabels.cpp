#include "PlainLabels.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>

namespace bolster {

namespace {

/// A label is polished before it lays out a text for the first time; that of the tool tips before it has one.
class PlainLabels : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::Polish)
            if (auto* label = qobject_cast<QLabel*>(watched); label && label->textFormat() == Qt::AutoText)
                label->setTextFormat(Qt::PlainText);
        return QObject::eventFilter(watched, event);
    }
};

} // namespace

void keepLabelsPlain(QCoreApplication& application)
{
    static const QString name = QStringLiteral("plain-labels");
    if (application.findChild<QObject*>(name, Qt::FindDirectChildrenOnly))
        return;
    auto* guard = new PlainLabels(&application);
    guard->setObjectName(name);
    application.installEventFilter(guard);
}

} // namespace bolster
