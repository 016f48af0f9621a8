#include "FormChoice.h"

#include "DesignSession.h"
#include "FileFormats.h"

#include <QFileInfo>

namespace bolster {

FormChoice::FormChoice(DesignSession& session, const QString& fileTitle, const QString& none, QWidget* parent)
    : FileChoice(session, fileTitle,
                 tr("Meshes and scans (%1);;All files (*)")
                     .arg(patternsOf(FileUse::Frame) + ' ' + patternsOf(FileUse::Scan)),
                 parent)
{
    fill(none);
}

void FormChoice::fill(const QString& none)
{
    if (!none.isEmpty())
        addItem(none);
    session().document().design().each<Scan>([&](ElementId id, const Scan& scan) {
        addItem(QString::fromStdString(scan.name), number(id));
        ++m_scans;
    });
    addFiles();
}

FormChoice::Chosen FormChoice::chosen() const
{
    return {static_cast<ElementId>(currentData().toUInt()), file()};
}

void FormChoice::choose(const Chosen& chosen)
{
    if (QFileInfo::exists(chosen.file))
        chooseFile(chosen.file);
    else if (const int row = chosen.scan == noElement ? -1 : findData(number(chosen.scan)); row >= 0)
        chooseRow(row);
}

FitForm FormChoice::form() const
{
    FitForm form;
    form.file = file();
    if (!form.file.isEmpty())
        return form;
    const auto id = static_cast<ElementId>(currentData().toUInt());
    const auto* scan = session().document().committed().find<Scan>(id);
    const auto cloud = session().files().clouds.find(id);
    if (scan && cloud != session().files().clouds.end()) {
        form.scan = *scan;
        form.cloud = cloud->second;
    }
    return form;
}

} // namespace bolster
