#include "EveryDialog.h"

#include "Commands.h"
#include "ElidedLabel.h"
#include "StartCard.h"
#include "WatchedApplication.h"

#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>

namespace bolster::test {

namespace {

/// Commands with three dots that ask within the window.
const QStringList opensNothing = {QStringLiteral("help.find-command"), QStringLiteral("twin.symmetry")};

QWidget* openedBeside(const QWidget& window)
{
    const QList<QWidget*> all = QApplication::topLevelWidgets();
    const auto found = std::ranges::find_if(all, [&](const QWidget* one) {
        return one != &window && one->isVisible() &&
               (one->windowType() == Qt::Dialog || one->windowType() == Qt::Window);
    });
    return found == all.end() ? nullptr : *found;
}

QPushButton* closingButton(const QWidget& opened)
{
    for (const auto* box : opened.findChildren<QDialogButtonBox*>())
        for (const QDialogButtonBox::StandardButton which : {QDialogButtonBox::Close, QDialogButtonBox::Cancel})
            if (QPushButton* button = box->button(which))
                return button;
    return nullptr;
}

void closeAll(const QWidget& window)
{
    for (int tries = 0; tries < 10; ++tries) {
        QWidget* opened = openedBeside(window);
        if (!opened)
            return;
        if (QPushButton* button = closingButton(*opened)) {
            button->click();
            EXPECT_TRUE(QTest::qWaitFor([&] { return openedBeside(window) != opened; }, 5000))
                << opened->metaObject()->className() << ": its button \"" << qPrintable(button->text())
                << "\" does not close it";
        }
        if (openedBeside(window) != opened)
            continue;
        if (auto* dialog = qobject_cast<QDialog*>(opened))
            dialog->reject();
        else
            opened->close();
        (void)QTest::qWaitFor([&] { return openedBeside(window) != opened; }, 1000);
    }
}

QString described(const QWidget& widget, const QString& text, int has, int needs)
{
    return QStringLiteral("\"%1\" (%2, %3 of %4 pixels)")
        .arg(text, QString::fromLatin1(widget.metaObject()->className()))
        .arg(has)
        .arg(needs);
}

/// Within a scroll area a text may be out of sight, but not cut.
void addLabel(const QLabel& label, QStringList& found)
{
    if (label.text().isEmpty() || qobject_cast<const ElidedLabel*>(&label))
        return;
    if (label.wordWrap()) {
        const int needs = label.heightForWidth(label.width());
        if (needs > label.height() + 2)
            found << described(label, label.text().left(60), label.height(), needs);
    } else if (label.sizeHint().width() > label.width() + 1) {
        found << described(label, label.text().left(60), label.width(), label.sizeHint().width());
    }
}

void addButton(const QAbstractButton& button, QStringList& found)
{
    const bool shows = qobject_cast<const QPushButton*>(&button) || qobject_cast<const QCheckBox*>(&button) ||
                       qobject_cast<const QRadioButton*>(&button);
    if (!shows || button.text().isEmpty())
        return;
    const int needs = std::min(button.sizeHint().width(), button.minimumSizeHint().width());
    if (needs > button.width() + 1)
        found << described(button, button.text(), button.width(), needs);
}

/// What is too long for a field can be scrolled by the caret; a number is looked at only.
void addSpinBox(const QAbstractSpinBox& box, QStringList& found)
{
    constexpr int margins = 2 * 2, caret = 1; // of every line of text
    const auto* line = box.findChild<const QLineEdit*>();
    const int needs = line->fontMetrics().horizontalAdvance(line->displayText()) + margins + caret;
    if (needs > line->contentsRect().width())
        found << described(box, line->displayText(), line->contentsRect().width(), needs);
}

/// Words, not the names that somebody gave to something.
void addComboBox(const QComboBox& box, QStringList& found)
{
    if (box.isEditable() || box.property("data").toBool())
        return;
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.subControls = QStyle::SC_All;
    option.iconSize = box.iconSize();
    const int has =
        box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width();
    const int icon = box.itemIcon(box.currentIndex()).isNull() ? 0 : box.iconSize().width() + 4;
    const int needs = box.fontMetrics().horizontalAdvance(box.currentText()) + icon;
    if (needs > has)
        found << described(box, box.currentText(), has, needs);
}

void addHeads(const QHeaderView& heads, QStringList& found)
{
    if (heads.orientation() != Qt::Horizontal)
        return;
    const int margin = heads.style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &heads);
    for (int column = 0; column < heads.count(); ++column) {
        const QString text = heads.model()->headerData(column, Qt::Horizontal).toString();
        const int needs = heads.fontMetrics().horizontalAdvance(text) + 2 * margin;
        if (!text.isEmpty() && !heads.isSectionHidden(column) && needs > heads.sectionSize(column))
            found << described(heads, text, heads.sectionSize(column), needs);
    }
}

void addCard(const StartCard& card, QStringList& found)
{
    if (!card.showsAll())
        found << described(card, card.text() + u' ' + card.words(), card.height(), card.sizeHint().height());
}

void addGroup(const QGroupBox& box, QStringList& found)
{
    const int needs = box.fontMetrics().horizontalAdvance(box.title());
    if (needs > box.width())
        found << described(box, box.title(), box.width(), needs);
}

/// Nobody comes to what lies beside one that does not scroll there.
void addScrollArea(const QScrollArea& area, QStringList& found)
{
    if (area.widget() && area.horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff &&
        area.widget()->width() > area.viewport()->width())
        found << described(area, area.objectName() + QStringLiteral(" contents"), area.viewport()->width(),
                           area.widget()->width());
}

} // namespace

