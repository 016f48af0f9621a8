// Everything that the menus offer, and how well it fits what somebody types.
#pragma once

#include <QAction>
#include <QList>
#include <QPointer>
#include <QString>

class QMenuBar;

namespace bolster {

struct MenuEntry {
    QPointer<QAction> action;
    QString text; ///< without mnemonic and dots
    QString path; ///< "View > Look at the cover from", with a proper arrow
};

/// The actions of all menus and submenus in their order, each once; menus that are filled when they open are filled
/// first. Nothing has to be registered.
QList<MenuEntry> commandsOf(const QMenuBar& bar);

/// How well the words of `query` are found in a command, at any place and in any order: 0 not at all; the beginning
/// of a word counts more than its middle, that more than letters that follow each other, the text more than its
/// menu.
int matchScore(const QString& query, const MenuEntry& command);

} // namespace bolster
