// What stands in place of the views while nothing is open: ways to begin, and to go on.
#pragma once

#include "WorkJournal.h"

#include <QMultiHash>
#include <QScrollArea>

class QHBoxLayout;
class QLabel;
class QMainWindow;
class QPushButton;
class QVBoxLayout;

namespace bolster {

class CardFlow;
struct Sample;
class StartCard;
class StartPictures;

/// Lies over pattern and cover, wherever they stand in the window. Who uses it says when it comes and goes.
class StartPage : public QScrollArea {
    Q_OBJECT

public:
    /// `over`: what it lies over, as long as that is part of the window.
    StartPage(QMainWindow& window, const QList<QWidget*>& over);

    /// `back`: there is a design to go back to.
    void open(bool back);
    void close();
    bool isOpen() const { return m_open; }
    /// Of this window's own work nothing is in it.
    void setLeft(const QList<WorkJournal::Left>& all);
    void setTemplates(const QString& folder) { m_templates = folder; }

signals:
    /// It came or went.
    void toggled(bool open);
    void frameWanted();
    void patternWanted();
    void scanWanted();
    void rectangleWanted();
    void openWanted();
    void fileWanted(const QString& path);
    void templateWanted(const QString& path);
    void leftWanted(const bolster::WorkJournal::Left& left);
    void tourWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fill();
    void addHead(QVBoxLayout& page);
    void addBeginnings(QVBoxLayout& page);
    void addRecent(QVBoxLayout& page);
    void addLeft(QVBoxLayout& page);
    void addTemplates(QVBoxLayout& page);
    void addSamples(QVBoxLayout& page);
    /// A heading with what else there is to do at its right.
    QHBoxLayout* addHeading(QVBoxLayout& page, const QString& text);
    CardFlow* addCards(QVBoxLayout& page);
    QPushButton* newLink(const QString& text, const QString& name);
    StartCard* newPictureCard(const QString& path, const QString& title, const QString& words);
    void showPicture(const QString& design, bool there, const QImage& picture);
    void forget(const QString& path);
    void place();
    void focusFirst();
    void paintLikeTheViews();

    QMainWindow& m_window;
    QList<QWidget*> m_over;
    StartPictures* m_pictures;
    QString m_templates;
    QList<WorkJournal::Left> m_left;
    QMultiHash<QString, StartCard*> m_cards; ///< that wait for their pictures
    QStringList m_wanted;
    bool m_open = false;
    bool m_back = false;
    bool m_placing = false;
};

} // namespace bolster
