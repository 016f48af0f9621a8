// What the menus do with patches and points of the pattern: clipboard, layout, corners, merging.
#pragma once

#include "EditOutcome.h"

#include <QObject>

#include <optional>
#include <string>
#include <vector>

namespace bolster {

class Commands;
class Document;
class Selection;

class PatternCommands : public QObject {
    Q_OBJECT

public:
    PatternCommands(Document& document, Selection& selection, Commands& commands, QObject* parent = nullptr);

signals:
    /// The length of the selected edge is to be typed.
    void edgeLengthWanted();
    /// What could not be done, or what it has cost, in the user's words.
    void said(const QString& message);

private:
    void addClipboard(Commands& commands);
    void addTurns(Commands& commands);
    void addAlignment(Commands& commands);
    void addPoints(Commands& commands);
    void addEdges(Commands& commands);
    bool hasPoints(bool corner) const;

    void copy();
    void cut();
    void paste();
    void duplicate();
    void turn(double degrees);
    void mirror(bool horizontally);
    void makeCorners(bool corner);
    void straighten();
    void equalise();
    void smoothSeamEnds();
    void merge();
    /// Commits it and says what it drops, or why there is none.
    bool commit(const edits::Outcome& outcome);
    bool commit(const Edit& edit) { return commit(edits::Outcome{edit, {}, {}}); }
    std::vector<ElementId> selected() const;
    std::vector<ElementId> patches() const;
    std::optional<ElementId> seamToMerge() const;

    Document& m_document;
    Selection& m_selection;
    std::string m_clip; ///< what was copied or pasted last
    int m_pastes = 0;   ///< how many times: each one lies a step further
};

} // namespace bolster
