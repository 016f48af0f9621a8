// The list of what the program works at: names, how far they are, and a way to stop each.
#pragma once

#include <QHash>
#include <QWidget>

class QLabel;
class QProgressBar;
class QVBoxLayout;

namespace bolster {

class JobsPanel : public QWidget {
    Q_OBJECT

public:
    explicit JobsPanel(QWidget* parent = nullptr);

private:
    void fill();
    void addJob(int number, const QString& name);
    void showProgress(int number, double share);

    struct Row {
        QWidget* widget;
        QProgressBar* bar;
    };
    QHash<int, Row> m_rows;
    QLabel* m_nothing;
    QVBoxLayout* m_list;
};

} // namespace bolster
