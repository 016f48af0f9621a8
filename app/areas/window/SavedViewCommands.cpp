#include "SavedViewCommands.h"

#include "Commands.h"
#include "CoverView.h"
#include "SavedViews.h"
#include "StatusLine.h"

#include <QInputDialog>
#include <QMenu>

namespace bolster {

SavedViewCommands::SavedViewCommands(Commands& commands, CoverView& coverView, StatusLine& status, QWidget& window)
    : m_coverView(coverView)
    , m_status(status)
    , m_window(window)
{
    commands.add({.id = "view.save",
                  .formerly = "save-view",
                  .text = tr("&Save view \u2026"), // stands in the menu between the views and how to delete them
                  .does = [this] { save(); }});
    QMenu* menu = commands.menu("view.saved");
    connect(menu, &QMenu::aboutToShow, this, [this, menu, save = commands["view.save"]] { fill(*menu, save); });
}

void SavedViewCommands::fill(QMenu& menu, QAction* save)
{
    menu.clear();
    const QStringList names = SavedViews::names();
    for (const QString& name : names)
        menu.addAction(QString(name).replace(u'&', QStringLiteral("&&")), this, [this, name] {
            if (const std::optional<Viewpoint> view = SavedViews::find(name))
                m_coverView.navigation().flyTo(Camera{*view, {1, 1}});
        });
    menu.addSeparator();
    menu.addAction(save);
    QMenu* remove = menu.addMenu(tr("&Delete view"));
    remove->setEnabled(!names.isEmpty());
    for (const QString& name : names)
        remove->addAction(QString(name).replace(u'&', QStringLiteral("&&")), this, [this, name] {
            SavedViews::remove(name);
            m_status.flash(tr("View %1 deleted").arg(name));
        });
}

void SavedViewCommands::save()
{
    auto* dialog = new QInputDialog(&m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save view"));
    dialog->setLabelText(tr("Name of the view; one of the same name is replaced:"));
    dialog->setTextValue(tr("View %1").arg(SavedViews::names().size() + 1));
    connect(dialog, &QInputDialog::textValueSelected, this,
            [this, camera = m_coverView.navigation().camera()](const QString& text) {
                if (text.trimmed().isEmpty())
                    return;
                SavedViews::save(text.trimmed(), camera);
                m_status.flash(tr("View %1 saved: View > Saved views").arg(text.trimmed()));
            });
    dialog->open();
}

} // namespace bolster
