// Whatever was made is in the file, under Unsaved work, or was given up in a question that named it.
#include "WindowTest.h"

#include "DesignHash.h"
#include "ElementEdits.h"
#include "HistoryModel.h"
#include "HistoryView.h"
#include "Journal.h"
#include "Project.h"
#include "WorkJournal.h"

#include <QDir>
#include <QLineEdit>
#include <QStandardPaths>

#include <memory>
#include <random>
#include <variant>

namespace bolster {
namespace {

/// What a history holds of a version.
struct Version {
    std::string design, name, branch;

    friend bool operator==(const Version&, const Version&) = default;
};

struct Known {
    std::vector<Version> versions; // by node
    NodeId current = 0;
};

Known knownOf(const History& history, const Design& design)
{
    Known known;
    known.current = history.current();
    for (NodeId node = 0; node < history.count(); ++node)
        known.versions.push_back({hexText(hashOf(history.designAt(node, design).value())), history.node(node).name,
                                  history.node(node).branch});
    return known;
}

Known knownOf(const OpenedProject& project)
{
    EXPECT_EQ(project.problem.english(), "");
    return project.problem.empty() ? knownOf(project.history, project.design) : Known();
}

class NothingLostTest : public WindowTest {
protected:
    ~NothingLostTest() override
    {
        const QDir state(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation));
        for (const char* name : {"journals", "bin", "places"})
            QDir(state.filePath(name)).removeRecursively();
    }

    Document& document() { return window.document(); }

    void change()
    {
        Settings settings = document().design().settings();
        settings.edgeLength += 1;
        document().commit(edits::changeSettings(document().design(), settings));
    }

    void saveAs(const QString& path)
    {
        bool done = false;
        window.session().save(path, [&](const Message& why) {
            EXPECT_EQ(why.english(), "");
            done = true;
        });
        ASSERT_TRUE(QTest::qWaitFor([&] { return done; }, 30000));
    }

    /// Notes what the next box says.
    void answerAndRead(QMessageBox::StandardButton button)
    {
        whenABoxHas([this, button](QMessageBox& box) {
            said = box.text() + '\n' + box.informativeText();
            return box.button(button);
        });
    }

    void closeWindow()
    {
        window.close();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window.isVisible(); }, 30000));
    }

    /// As the next start does.
    void openAgain(const QString& file)
    {
        window.session().startNew();
        window.show();
        ASSERT_TRUE(open(file));
    }

    ElementId firstPatch()
    {
        ElementId found = noElement;
        document().design().each<Patch>([&](ElementId id, const Patch&) {
            if (found == noElement)
                found = id;
        });
        return found;
    }

    QTemporaryDir folder;
    QString path = folder.filePath("box.bolster");
    QString said;
};

TEST_F(NothingLostTest, ABranchAndItsNameAreAskedAboutWhenOneStandsAtWhatWasSaved)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    change();
    saveAs(path);
    window.command("edit.undo")->trigger();
    window.selection().set({firstPatch()});
    window.command("edit.delete")->trigger();
    ASSERT_EQ(document().history().count(), 3);
    QListView& history = *window.findChild<HistoryView*>();
    QMetaObject::invokeMethod(&window, [&] { window.command("edit.name-branch")->trigger(); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return history.findChild<QLineEdit*>() != nullptr; }, 5000));
    QTest::keyClicks(history.findChild<QLineEdit*>(), "Without a lid");
    QTest::keyClick(history.findChild<QLineEdit*>(), Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().history().node(2).branch == "Without a lid"; }, 5000));
    const QModelIndex saved = window.findChild<HistoryView*>()->history().indexOf(1);
    QTest::mouseClick(history.viewport(), Qt::LeftButton, {}, history.visualRect(saved).center());
    ASSERT_EQ(document().history().current(), 1);
    EXPECT_TRUE(window.isWindowModified());

    answerAndRead(QMessageBox::Save);
    closeWindow();
    EXPECT_EQ(answered, 1);
    EXPECT_TRUE(said.contains("1 edit")) << qPrintable(said);
    EXPECT_TRUE(said.contains("names of versions or branches")) << qPrintable(said);
    openAgain(path);
    EXPECT_EQ(document().history().count(), 3);
    EXPECT_EQ(document().history().node(2).branch, "Without a lid");
    EXPECT_FALSE(window.isWindowModified());
}

