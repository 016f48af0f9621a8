// The manual, beside the work.
#pragma once

#include <QDialog>
#include <QStringList>

class QLineEdit;
class QTextBrowser;
class QToolButton;

namespace bolster {

class ManualWindow : public QDialog {
    Q_OBJECT

public:
    /// `folder`: its pages, Markdown.
    explicit ManualWindow(QString folder, QWidget* parent = nullptr);

    /// Where it covers this place of the screen least.
    void standBeside(const QPoint& place);
    /// "page.md#heading"; the page from its beginning when it has no such heading.
    void openAt(const QString& place);
    /// The page that is shown, and the heading that was asked for.
    QString place() const { return m_shown < 0 ? QString() : m_places[m_shown]; }

private:
    void show(const QString& place);
    void follow(const QUrl& link);
    void go(int steps);
    void find();
    void scrollTo(const QString& anchor);

    QString m_folder;
    QStringList m_places; ///< that were shown, one after the other
    int m_shown = -1;     ///< in them
    QTextBrowser* m_text;
    QToolButton *m_back, *m_forward;
    QLineEdit* m_find;
};

} // namespace bolster
