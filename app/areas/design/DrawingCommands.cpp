#include "DrawingCommands.h"

#include "Ask.h"
#include "Commands.h"
#include "PatternView.h"
#include "StatusLine.h"
#include "Units.h"

#include <QFileInfo>
#include <QSettings>

namespace bolster {

namespace {

const QString pictureFolderKey = QStringLiteral("drawing/pictureFolder");

/// As it was left, in every window.
Command kept(const char* key, Command toggle)
{
    const QString name = QStringLiteral("drawing/") + QString::fromLatin1(key);
    const bool on = QSettings().value(name, toggle.on.value_or(false)).toBool();
    toggle.on = on;
    const auto apply = toggle.toggled;
    apply(on);
    toggle.toggled = [name, apply](bool now) {
        QSettings().setValue(name, now);
        apply(now);
    };
    return toggle;
}

} // namespace

DrawingCommands::DrawingCommands(Commands& commands, PatternView& pattern, StatusLine& status, QWidget& window)
    : m_commands(commands)
    , m_pattern(pattern)
    , m_status(status)
    , m_window(window)
{
    addHelps();
    addPicture();
    addOpacities();
    connect(&pattern.aids(), &DrawingAids::changed, this, [&commands] { commands.update({"draw.remove-guides"}); });
}

void DrawingCommands::addHelps()
{
    m_commands.add(MenuPlace{"view.grid", tr("&Grid and snapping"), "view/2"});
    m_commands.add({kept("snapping", {.id = "draw.snapping",
                                      .formerly = "snapping",
                                      .text = tr("S&napping"),
                                      .icon = "snapping",
                                      .keys = {Qt::SHIFT | Qt::Key_S},
                                      .places = {"view.grid/1"},
                                      .bar = 510,
                                      .on = true,
                                      .toggled = [this](bool on) { m_pattern.aids().setSnapping(on); }}),
                    kept("rulers", {.id = "draw.rulers",
                                    .formerly = "rulers",
                                    .text = tr("&Rulers"),
                                    .icon = "rulers",
                                    .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_R},
                                    .places = {"view.grid/1"},
                                    .on = true,
                                    .toggled = [this](bool on) { m_pattern.setRulersShown(on); }}),
                    kept("guides", {.id = "draw.guides",
                                    .formerly = "guides",
                                    .text = tr("Gui&des"),
                                    .keys = {Qt::SHIFT | Qt::Key_G},
                                    .places = {"view.grid/1"},
                                    .on = true,
                                    .toggled = [this](bool on) { m_pattern.aids().setGuidesShown(on); }}),
                    {.id = "draw.remove-guides",
                     .formerly = "remove-all-guides",
                     .text = tr("Remove all g&uides"),
                     .places = {"view.grid/1"},
                     .enabled = [this] { return m_pattern.aids().guides() != PatternGuides(); },
                     .does = [this] { m_pattern.aids().setGuides({}); }},
                    kept("lasso", {.id = "draw.lasso",
                                   .formerly = "select-with-a-loop",
                                   .text = tr("Select with a &loop"),
                                   .icon = "lasso",
                                   .keys = {Qt::SHIFT | Qt::Key_Q},
                                   .places = {"edit/4"},
                                   .on = false,
                                   .toggled = [this](bool on) { m_pattern.aids().setLasso(on); }})});
}

void DrawingCommands::addPicture()
{
    m_commands.add(MenuPlace{"pattern.background", tr("&Background picture"), "pattern/3"});
    const auto any = [this] { return !m_pattern.aids().background().empty(); };
    m_commands.add({{.id = "background.open",
                     .formerly = "open-picture",
                     .text = tr("&Open picture \u2026"),
                     .icon = "picture",
                     .places = {"pattern.background/1"},
                     .does = [this] { openPicture(); }},
                    {.id = "background.show",
                     .formerly = "show",
                     .text = tr("Sho&w"),
                     .keys = {Qt::SHIFT | Qt::Key_B},
                     .places = {"pattern.background/1"},
                     .on = true,
                     .enabled = any,
                     .toggled = [this](bool on) { showPicture(on); }},
                    {.id = "background.scale",
                     .formerly = "scale-by-two-points",
                     .text = tr("&Scale by two points"),
                     .places = {"pattern.background/1"},
                     .enabled = any,
                     .does = [this] { m_pattern.setTool(PatternToolKind::BackgroundScale); }},
                    {.id = "background.move",
                     .formerly = "move",
                     .text = tr("&Move"),
                     .places = {"pattern.background/1"},
                     .enabled = any,
                     .does = [this] { m_pattern.setTool(PatternToolKind::BackgroundMove); }},
                    {.id = "background.remove",
                     .formerly = "remove",
                     .text = tr("&Remove"),
                     .places = {"pattern.background/3"},
                     .enabled = any,
                     .does = [this] { removePicture(); }}});
}

void DrawingCommands::addOpacities()
{
    const struct {
        double opacity;
        const char* id;
        const char* formerly;
    } opacities[] = {{1.0, "background.opacity-100", "opacity-100"},
                     {0.6, "background.opacity-60", "opacity-60"},
                     {0.3, "background.opacity-30", "opacity-30"}};
    for (const auto& row : opacities)
        m_commands.add({.id = row.id,
                        .formerly = row.formerly,
                        .text = tr("Opacity %1").arg(percentText(row.opacity)),
                        .places = {"pattern.background/2"},
                        .on = row.opacity == 0.6,
                        .group = "background.opacity",
                        .enabled = [this] { return !m_pattern.aids().background().empty(); },
                        .does =
                            [this, opacity = row.opacity] {
                                BackgroundPicture picture = m_pattern.aids().background();
                                picture.opacity = opacity;
                                m_pattern.aids().setBackground(picture);
                            }});
}

void DrawingCommands::openPicture()
{
    askForFile(&m_window, tr("Open a picture to trace"), QSettings().value(pictureFolderKey).toString(),
               tr("Pictures (*.png *.jpg *.jpeg *.bmp *.webp);;All files (*)"), [this](const QString& path) {
                   trace(path);
                   m_commands.update();
               });
}

void DrawingCommands::trace(const QString& path)
{
    QString problem;
    BackgroundPicture picture =
        readBackground(path, m_pattern.navigation().transform().visible(m_pattern.size()), &problem);
    if (picture.empty()) {
        m_status.flash(problem);
        return;
    }
    QSettings().setValue(pictureFolderKey, QFileInfo(path).path());
    picture.opacity = m_pattern.aids().background().opacity;
    m_commands["background.show"]->setChecked(true);
    m_pattern.aids().setBackground(picture);
    m_pattern.setTool(PatternToolKind::BackgroundScale); // its size is a guess
}

void DrawingCommands::showPicture(bool shown)
{
    BackgroundPicture picture = m_pattern.aids().background();
    picture.shown = shown;
    m_pattern.aids().setBackground(picture);
}

void DrawingCommands::removePicture()
{
    BackgroundPicture none;
    none.opacity = m_pattern.aids().background().opacity; // of the next one
    m_pattern.aids().setBackground(none);
    m_commands.update();
}

} // namespace bolster
