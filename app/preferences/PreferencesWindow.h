// The window in which preferences are found and set.
#pragma once

#include "PreferenceStore.h"

#include <QDialog>

#include <functional>

class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace bolster {

class ColumnScroll;

/// Made from the table. What is set holds at once; a search shows what has its words, whatever page it is on.
class PreferencesWindow : public QDialog {
    Q_OBJECT

public:
    struct Ways {
        std::function<void()> editKeys; ///< opens the editor of single shortcuts
        std::function<void()> restart;  ///< ends the program and starts it again
    };
    PreferencesWindow(PreferenceStore& store, const Ways& ways, QWidget* parent);

    void showPage(PreferencePage page);
    void search(const QString& words);

    /// Without asking for the file.
    void exportTo(const QString& file);
    void importFrom(const QString& file);

private:
    /// A setting with all that stands there for it.
    struct Row {
        const PreferenceRow* setting;
        QWidget* editor;
        QList<QWidget*> parts;
        std::function<void()> show;
        QWidget* restart = nullptr; ///< shown while what is set does not hold yet
    };
    /// What stands on a page beside its settings, and is found by the page's title only.
    struct Section {
        PreferencePage page;
        QWidget* box;
        QLabel* title;
        QList<QWidget*> more;
    };

    void build(const Ways& ways);
    QWidget* buildSections(const Ways& ways);
    QWidget* buildButtons();
    void addRow(QFormLayout& form, QWidget& box, const PreferenceRow& setting, const Ways& ways);
    QWidget* editorFor(const PreferenceRow& setting, QWidget& box, std::function<void()>& show);
    void addMore(QVBoxLayout& column, Section& section, const std::function<void()>& editKeys);
    void set(const PreferenceRow& setting, const QVariant& value);
    void showValues();
    void showWanted();
    void showMouse();
    PreferencePage page() const;

    PreferenceStore& m_store;
    QLineEdit* m_search;
    QListWidget* m_pages;
    ColumnScroll* m_scroll;
    QLabel* m_nothing;
    QLabel* m_mouse = nullptr;
    QPushButton* m_defaults = nullptr;
    std::vector<Row> m_rows;
    std::vector<Section> m_sections;
};

} // namespace bolster
