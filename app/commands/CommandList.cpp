#include "CommandList.h"

#include <QMenu>
#include <QMenuBar>
#include <QSet>

#include <algorithm>

namespace bolster {

namespace {

QString plain(QString text)
{
    return text.remove(u'&').remove(QStringLiteral("\u2026")).trimmed();
}

void collect(const QList<QAction*>& actions, const QString& path, QSet<QAction*>& seen, QList<MenuEntry>& commands)
{
    for (QAction* action : actions) {
        if (action->isSeparator() || !action->isVisible() || seen.contains(action))
            continue;
        seen.insert(action);
        QMenu* menu = action->menu();
        if (!menu) {
            commands.append({action, plain(action->text()), path});
            continue;
        }
        emit menu->aboutToShow();
        const QString title = plain(action->text());
        collect(menu->actions(), path.isEmpty() ? title : QStringLiteral("%1 \u203a %2").arg(path, title), seen,
                commands);
    }
}

/// Whether the letters of `word` follow each other in `text`, with gaps.
bool follows(const QString& word, const QString& text)
{
    qsizetype at = 0;
    for (const QChar c : text)
        if (at < word.size() && word.at(at) == c)
            ++at;
    return at == word.size();
}

int wordScore(const QString& word, const QString& text)
{
    const qsizetype found = text.indexOf(word);
    if (found == 0)
        return 100;
    if (found > 0) {
        for (qsizetype at = found; at >= 0; at = text.indexOf(word, at + 1))
            if (!text.at(at - 1).isLetterOrNumber())
                return 80;
        return 50;
    }
    return word.size() > 1 && follows(word, text) ? 10 : 0;
}

} // namespace

QList<MenuEntry> commandsOf(const QMenuBar& bar)
{
    QList<MenuEntry> commands;
    QSet<QAction*> seen;
    collect(bar.actions(), {}, seen, commands);
    return commands;
}

int matchScore(const QString& query, const MenuEntry& command)
{
    const QString text = command.text.toCaseFolded();
    const QString path = command.path.toCaseFolded();
    int score = 1;
    for (const QString& word : query.toCaseFolded().split(u' ', Qt::SkipEmptyParts)) {
        const int inPath = path.contains(word) ? wordScore(word, path) / 4 : 0; // whole pieces only
        const int best = std::max(wordScore(word, text), inPath);
        if (best == 0)
            return 0;
        score += best;
    }
    return score;
}

} // namespace bolster
