#include "StartCommands.h"

#include "Ask.h"
#include "Banner.h"
#include "Commands.h"
#include "CoverView.h"
#include "DesignSession.h"
#include "FileFlows.h"
#include "OwnWindow.h"
#include "PatternView.h"
#include "ReportDialog.h"
#include "StartPage.h"
#include "WhatsNew.h"

#include <QAction>
#include <QApplication>

#include <utility>

namespace bolster {

StartCommands::StartCommands(Commands& commands, const Parts& parts)
    : m_parts(parts)
    , m_commands(commands)
{
    addCommands(commands);
    connectPage(commands);
    closeWhenBegun();
}

void StartCommands::addCommands(Commands& commands)
{
    commands.add(
        {{.id = "file.start-page", .text = tr("Start pa&ge"), .places = {"file/1"}, .does = [this] { openPage(); }},
         {.id = "file.new-window",
          .text = tr("New &window"),
          .places = {"file/1"},
          .does =
              [this] {
                  if (!openInWindowOfItsOwn())
                      tell(&m_parts.window, QMessageBox::Warning, tr("No other window could be opened."),
                           tr("The system did not start the program again. Close some programs, and try "
                              "once more."));
              }},
         {.id = "help.report",
          .text = tr("&Report a problem \u2026"),
          .places = {"help/2"},
          .does =
              [this] {
                  DesignSession& session = m_parts.session;
                  openDialog(new ReportDialog(session.document().committed(), session.title(), &m_parts.window));
              }},
         {.id = "help.whats-new", .text = tr("What's &new"), .places = {"help/2"}, .does = [this] {
              showWhatsNew(&m_parts.window);
          }}});
}

void StartCommands::connectPage(Commands& commands)
{
    StartPage& page = m_parts.page;
    FileFlows& files = m_parts.files;
    connect(&page, &StartPage::frameWanted, this, [this, &files] {
        begin([this, &files] {
            m_begunWithFrame = true;
            files.imports.importFrame();
        });
    });
    connect(&page, &StartPage::patternWanted, this,
            [this, &files] { begin([&files] { files.imports.importPattern(); }); });
    connect(&page, &StartPage::scanWanted, this,
            [this, &files] { begin([&files] { files.imports.importScan(); }); });
    connect(&page, &StartPage::rectangleWanted, this, [this] {
        begin([this] {
            m_parts.page.close();
            m_parts.pattern.setTool(PatternToolKind::Rectangle);
            m_parts.pattern.setFocus(Qt::OtherFocusReason);
        });
    });
    connect(&page, &StartPage::openWanted, this, [&files] { files.opening.open(); });
    connect(&page, &StartPage::fileWanted, this, [&files](const QString& path) { files.opening.open(path); });
    connect(&page, &StartPage::templateWanted, this,
            [&files](const QString& path) { files.opening.openTemplate(path); });
    connect(&page, &StartPage::leftWanted, this,
            [&files](const WorkJournal::Left& left) { files.left.openLeft(left); });
    connect(&page, &StartPage::tourWanted, commands["help.tour"], &QAction::trigger);
    connect(&files.left, &LeftWork::leftFound, &page, &StartPage::setLeft);
    connect(&files.imports, &ImportFlow::imported, this, [this](FileKind kind) {
        if (std::exchange(m_begunWithFrame, false) && kind == FileKind::Mesh)
            sayWhatIsNext();
    });
}

/// Whatever the way: opened, imported, drawn.
void StartCommands::closeWhenBegun()
{
    StartPage& page = m_parts.page;
    connect(&page, &StartPage::toggled, this, [this](bool open) {
        const QWidget* now = QApplication::focusWidget();
        if (!open && (!now || m_parts.page.isAncestorOf(now)))
            m_parts.pattern.setFocus(Qt::OtherFocusReason);
    });
    connect(&m_parts.session, &DesignSession::opened, &page, &StartPage::close);
    connect(&m_parts.session.document(), &Document::changed, &page, &StartPage::close);
    connect(&m_parts.pattern, &PatternView::toolChanged, &page, [&page](PatternToolKind kind) {
        if (kind != PatternToolKind::Select)
            page.close();
    });
    connect(&m_parts.coverView, &CoverView::toolChanged, &page, [&page](CoverToolKind kind) {
        if (kind != CoverToolKind::Select)
            page.close();
    });
}

/// Nothing is open and nothing has been done: there is nothing to go back to.
bool StartCommands::untouched() const
{
    return m_parts.session.path().isEmpty() && m_parts.session.document().history().count() <= 1 &&
           m_parts.session.document().design().elements().size() <= 2; // settings and a fabric
}

/// With a new design: what is open stays as it is.
void StartCommands::begin(const std::function<void()>& what)
{
    if (untouched())
        what();
    else
        m_parts.files.opening.startNew(what);
}

void StartCommands::openPage()
{
    m_begunWithFrame = false;
    m_parts.page.open(!untouched());
    m_parts.files.left.findLeft();
}

void StartCommands::greet()
{
    m_parts.page.open(false);
    sayWhatIsNew();
}

void StartCommands::sayWhatIsNew()
{
    if (!newSinceLastStart(QCoreApplication::applicationVersion()))
        return;
    m_parts.banner.announce(Banner::Kind::Information,
                            tr("This is Bolster %1. What is new is under Help > What's new.")
                                .arg(QCoreApplication::applicationVersion()),
                            {{tr("Sh&ow"), [this] { showWhatsNew(&m_parts.window); }}});
}

void StartCommands::sayWhatIsNext()
{
    m_parts.banner.announce(
        Banner::Kind::Information,
        tr("The frame is in the 3D view. Draw the curves on it where the cloth is fixed, or the first patch."),
        {{tr("Draw a &fixation curve"), [this] { m_parts.coverView.setTool(CoverToolKind::DrawFixation); }},
         {tr("Draw a &rectangle"), [this] { m_parts.pattern.setTool(PatternToolKind::Rectangle); }},
         {tr("Pattern of a form \u2026"), [this] { m_commands["pattern.from-form"]->trigger(); }}});
}

} // namespace bolster