TEST_F(NothingLostTest, WhereOneStandsIsRememberedWithoutAQuestion)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    change();
    change();
    saveAs(path);
    document().jumpTo(1);
    EXPECT_TRUE(window.isWindowModified()) << "the file shows another version";
    closeWindow();
    EXPECT_EQ(answered, 0) << "nothing was made";
    openAgain(path);
    EXPECT_EQ(document().history().current(), 1);
    EXPECT_TRUE(window.isWindowModified());
    window.command("file.revert")->trigger();
    EXPECT_EQ(document().history().current(), 2);
    EXPECT_FALSE(window.isWindowModified());
    closeWindow();
    openAgain(path);
    EXPECT_EQ(document().history().current(), 2);
}

TEST_F(NothingLostTest, AJournalThatIsRemovedWhileOneWorksIsMadeAnew)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    change();
    saveAs(path);
    openAgain(path); // what was done before is read from the journal when it is needed
    change();
    ASSERT_TRUE(QDir(WorkJournal::folder()).removeRecursively());
    change();
    const auto journals = QDir(WorkJournal::folder()).entryInfoList({"*.bolster"}, QDir::Files);
    ASSERT_EQ(journals.size(), 1);
    const QString copy = folder.filePath("copy.bolster"); // what a crash would leave now
    for (const char* ending : {"", "-wal"})
        (void)QFile::copy(journals[0].filePath() + ending, copy + ending);
    const auto opened = Journal::open(copy);
    ASSERT_TRUE(opened.journal) << opened.project.problem.english();
    EXPECT_EQ(knownOf(opened.project).versions, knownOf(document().history(), document().design()).versions);
    EXPECT_EQ(opened.project.history.count(), 4);
    document().jumpTo(0);
    saveAs(path);
    EXPECT_FALSE(document().hasUnsavedWork());
    EXPECT_EQ(openProject(path, ProjectCheck::Everything).history.count(), 4);
    EXPECT_FALSE(window.banner().shown()) << qPrintable(window.banner().text());
}

TEST_F(NothingLostTest, TheNameOfAVersionOfADesignThatNothingWasDoneToIsSaved)
{
    document().nameVersion(0, "Empty");
    saveAs(path);
    EXPECT_FALSE(document().dirty());
    EXPECT_EQ(openProject(path).history.node(0).name, "Empty");
    window.command("file.new")->trigger();
    document().nameVersion(0, "Nothing yet");
    answerAndRead(QMessageBox::Discard);
    closeWindow();
    EXPECT_EQ(answered, 1);
    EXPECT_TRUE(said.contains("names of versions or branches")) << qPrintable(said);
}

TEST_F(NothingLostTest, ATextDoesNotSwallowBranches)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    change();
    window.command("edit.undo")->trigger();
    window.selection().set({firstPatch()});
    window.command("edit.delete")->trigger();
    saveAs(folder.filePath("box.json"));
    EXPECT_FALSE(window.isWindowModified());
    whenABoxHas([this](QMessageBox& box) {
        said = box.informativeText() + box.button(QMessageBox::Save)->text();
        return box.button(QMessageBox::Discard);
    });
    closeWindow();
    EXPECT_TRUE(said.contains("1 edit")) << qPrintable(said);
    EXPECT_TRUE(said.contains("project")) << qPrintable(said);
}

TEST_F(NothingLostTest, NamesGivenWhileAnotherDesignIsReadAreAskedAbout)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    saveAs(path);
    answerAndRead(QMessageBox::Cancel);
    window.open(sample("armchair"));
    if (window.session().path() != path)
        GTEST_SKIP() << "it was read before anything could be named";
    document().nameVersion(0, "As sold"); // changes nothing that is seen
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 30000));
    EXPECT_EQ(document().history().node(0).name, "As sold");
    EXPECT_EQ(window.session().path(), path);
}

/// Somebody who does this and that, closes, and comes back.
class AnyWork : public NothingLostTest {
protected:
    int pick(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }
    NodeId anyNode() { return pick(document().history().count()); }
    std::string anyName() { return pick(4) == 0 ? std::string() : "Name " + std::to_string(pick(1000)); }

