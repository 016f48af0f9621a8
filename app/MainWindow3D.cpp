// What the window does with the 3D view: links it to the pattern, hides, cuts open, keeps views.
#include "MainWindow.h"

#include "Actions.h"
#include "ElementsView.h"
#include "Hiding.h"
#include "PatternView.h"
#include "SavedViews.h"
#include "StatusLine.h"

#include <QGridLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QSlider>
#include <QWidgetAction>

namespace bolster {

void MainWindow::connect3D()
{
    const auto on = [this](QAction* action, auto function) {
        connect(action, &QAction::triggered, this, function);
    };
    on(m_actions->hideSelected, [this] {
        std::set<ElementId> hidden = hideable(document().design(), m_selection.elements());
        if (hidden.empty()) {
            m_status->flash(tr("Select patches, curves, frames, foam or scans to hide them."));
            return;
        }
        hidden.insert(m_surface->visibility().hidden().begin(), m_surface->visibility().hidden().end());
        m_selection.clear();
        m_surface->visibility().setHidden(std::move(hidden));
    });
    on(m_actions->isolate,
       [this] { m_surface->visibility().setHidden(allBut(document().design(), m_selection.elements())); });
    on(m_actions->showHidden, [this] { m_surface->visibility().setHidden({}); });
    on(m_actions->saveView, [this] { saveView(); });
    connect(m_actions->section, &QAction::toggled, m_surface, &SurfaceView::setSectionShown);
    connect(m_surface, &SurfaceView::sectionClosed, m_actions->section,
            [this] { m_actions->section->setChecked(false); });
    connect(&m_surface->visibility(), &SurfaceVisibility::hiddenChanged, this, &MainWindow::update3DActions);
    connect(&m_surface->visibility(), &SurfaceVisibility::hiddenChanged, this, [this] {
        m_elements->setHidden(m_surface->visibility().hidden());
        m_pattern->shown().setHidden(m_surface->visibility().hidden());
    });
    connect(&m_selection, &Selection::changed, this, &MainWindow::update3DActions);
    connect(m_session.get(), &DesignSession::opened, this, [this] { m_surface->visibility().setHidden({}); });
    if (auto* saved = menuBar()->findChild<QMenu*>(QStringLiteral("saved-views")))
        connect(saved, &QMenu::aboutToShow, this, [this, saved] { fillSavedViews(*saved); });
    addOpacitySliders();
    linkSelections();
    linkViews();
    update3DActions();
}

void MainWindow::update3DActions()
{
    const bool any = !hideable(document().design(), m_selection.elements()).empty();
    m_actions->hideSelected->setEnabled(any);
    m_actions->isolate->setEnabled(!m_selection.elements().empty());
    m_actions->showHidden->setEnabled(!m_surface->visibility().hidden().empty());
}

void MainWindow::linkSelections()
{
    const auto follow = [this](Selection& from, Selection& to) {
        connect(&from, &Selection::changed, this,
                [&from, &to] { to.set(from.elements(), from.points(), from.edges()); });
        connect(&from, &Selection::hoverChanged, this, [this, &from, &to] {
            if (m_actions->linkViews->isChecked())
                to.hover(from.hovered());
        });
    };
    follow(m_selection, m_surfaceSelection);
    follow(m_surfaceSelection, m_selection);
}

void MainWindow::linkViews()
{
    const auto linked = [this] { return m_actions->linkViews->isChecked(); };
    connect(m_surface, &SurfaceView::coverPointed, this, [this, linked](const std::optional<CoverPoint>& point) {
        m_pattern->showPlace(linked() ? point : std::nullopt);
    });
    connect(m_pattern, &PatternView::patchPointed, this, [this, linked](const std::optional<CoverPoint>& point) {
        m_surface->showPlace(linked() ? point : std::nullopt);
    });
    connect(m_surface, &SurfaceView::coverClicked, this, [this, linked](const CoverPoint& point) {
        if (linked())
            m_pattern->reveal(point);
    });
    connect(m_pattern, &PatternView::patchClicked, this, [this, linked](const CoverPoint& point) {
        if (linked())
            m_surface->reveal(point);
    });
    connect(m_actions->linkViews, &QAction::toggled, this, [this] {
        m_pattern->showPlace({});
        m_surface->showPlace({});
    });
}

void MainWindow::addOpacitySliders()
{
    auto* menu = menuBar()->findChild<QMenu*>(QStringLiteral("opacity"));
    if (!menu)
        return;
    auto* panel = new QWidget(menu);
    auto* grid = new QGridLayout(panel);
    const auto add = [&](int row, const QString& text, const QString& name, int value, auto set) {
        auto* slider = new QSlider(Qt::Horizontal, panel);
        slider->setObjectName(name);
        slider->setRange(0, 100);
        slider->setValue(value);
        slider->setMinimumWidth(160);
        auto* figure = new QLabel(tr("%1 %").arg(value), panel);
        figure->setMinimumWidth(figure->fontMetrics().horizontalAdvance(tr("%1 %").arg(888)));
        figure->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        connect(slider, &QSlider::valueChanged, this, [figure, set](int now) {
            figure->setText(tr("%1 %").arg(now));
            set(now / 100.0);
        });
        grid->addWidget(new QLabel(text, panel), row, 0);
        grid->addWidget(slider, row, 1);
        grid->addWidget(figure, row, 2);
    };
    add(0, tr("Frames and foam"), QStringLiteral("frame-opacity"), 100,
        [this](double opacity) { m_surface->shown().setFrameOpacity(opacity); });
    add(1, tr("Scans"), QStringLiteral("scan-opacity"), 100,
        [this](double opacity) { m_surface->shown().setScanOpacity(opacity); });
    auto* action = new QWidgetAction(menu);
    action->setDefaultWidget(panel);
    action->setText(tr("Opacity of frames and scans"));
    action->setToolTip(action->text());
    menu->addAction(action);
}

void MainWindow::fillSavedViews(QMenu& menu)
{
    menu.clear();
    const QStringList names = SavedViews::names();
    for (const QString& name : names)
        menu.addAction(QString(name).replace(u'&', QStringLiteral("&&")), this, [this, name] {
            if (const std::optional<Viewpoint> view = SavedViews::find(name))
                m_surface->navigation().flyTo(Camera{*view, {1, 1}});
        });
    menu.addSeparator();
    menu.addAction(m_actions->saveView);
    QMenu* remove = menu.addMenu(tr("&Delete view"));
    remove->setEnabled(!names.isEmpty());
    for (const QString& name : names)
        remove->addAction(QString(name).replace(u'&', QStringLiteral("&&")), this, [this, name] {
            SavedViews::remove(name);
            m_status->flash(tr("View %1 deleted").arg(name));
        });
}

void MainWindow::saveView()
{
    auto* dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save view"));
    dialog->setLabelText(tr("Name of the view; one of the same name is replaced:"));
    dialog->setTextValue(tr("View %1").arg(SavedViews::names().size() + 1));
    connect(dialog, &QInputDialog::textValueSelected, this,
            [this, camera = m_surface->navigation().camera()](const QString& text) {
                if (text.trimmed().isEmpty())
                    return;
                SavedViews::save(text.trimmed(), camera);
                m_status->flash(tr("View %1 saved: View > Saved views").arg(text.trimmed()));
            });
    dialog->open();
}

} // namespace bolster
