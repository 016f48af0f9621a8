// Every dialog, panel and menu in every language at several sizes of letters: nothing is cut off, everything has a
// name.
#include "WindowTest.h"

#include "EveryDialog.h"
#include "Translations.h"

#include <QDir>
#include <QLocale>
#include <QMenuBar>
#include <QTranslator>

namespace bolster {
namespace {

/// As chosen before the program starts; then as it was.
class Spoken {
public:
    Spoken(const QString& language, double size)
        : m_font(QApplication::font())
    {
        QLocale::setDefault(QLocale(language));
        installTranslations(*qApp, QLocale(language));
        QFont larger = m_font;
        larger.setPointSizeF(m_font.pointSizeF() * size);
        QApplication::setFont(larger);
    }
    ~Spoken()
    {
        for (QTranslator* one : qApp->findChildren<QTranslator*>()) {
            QCoreApplication::removeTranslator(one);
            delete one;
        }
        QLocale::setDefault(QLocale::c());
        QApplication::setFont(m_font);
    }
    Spoken(const Spoken&) = delete;
    Spoken& operator=(const Spoken&) = delete;

private:
    QFont m_font;
};

/// What is cut off in a language; its dialogs with the sample's first patch and seam selected.
QStringList clippedIn(const QString& language, double size)
{
    const Spoken spoken(language, size);
    QStringList found;
    const auto note = [&](const QWidget& shown, const QString& where) {
        for (const QString& text : test::clippedTexts(shown))
            found << QStringLiteral("%1, %2 %, %3: %4").arg(language).arg(100 * size).arg(where, text);
    };
    MainWindow window;
    window.resize(1560, 960);
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
    bool opened = false;
    QObject::connect(&window.session(), &DesignSession::opened, &window, [&] { opened = true; });
    window.open(QString::fromStdString(test::samplesFolder() + "/box-cushion/box-cushion.json"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return opened && window.solver().atRest(); }, 120000));
    window.document().design().each<Patch>([&](ElementId id, const Patch&) { window.selection().set({id}); });
    QTest::qWait(100);
    note(window, "window");
    EXPECT_LE(window.menuBar()->sizeHint().width(), window.width()) << language.toStdString();
    EXPECT_GT(test::lookAtDialogs(window, note), 10) << language.toStdString();
    window.document().markSaved();
    window.close();
    return found;
}

std::vector<std::string> languages()
{
    std::vector<std::string> found;
    for (const QString& file : QDir(QStringLiteral(":/translations")).entryList({"bolster_*.qm"}))
        found.push_back(file.mid(8).chopped(3).toStdString());
    return found;
}

TEST(Languages, AreTheEight)
{
    EXPECT_EQ(languages(), (std::vector<std::string>{"de", "en", "es", "fr", "it", "ja", "pl", "zh_CN"}));
}

/// All sizes with BOLSTER_ALL_SIZES=1; else the one in the middle.
TEST(Languages, NothingIsCutOffInAnyOfThem)
{
    std::vector<double> sizes = {1.45};
    if (qEnvironmentVariableIsSet("BOLSTER_ALL_SIZES"))
        sizes = {1, 1.45, 2};
    for (const std::string& language : languages())
        for (const double size : sizes) {
            const QStringList clipped = clippedIn(QString::fromStdString(language), size);
            EXPECT_TRUE(clipped.isEmpty()) << clipped.join('\n').toStdString();
        }
}

using AccessibleTest = WindowTest;

TEST_F(AccessibleTest, EveryControlHasANameAndARole)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilAtRest());
    for (QDockWidget* dock : window.docks().all())
        Docks::reveal(dock);
    window.document().design().each<Patch>([&](ElementId id, const Patch&) { window.selection().set({id}); });
    QTest::qWait(100);
    QStringList nameless = test::namelessControls(window);
    const int dialogs = test::lookAtDialogs(window, [&](const QWidget& dialog, const QString& id) {
        for (const QString& control : test::namelessControls(dialog))
            nameless << id + ": " + control;
    });
    EXPECT_GT(dialogs, 10);
    EXPECT_TRUE(nameless.isEmpty()) << nameless.join('\n').toStdString();
}

} // namespace
} // namespace bolster
