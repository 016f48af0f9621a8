#include "ViewCommands.h"

#include "ApplyPreferences.h"
#include "Commands.h"
#include "CoverView.h"
#include "Document.h"
#include "ElementsView.h"
#include "Hiding.h"
#include "PatternView.h"
#include "PreferenceStore.h"
#include "Selection.h"
#include "StatusLine.h"

#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QSlider>
#include <QWidgetAction>

namespace bolster {

ViewCommands::ViewCommands(Commands& commands, Document& document, Selection& selection, PatternView& pattern,
                           CoverView& coverView, ElementsView& elements, StatusLine& status,
                           PreferenceStore& preferences)
    : m_document(document)
    , m_selection(selection)
    , m_pattern(pattern)
    , m_coverView(coverView)
    , m_elements(elements)
    , m_status(status)
    , m_preferences(preferences)
{
    addFitting(commands);
    addStandardViews(commands);
    addCamera(commands);
    addHiding(commands);
    addOpacities(commands);
    addThemes(commands);
    connect(&coverView.navigation(), &CoverNavigation::perspectiveChanged, commands["view.perspective"],
            &QAction::setChecked);
    connect(&coverView, &CoverView::sectionClosed, this,
            [&commands] { commands["view.section"]->setChecked(false); });
    connect(&coverView.visibility(), &SceneVisibility::hiddenChanged, this, [this, &commands] {
        m_elements.setHidden(m_coverView.visibility().hidden());
        m_pattern.shown().setHidden(m_coverView.visibility().hidden());
        commands.update({"view.show-hidden"});
    });
}

void ViewCommands::addFitting(Commands& commands)
{
    commands.add({{.id = "view.fit-all",
                   .formerly = "show-all",
                   .text = tr("Show &all"),
                   .icon = "fit-all",
                   .keys = {Qt::Key_Home},
                   .places = {"view/1"},
                   .bar = 402,
                   .does =
                       [this] {
                           m_pattern.navigation().fitAll();
                           m_coverView.navigation().fitAll();
                       }},
                  {.id = "view.fit-selection",
                   .formerly = "show-selection",
                   .text = tr("Show &selection"),
                   .icon = "fit-selection",
                   .keys = {Qt::Key_F},
                   .places = {"view/1"},
                   .bar = 403,
                   .does = [this] { fitSelection(); }}});
}

void ViewCommands::addStandardViews(Commands& commands)
{
    commands.add(MenuPlace{"view.from", tr("Look at the &cover from"), "view/1"});
    using View = CoverView::StandardView;
    const struct {
        View view;
        const char* id;
        const char* formerly;
        QString text;
        Qt::Key key;
    } views[] = {
        {View::Front, "view.from-front", "front", tr("&Front"), Qt::Key_1},
        {View::Back, "view.from-back", "back", tr("&Back"), Qt::Key_2},
        {View::Left, "view.from-left", "left", tr("&Left"), Qt::Key_3},
        {View::Right, "view.from-right", "right", tr("&Right"), Qt::Key_4},
        {View::Top, "view.from-top", "top", tr("&Top"), Qt::Key_5},
        {View::Bottom, "view.from-bottom", "bottom", tr("B&ottom"), Qt::Key_6},
        {View::ThreeQuarter, "view.from-three-quarter", "three-quarter", tr("Three-&quarter"), Qt::Key_0},
    };
    for (const auto& row : views)
        commands.add({.id = row.id,
                      .formerly = row.formerly,
                      .text = row.text,
                      .keys = {row.key},
                      .places = {"view.from/1"},
                      .does = [this, view = row.view] { m_coverView.navigation().setStandardView(view); }});
    commands.add(MenuPlace{"view.saved", tr("Sa&ved views"), "view/1"}); // filled by SavedViewCommands
}

void ViewCommands::addCamera(Commands& commands)
{
    commands.add({{.id = "view.perspective",
                   .formerly = "perspective",
                   .text = tr("&Perspective"),
                   .icon = "perspective",
                   .keys = {Qt::Key_P},
                   .places = {"view/1"},
                   .bar = 404,
                   .on = true,
                   .toggled = [this](bool on) { m_coverView.navigation().setPerspective(on); }},
                  {.id = "view.section",
                   .formerly = "section",
                   .text = tr("Sec&tion"),
                   .icon = "section",
                   .keys = {Qt::SHIFT | Qt::Key_X},
                   .places = {"view/1"},
                   .on = false,
                   .toggled = [this](bool on) { m_coverView.setSectionShown(on); }},
                  {.id = "view.link",
                   .formerly = "link-the-views",
                   .text = tr("Lin&k the views"),
                   .icon = "link-views",
                   .keys = {Qt::SHIFT | Qt::Key_L},
                   .tip = tr("Show the pointer's place in the other view, too"),
                   .places = {"view/1"},
                   .on = true,
                   .toggled = [this](bool) { // ViewLink looks whether it is on
                       m_pattern.showPlace({});
                       m_coverView.showPlace({});
                   }}});
}

void ViewCommands::addHiding(Commands& commands)
{
    commands.add(
        {{.id = "view.hide",
          .formerly = "hide-selected",
          .text = tr("&Hide selected"),
          .icon = "hide",
          .keys = {Qt::SHIFT | Qt::Key_H},
          .places = {"view/3"},
          .enabled = [this] { return !hideable(m_document.design(), m_selection.elements()).empty(); },
          .does = [this] { hideSelected(); }},
         {.id = "view.isolate",
          .formerly = "isolate-selected",
          .text = tr("&Isolate selected"),
          .icon = "isolate",
          .keys = {Qt::SHIFT | Qt::Key_I},
          .places = {"view/3"},
          .enabled = [this] { return !m_selection.elements().empty(); },
          .does =
              [this] { m_coverView.visibility().setHidden(allBut(m_document.design(), m_selection.elements())); }},
         {.id = "view.show-hidden",
          .formerly = "show-hidden-again",
          .text = tr("Sho&w hidden again"),
          .icon = "show-hidden",
          .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_H},
          .places = {"view/3"},
          .enabled = [this] { return !m_coverView.visibility().hidden().empty(); },
          .does = [this] { m_coverView.visibility().setHidden({}); }}});
}