void lookAtDialogs(MainWindow& window, const std::function<void(QWidget&, const QString& id)>& look)
{
    for (QAction* action : window.commands().all()) {
        if (!action->text().contains(u'\u2026') || !action->isEnabled() ||
            opensNothing.contains(action->objectName()))
            continue;
        action->trigger();
        QWidget* opened = nullptr;
        EXPECT_TRUE(QTest::qWaitFor([&] { return (opened = openedBeside(window)) != nullptr; }, 20000))
            << action->objectName().toStdString() << " opens nothing";
        if (opened && !qobject_cast<QFileDialog*>(opened)) {
            waitUntilLaidOut();
            look(*opened, action->objectName());
        }
        closeAll(window);
    }
}

QStringList clippedTexts(const QWidget& window)
{
    QStringList found;
    const auto look = [&]<class Kind>(const QWidget* widget, void (*add)(const Kind&, QStringList&)) {
        const auto* one = qobject_cast<const Kind*>(widget);
        if (one)
            add(*one, found);
        return one != nullptr;
    };
    for (const auto* widget : window.findChildren<QWidget*>())
        if (widget->isVisible())
            (void)(look(widget, &addLabel) || look(widget, &addCard) || look(widget, &addButton) ||
                   look(widget, &addSpinBox) || look(widget, &addComboBox) || look(widget, &addHeads) ||
                   look(widget, &addScrollArea) || look(widget, &addGroup));
    return found;
}

QStringList namelessControls(const QWidget& window)
{
    QStringList found;
    for (auto* widget : window.findChildren<QWidget*>()) {
        const bool partOfOther =
            widget->parentWidget() && (qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) ||
                                       qobject_cast<QComboBox*>(widget->parentWidget()));
        if (!widget->isVisible() || partOfOther || !(widget->focusPolicy() & Qt::TabFocus))
            continue;
        QAccessibleInterface* said = QAccessible::queryAccessibleInterface(widget);
        if (!said || said->role() == QAccessible::NoRole || said->text(QAccessible::Name).trimmed().isEmpty())
            found << QStringLiteral("%1 \"%2\" in %3")
                         .arg(QString::fromLatin1(widget->metaObject()->className()), widget->objectName(),
                              QString::fromLatin1(widget->parentWidget()->metaObject()->className()));
    }
    return found;
}

} // namespace bolster::test
