#include "FormChoice.h"

#include "Ask.h"
#include "DesignSession.h"
#include "FileFormats.h"

#include <QFileInfo>

namespace bolster {

namespace {

const QString fileData = QStringLiteral("file");

} // namespace

FormChoice::FormChoice(DesignSession& session, QString fileTitle, const QString& none, QWidget* parent)
    : QComboBox(parent)
    , m_session(session)
    , m_fileTitle(std::move(fileTitle))
{
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(16);
    fill(none);
    connect(this, &QComboBox::activated, this, [this] {
        if (fileIsChosen())
            chooseFile();
    });
}

void FormChoice::fill(const QString& none)
{
    if (!none.isEmpty())
        addItem(none);
    m_session.document().design().each<Scan>([&](ElementId id, const Scan& scan) {
        addItem(QString::fromStdString(scan.name), number(id));
        ++m_scans;
    });
    addItem(tr("A file \u2026"), fileData);
}

bool FormChoice::fileIsChosen() const
{
    return currentData().toString() == fileData;
}

bool FormChoice::asksForFile()
{
    const bool asks = fileIsChosen() && m_file.isEmpty();
    if (asks)
        chooseFile();
    return asks;
}

void FormChoice::chooseFile()
{
    askForFile(this, m_fileTitle, usualFolder(m_session.path()),
               tr("Meshes and scans (%1);;All files (*)")
                   .arg(patternsOf(FileUse::Frame) + ' ' + patternsOf(FileUse::Scan)),
               [this](const QString& file) {
                   m_file = file;
                   setItemText(count() - 1, QFileInfo(file).fileName());
                   emit fileChosen();
               });
}

FitForm FormChoice::form() const
{
    FitForm form;
    if (fileIsChosen()) {
        form.file = m_file;
        return form;
    }
    const auto id = static_cast<ElementId>(currentData().toUInt());
    const auto* scan = m_session.document().committed().find<Scan>(id);
    const auto cloud = m_session.files().clouds.find(id);
    if (scan && cloud != m_session.files().clouds.end()) {
        form.scan = *scan;
        form.cloud = cloud->second;
    }
    return form;
}

} // namespace bolster
