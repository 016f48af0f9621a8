#include "FormChoice.h"

#include "Ask.h"
#include "DesignSession.h"
#include "FileFormats.h"

#include <QFileInfo>

namespace bolster {

namespace {

const QString otherFile = QStringLiteral("other");
constexpr int fileRole = Qt::UserRole + 1;

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
        if (currentData().toString() == otherFile)
            chooseFile();
        else
            m_before = currentIndex();
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
    addItem(tr("A file \u2026"), otherFile);
}

FormChoice::Chosen FormChoice::chosen() const
{
    return {static_cast<ElementId>(currentData().toUInt()), currentData(fileRole).toString()};
}

void FormChoice::choose(const Chosen& chosen)
{
    if (QFileInfo::exists(chosen.file)) {
        take(chosen.file);
        return;
    }
    const int row = chosen.scan == noElement ? -1 : findData(number(chosen.scan));
    if (row >= 0) {
        setCurrentIndex(row);
        m_before = row;
    }
}

bool FormChoice::asksForFile(const std::function<void()>& then)
{
    const bool asks = currentData().toString() == otherFile;
    if (asks)
        chooseFile(then);
    return asks;
}

/// Who chooses none has what was chosen before.
void FormChoice::chooseFile(const std::function<void()>& then)
{
    setCurrentIndex(m_before);
    askForFile(this, m_fileTitle, usualFolder(m_session.besideFile()),
               tr("Meshes and scans (%1);;All files (*)")
                   .arg(patternsOf(FileUse::Frame) + ' ' + patternsOf(FileUse::Scan)),
               [this, then](const QString& file) {
                   take(file);
                   emit fileChosen();
                   if (then)
                       then();
               });
}

/// Chosen files stay in the list, above the entry for another one.
void FormChoice::take(const QString& file)
{
    int row = findData(file, fileRole);
    if (row < 0) {
        row = count() - 1;
        insertItem(row, QFileInfo(file).fileName());
        setItemData(row, file, fileRole);
        setItemData(row, file, Qt::ToolTipRole);
    }
    setCurrentIndex(row);
    m_before = row;
}

FitForm FormChoice::form() const
{
    FitForm form;
    form.file = currentData(fileRole).toString();
    if (!form.file.isEmpty())
        return form;
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
