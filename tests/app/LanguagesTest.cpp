// Every dialog, panel and menu in every language at several sizes of letters: nothing is cut off, everything has a
// name.
#include "WindowTest.h"

#include "EveryDialog.h"
#include "StartPage.h"
#include "Translations.h"

#include <QAbstractButton>
#include <QDir>
#include <QGroupBox>
#include <QLocale>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTranslator>

namespace bolster {
namespace {

/// Words that are longer than those of any language, in brackets, so that what nobody translates is seen.
class PseudoLanguage : public QTranslator {
public:
    using QTranslator::QTranslator;

    QString translate(const char*, const char* source, const char*, int) const override
    {
        QString text = QString::fromUtf8(source);
        const bool dots = text.endsWith(u'\u2026');
        return u'[' + text + QString(text.size() * 2 / 5, u'\u00f6') +
               (dots ? QStringLiteral("]\u2026") : QStringLiteral("]"));
    }
    bool isEmpty() const override { return false; }
};

/// As chosen before the program starts; then as it was.
class Spoken {
public:
    static constexpr const char* pseudo = "pseudo";

    Spoken(const QString& language, double size)
        : m_font(QApplication::font())
    {
        if (language == pseudo) {
            QCoreApplication::installTranslator(new PseudoLanguage(qApp));
        } else {
            QLocale::setDefault(QLocale(language));
            installTranslations(*qApp, QLocale(language));
        }
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

/// Titles and buttons that are said in English whatever the language.
QStringList untranslated(const QWidget& shown)
{
    QStringList found;
    const auto look = [&](const QString& text) {
        if (text.contains(QRegularExpression(QStringLiteral("[A-Za-z]{3}"))) && !text.contains(u'['))
            found << text;
    };
    look(shown.windowTitle());
    for (const auto* button : shown.findChildren<QAbstractButton*>())
        if (button->isVisible() && button->objectName() != u"sample-card") // samples bring their names
            look(button->text());
    for (const auto* box : shown.findChildren<QGroupBox*>())
        look(box->title());
    return found;
}

/// What is cut off in a language; its dialogs with the sample's first patch and seam selected.
QStringList faultsIn(const QString& language, double size)
{
    const Spoken spoken(language, size);
    QStringList found;
    const auto note = [&](const QWidget& shown, const QString& where) {
        for (const QString& text : test::clippedTexts(shown))
            found << QStringLiteral("%1, %2 %, %3: %4").arg(language).arg(100 * size).arg(where, text);
        if (language == Spoken::pseudo)
            for (const QString& text : untranslated(shown))
                found << QStringLiteral("%1: not translated: %2").arg(where, text);
        if (const QString folder = qEnvironmentVariable("BOLSTER_PICTURES"); !folder.isEmpty())
            const_cast<QWidget&>(shown).grab().save(
                QStringLiteral("%1/%2-%3-%4.png").arg(folder, language).arg(100 * size).arg(where));
    };
    MainWindow window;
    window.resize(1560, 960);
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.greet();
    waitUntilLaidOut();
    note(window.startPage(), "start");
    bool opened = false;
    QObject::connect(&window.session(), &DesignSession::opened, &window, [&] { opened = true; });
    window.open(QString::fromStdString(test::samplesFolder() + "/box-cushion/box-cushion.json"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return opened && window.solver().atRest(); }, 120000));
    window.document().design().each<Patch>([&](ElementId id, const Patch&) { window.selection().set({id}); });
    waitUntilLaidOut();
    note(window, "window");
    EXPECT_LE(window.menuBar()->sizeHint().width(), window.width()) << language.toStdString();
    test::lookAtDialogs(window, note);
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

/// All languages and sizes with BOLSTER_ALL_SIZES=1; else those with the longest words and with other letters, at
/// the largest size. BOLSTER_PICTURES=FOLDER keeps what was looked at.
TEST(Languages, NothingIsCutOffInAnyOfThem)
{
    std::vector<double> sizes = {2};
    if (qEnvironmentVariableIsSet("BOLSTER_ALL_SIZES"))
        sizes = {1, 1.45, 2};
    std::vector<std::string> spoken = {"ja", "pl"};
    if (sizes.size() > 1)
        spoken = languages();
    for (const std::string& language : spoken)
        for (const double size : sizes) {
            const QStringList faults = faultsIn(QString::fromStdString(language), size);
            EXPECT_TRUE(faults.isEmpty()) << faults.join('\n').toStdString();
        }
}

TEST(Languages, EveryTitleAndButtonCanBeTranslated)
{
    const QStringList faults = faultsIn(Spoken::pseudo, 1);
    EXPECT_TRUE(faults.isEmpty()) << faults.join('\n').toStdString();
}

using AccessibleTest = WindowTest;

TEST_F(AccessibleTest, EveryControlHasANameAndARole)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilAtRest());
    for (QDockWidget* dock : window.docks().all())
        Docks::reveal(dock);
    window.document().design().each<Patch>([&](ElementId id, const Patch&) { window.selection().set({id}); });
    waitUntilLaidOut();
    QStringList nameless = test::namelessControls(window);
    test::lookAtDialogs(window, [&](const QWidget& dialog, const QString& id) {
        for (const QString& control : test::namelessControls(dialog))
            nameless << id + ": " + control;
    });
    EXPECT_TRUE(nameless.isEmpty()) << nameless.join('\n').toStdString();
}

} // namespace
} // namespace bolster