void ViewCommands::addThemes(Commands& commands)
{
    commands.add(MenuPlace{"view.theme", tr("Th&eme"), "view/4"});
    const struct {
        Theme theme;
        const char* id;
        const char* formerly;
        QString text;
    } themes[] = {
        {Theme::System, "view.theme-system", "as-the-system", tr("As the &system")},
        {Theme::Light, "view.theme-light", "light", tr("&Light")},
        {Theme::Dark, "view.theme-dark", "dark", tr("&Dark")},
        {Theme::HighContrast, "view.theme-contrast", "", tr("&High contrast")},
    };
    for (const auto& row : themes)
        commands.add({.id = row.id,
                      .formerly = row.formerly,
                      .text = row.text,
                      .places = {"view.theme/1"},
                      .on = row.theme == themeOf(m_preferences.now()),
                      .group = "theme",
                      .checked = [this, theme = row.theme] { return themeOf(m_preferences.now()) == theme; },
                      .does =
                          [this, theme = row.theme] {
                              Preferences wanted = m_preferences.now();
                              wanted.theme = QString::number(static_cast<int>(theme));
                              m_preferences.set(wanted);
                          }});
    connect(&m_preferences, &PreferenceStore::changed, this, [&commands] {
        commands.update({"view.theme-system", "view.theme-light", "view.theme-dark", "view.theme-contrast"});
    });
}

void ViewCommands::addOpacities(Commands& commands)
{
    commands.add(MenuPlace{"view.opacity", tr("&Opacity"), "view/3"});
    QMenu* menu = commands.menu("view.opacity");
    auto* panel = new QWidget(menu);
    auto* grid = new QGridLayout(panel);
    const auto add = [&](int row, const QString& text, const QString& name, auto set) {
        auto* slider = new QSlider(Qt::Horizontal, panel);
        slider->setObjectName(name);
        slider->setRange(0, 100);
        slider->setValue(100);
        slider->setMinimumWidth(160);
        auto* figure = new QLabel(tr("%1 %").arg(100), panel);
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
    add(0, tr("Frames and foam"), QStringLiteral("frame-opacity"),
        [this](double opacity) { m_coverView.shown().setFrameOpacity(opacity); });
    add(1, tr("Scans"), QStringLiteral("scan-opacity"),
        [this](double opacity) { m_coverView.shown().setScanOpacity(opacity); });
    auto* action = new QWidgetAction(menu);
    action->setDefaultWidget(panel);
    action->setText(tr("Opacity of frames and scans"));
    action->setToolTip(action->text());
    menu->addAction(action);
}

void ViewCommands::hideSelected()
{
    std::set<ElementId> hidden = hideable(m_document.design(), m_selection.elements());
    if (hidden.empty()) {
        m_status.flash(tr("Select patches, curves, frames, foam or scans to hide them."));
        return;
    }
    hidden.insert(m_coverView.visibility().hidden().begin(), m_coverView.visibility().hidden().end());
    m_selection.clear();
    m_coverView.visibility().setHidden(std::move(hidden));
}

void ViewCommands::fitSelection()
{
    m_pattern.navigation().fitSelection();
    m_coverView.navigation().fitSelection();
}

} // namespace bolster
