// What the window does for drawing: snapping, rulers, guides, and a picture to trace.
#include "MainWindow.h"

#include "Actions.h"
#include "Ask.h"
#include "PatternView.h"
#include "StatusLine.h"

#include <QFileInfo>
#include <QSettings>

namespace bolster {

namespace {

const QString pictureFolderKey = QStringLiteral("drawing/pictureFolder");

} // namespace

void MainWindow::connectDrawing()
{
    // Each toggle is as it was left, in every window.
    const auto keep = [this](QAction* toggle, const QString& name, auto apply) {
        const QString key = QStringLiteral("drawing/") + name;
        toggle->setChecked(QSettings().value(key, toggle->isChecked()).toBool());
        apply(toggle->isChecked());
        connect(toggle, &QAction::toggled, this, [key, apply](bool on) {
            QSettings().setValue(key, on);
            apply(on);
        });
    };
    keep(m_actions->snapping, QStringLiteral("snapping"), [this](bool on) { m_pattern->aids().setSnapping(on); });
    keep(m_actions->showRulers, QStringLiteral("rulers"), [this](bool on) { m_pattern->setRulersShown(on); });
    keep(m_actions->showGuides, QStringLiteral("guides"),
         [this](bool on) { m_pattern->aids().setGuidesShown(on); });
    keep(m_actions->lasso, QStringLiteral("lasso"), [this](bool on) { m_pattern->aids().setLasso(on); });
    connect(m_actions->removeGuides, &QAction::triggered, this, [this] { m_pattern->aids().setGuides({}); });
    connectBackground();
}

void MainWindow::connectBackground()
{
    const auto change = [this](auto what) {
        BackgroundPicture picture = m_pattern->aids().background();
        what(picture);
        m_pattern->aids().setBackground(picture);
    };
    const auto enable = [this] {
        const bool any = !m_pattern->aids().background().empty();
        for (QAction* action : {m_actions->showBackground, m_actions->scaleBackground, m_actions->moveBackground,
                                m_actions->removeBackground})
            action->setEnabled(any);
        for (QAction* action : m_actions->backgroundOpacities)
            action->setEnabled(any);
    };
    enable();
    connect(m_actions->background, &QAction::triggered, this, [this, enable] {
        askForFile(this, tr("Open a picture to trace"), QSettings().value(pictureFolderKey).toString(),
                   tr("Pictures (*.png *.jpg *.jpeg *.bmp *.webp);;All files (*)"),
                   [this, enable](const QString& path) {
                       traceBackground(path);
                       enable();
                   });
    });
    connect(m_actions->showBackground, &QAction::toggled, this,
            [change](bool on) { change([on](BackgroundPicture& picture) { picture.shown = on; }); });
    for (QAction* action : m_actions->backgroundOpacities)
        connect(action, &QAction::triggered, this, [change, opacity = action->data().toDouble()] {
            change([opacity](BackgroundPicture& picture) { picture.opacity = opacity; });
        });
    connect(m_actions->scaleBackground, &QAction::triggered, this,
            [this] { m_pattern->setTool(PatternToolKind::BackgroundScale); });
    connect(m_actions->moveBackground, &QAction::triggered, this,
            [this] { m_pattern->setTool(PatternToolKind::BackgroundMove); });
    connect(m_actions->removeBackground, &QAction::triggered, this, [this, enable] {
        BackgroundPicture none;
        none.opacity = m_pattern->aids().background().opacity; // of the next one
        m_pattern->aids().setBackground(none);
        enable();
    });
}

void MainWindow::traceBackground(const QString& path)
{
    QString problem;
    BackgroundPicture picture =
        readBackground(path, m_pattern->navigation().transform().visible(m_pattern->size()), &problem);
    if (picture.empty()) {
        m_status->flash(problem);
        return;
    }
    QSettings().setValue(pictureFolderKey, QFileInfo(path).path());
    picture.opacity = m_pattern->aids().background().opacity;
    m_actions->showBackground->setChecked(true);
    m_pattern->aids().setBackground(picture);
    m_pattern->setTool(PatternToolKind::BackgroundScale); // its size is a guess
}

} // namespace bolster
