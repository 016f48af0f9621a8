// F1: the page of the manual for what one is at.
#pragma once

#include "ManualPlaces.h"

#include <QCoreApplication>
#include <QObject>
#include <QPointer>

namespace bolster {

class Commands;
class ManualWindow;

class ManualCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(ManualCommands)

public:
    ManualCommands(Commands& commands, QWidget& window);

    /// Where the keyboard is: a problem, the tool of a view, a form, a window.
    QString placeNow() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void open(const QString& place);

    Commands& m_commands;
    QWidget& m_window;
    QString m_folder;
    ManualPlaces m_places;
    QPointer<ManualWindow> m_manual;
};

} // namespace bolster
