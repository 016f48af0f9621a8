// Help > Report a problem: what happened, what goes into the report, and where it is written.
#pragma once

#include "Design.h"
#include "ProblemReport.h"

#include <QDialog>

#include <memory>

class QCheckBox;
class QLabel;
class QOffscreenSurface;
class QPlainTextEdit;
class QPushButton;

namespace bolster {

class ReportDialog : public QDialog {
    Q_OBJECT

public:
    ReportDialog(const Design& design, const QString& title, QWidget* parent);
    ~ReportDialog() override;

    /// Writes it in the background; `written` says how it ended.
    void writeTo(const QString& path);

signals:
    /// `problem` is "" when the report is there.
    void written(const QString& path, const QString& problem);

private:
    void build(const QString& title);
    void askForOpenGl();
    void showContents();
    void choosePath();
    ProblemReport report() const;

    Design m_design;
    QString m_openGl;
    std::shared_ptr<QOffscreenSurface> m_surface; ///< goes on the thread that made it, whoever lets go of it last
    QPlainTextEdit* m_happened = nullptr;
    QCheckBox* m_withDesign = nullptr;
    QPlainTextEdit* m_contents = nullptr;
    QLabel* m_said = nullptr;
    QPushButton* m_write = nullptr;
};

} // namespace bolster
