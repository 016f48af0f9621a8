// F1: the page of the manual for what one is at.
#pragma once

#include "ManualPlaces.h"

#include <QCoreApplication>
#include <QObject>
#include <QPointer>

#include <functional>

namespace bolster {

class Commands;
class ManualWindow;

class ManualCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(ManualCommands)

public:
    /// `subject`: the class of the form that is shown in the properties, "" for none.
    ManualCommands(Commands& commands, QWidget& window, std::function<QString()> subject);

    /// Where the keyboard is: a problem, the tool of a view, a form, a window.
    QString placeNow() const;
    /// What a message means, by its key.
    void openMessage(const QString& key);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    static bool isOfPatternAlone(const QString& tool);
    QString placeOfMenu() const;
    void open(const QString& place);

    Commands& m_commands;
    QWidget& m_window;
    std::function<QString()> m_subject;
    QString m_folder;
    ManualPlaces m_places;
    QPointer<ManualWindow> m_manual;
};

} // namespace bolster
