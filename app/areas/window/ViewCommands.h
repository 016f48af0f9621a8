// Where the views look, and what they leave out.
#pragma once

#include <QCoreApplication>
#include <QObject>

namespace bolster {

class Commands;
class Document;
class ElementsView;
class PatternView;
class PreferenceStore;
class Selection;
class StatusLine;
class CoverView;

class ViewCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(ViewCommands)

public:
    ViewCommands(Commands& commands, Document& document, Selection& selection, PatternView& pattern,
                 CoverView& coverView, ElementsView& elements, StatusLine& status, PreferenceStore& preferences);

    /// What is selected fills both views.
    void fitSelection();

private:
    void addFitting(Commands& commands);
    void addStandardViews(Commands& commands);
    void addCamera(Commands& commands);
    void addHiding(Commands& commands);
    void addThemes(Commands& commands);
    void addOpacities(Commands& commands);
    void hideSelected();

    Document& m_document;
    Selection& m_selection;
    PatternView& m_pattern;
    CoverView& m_coverView;
    ElementsView& m_elements;
    StatusLine& m_status;
    PreferenceStore& m_preferences;
};

} // namespace bolster
