#include "FileChoice.h"

#include "Ask.h"
#include "DesignSession.h"

#include <QFileInfo>

#include <utility>

namespace bolster {

namespace {

const QString otherFile = QStringLiteral("other");
constexpr int fileRole = Qt::UserRole + 1;

} // namespace

FileChoice::FileChoice(DesignSession& session, QString title, QString filter, QWidget* parent)
    : QComboBox(parent)
    , m_session(session)
    , m_title(std::move(title))
    , m_filter(std::move(filter))
{
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(16);
    connect(this, &QComboBox::activated, this, [this] {
        if (isOnFiles()) {
            ask();
            return;
        }
        m_before = currentIndex();
        emit chosenAnew();
    });
}

void FileChoice::addFiles()
{
    addItem(tr("A file \u2026"), otherFile);
    m_before = currentIndex();
}

bool FileChoice::isOnFiles() const
{
    return currentData().toString() == otherFile;
}

QString FileChoice::file() const
{
    return currentData(fileRole).toString();
}

void FileChoice::chooseRow(int row)
{
    setCurrentIndex(row);
    m_before = row;
}

bool FileChoice::asksForFile(const std::function<void()>& then)
{
    const bool asks = isOnFiles();
    if (asks)
        ask(then);
    return asks;
}

/// Who chooses none has what was chosen before.
void FileChoice::ask(const std::function<void()>& then)
{
    setCurrentIndex(m_before);
    askForFile(this, m_title, usualFolder(m_session.besideFile()), m_filter, [this, then](const QString& file) {
        chooseFile(file);
        emit fileChosen();
        emit chosenAnew();
        if (then)
            then();
    });
}

void FileChoice::chooseFile(const QString& file)
{
    int row = findData(file, fileRole);
    if (row < 0) {
        row = count() - 1;
        insertItem(row, QFileInfo(file).fileName());
        setItemData(row, file, fileRole);
        setItemData(row, file, Qt::ToolTipRole);
    }
    chooseRow(row);
}

} // namespace bolster