    void work(int steps)
    {
        for (int i = 0; i < steps; ++i) {
            switch (pick(10)) {
            case 0:
                window.command("edit.undo")->trigger();
                break;
            case 1:
                window.command("edit.redo")->trigger();
                break;
            case 2:
                document().jumpTo(anyNode());
                break;
            case 3:
                document().nameVersion(anyNode(), anyName());
                break;
            case 4:
                document().nameBranch(anyNode(), anyName());
                break;
            case 5:
                if (pick(3) == 0)
                    window.session().save(path, [](const Message&) {}); // work goes on meanwhile
                break;
            case 6:
                QApplication::processEvents();
                break;
            default:
                changeSomething();
            }
        }
    }

    void changeSomething()
    {
        Settings settings = document().design().settings();
        settings.edgeLength = 5 + 0.001 * ++m_changes;
        document().commit(edits::changeSettings(document().design(), settings));
    }

    /// Closes the window, or opens a new design; says how it was asked.
    void leave(QMessageBox::StandardButton button)
    {
        answered = 0;
        said.clear();
        bool opened = false;
        const auto connection = QObject::connect(&window.session(), &DesignSession::opened, [&] { opened = true; });
        auto* asked = button == QMessageBox::YesToAll ? pressWhenAsked("Keep") : pressWhenAsked(button);
        const bool closing = pick(2) == 0;
        if (closing)
            window.close();
        else
            window.command("file.new")->trigger();
        EXPECT_TRUE(QTest::qWaitFor([&] { return closing ? !window.isVisible() : opened; }, 60000));
        delete asked;
        QObject::disconnect(connection);
    }

    QTimer* pressWhenAsked(const std::variant<QMessageBox::StandardButton, QString>& wanted)
    {
        auto* timer = new QTimer(&window);
        QObject::connect(timer, &QTimer::timeout, [this, wanted] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box)
                return;
            said = box->text() + '\n' + box->informativeText();
            ++answered;
            for (QAbstractButton* button : box->buttons())
                if (std::holds_alternative<QString>(wanted)
                        ? button->text().remove('&').contains(std::get<QString>(wanted))
                        : box->standardButton(button) == std::get<QMessageBox::StandardButton>(wanted)) {
                    button->click();
                    return;
                }
        });
        timer->start(5);
        return timer;
    }

    /// Where the work is now.
    Known found()
    {
        const QList<WorkJournal::Left> left = WorkJournal::left();
        EXPECT_LE(left.size(), 1);
        return left.isEmpty() ? knownOf(openProject(path)) : knownOf(Journal::open(left.front().journal).project);
    }

    std::mt19937 m_random{11};
    int m_changes = 0;
};

TEST_F(AnyWork, IsInTheFileOrUnderUnsavedWorkOrWasGivenUpByName)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    saveAs(path);
    const QMessageBox::StandardButton answers[] = {QMessageBox::Save, QMessageBox::Discard,
                                                   QMessageBox::YesToAll /* keep for later */};
    for (int round = 0; round < 12; ++round) {
        SCOPED_TRACE(round);
        work(pick(3) == 0 ? 2 : 25);
        if (pick(4) == 0)
            saveAs(path);
        const Known made = knownOf(document().history(), document().committed());
        const auto answer = answers[pick(3)];
        leave(answer);
        const Known after = found();
        if (answered > 0 && answer == QMessageBox::Discard) {
            EXPECT_EQ(after.versions.size() < made.versions.size(), said.contains("edit")) << qPrintable(said);
            if (after.versions.size() == made.versions.size()) {
                EXPECT_TRUE(said.contains("names")) << qPrintable(said);
            }
        } else {
            EXPECT_TRUE(after.versions == made.versions) << qPrintable(said);
        }
        openAgain(path);
        if (answered == 0 || answer != QMessageBox::Discard) {
            EXPECT_EQ(document().history().current(), made.current) << "it goes on where it was left";
            EXPECT_TRUE(knownOf(document().history(), document().committed()).versions == made.versions);
        }
        EXPECT_EQ(document().hasUnsavedWork(), answered > 0 && answer == QMessageBox::YesToAll);
        if (HasFailure())
            return;
    }
}

} // namespace
} // namespace bolster
