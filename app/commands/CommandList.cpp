#include "CommandList.h"

#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>

namespace bolster {

namespace {

/// Without what is there for menus: keys, dots, the number of a file that was open lately.
QString plain(const QString& text)
{
    static const QRegularExpression numbered(QStringLiteral("^&\\d+ "));
    QString said = text.section(u'\t', 0, 0).remove(numbered);
    return said.remove(u'&').remove(QStringLiteral("\u2026")).trimmed();
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

/// Whether the letters of `word` follow each other in `text`, with gaps; of each word of the text that is used, the
/// first letter is: "exsrf" means "export surface", but "mirror" is not scattered over a path.
bool follows(QStringView word, QStringView text)
{
    if (word.isEmpty())
        return true;
    for (qsizetype start = 0; start < text.size(); ++start) {
        if (text[start] != word.front() || (start > 0 && text[start - 1].isLetterOrNumber()))
            continue;
        qsizetype used = 0;
        for (qsizetype at = start; at < text.size() && text[at].isLetterOrNumber() && used < word.size(); ++at)
            if (text[at] == word[used])
                if (follows(word.mid(++used), text.mid(at + 1)))
                    return true;
    }
    return false;
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
