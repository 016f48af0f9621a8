// Which form a pattern is made of, where that is cut, and what becomes of what is there already.
#pragma once

#include "FormPatternJob.h"

#include <QVariant>
#include <QWidget>

#include <map>
#include <memory>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace bolster {

class DesignSession;
class Document;
class FileChoice;
class NumberBox;
class SeamLineList;
class SolverLink;

/// What it was filled in with, to be filled in again.
struct FormPatternWishes {
    bool known = false; ///< else what is usual counts
    QVariant form, fabric;
    QString file;
    int grain = 0;
    std::vector<bool> ticks;                      ///< of the ways it is cut, and of what keeps the cover outside
    double angle = 0;                             ///< degrees
    std::map<quint32, Qt::CheckState> lines = {}; ///< by their numbers
};

class FormWishesPanel : public QWidget {
    Q_OBJECT

public:
    FormWishesPanel(DesignSession& session, SolverLink& solver, QWidget* parent = nullptr);

    /// As it was, as far as that is still there.
    void fillIn(const FormPatternWishes& wishes);
    FormPatternWishes wishes() const;

    /// Empty when the form is none.
    QString file() const;
    /// That is the form; else null.
    const Frame* frame() const;
    ElementId frameId() const;
    ElementPtr frameElement() const;
    /// As it keeps the cover outside.
    ElementPtr frameUnder() const;
    /// Of the form, mm; null when there is none, or a file has it.
    std::shared_ptr<const TriangleMesh> mesh() const;
    Fabric fabric() const;
    bool divides() const;
    /// How it is cut, and what of; whoever asks for it adds the rest.
    FormWanted wanted() const;

    /// The frame does, or will when the pattern is made.
    bool keepsOutside() const;
    /// What is there already goes.
    bool replaces() const;
    /// What a pattern leaves to be chosen; null: nothing.
    void offer(const FormPattern* pattern);
    /// The same, when only the frame may have changed.
    void offerOutside(const FormPattern& pattern);

    /// Lines that end inside a piece; null: it is not known yet whether there are such.
    void offerToLeadOn(const Form* form);
    /// The ticked line that ends nearest to a place; none where none ends near it.
    ElementId lineEndingAt(const Vec3& place) const;

    /// Of the design as it is now.
    void refillLines();
    void refillWaysToCut();

signals:
    void formChosen();
    void changed();
    void outsideChanged();
    void leadOnWanted();

private:
    void build();
    void buildWaysToCut(QVBoxLayout& rows);
    void buildOffers(QVBoxLayout& rows);
    void fillForms();
    void fillFabrics();
    int largestOf(int frames) const;
    void tickLines();
    bool isCover() const;
    QString cadFile() const;
    FormGrain grain() const;
    std::vector<QCheckBox*> boxes() const;
    void offerToReplace(const FormPattern& pattern);
    void sayWhatIsFreed();

    DesignSession& m_session;
    Document& m_document;
    SolverLink& m_solver;
    FileChoice* m_form = nullptr;
    QComboBox *m_fabric = nullptr, *m_grain = nullptr;
    QCheckBox *m_groups = nullptr, *m_faces = nullptr, *m_bends = nullptr, *m_divide = nullptr,
              *m_outside = nullptr, *m_replace = nullptr;
    NumberBox* m_angle = nullptr;
    SeamLineList* m_lines = nullptr;
    QPushButton* m_leadOn = nullptr;
    QLabel* m_replaceNote = nullptr;
    int m_freed = 0;               ///< curves that hold nothing when patches are replaced
    bool m_linesElsewhere = false; ///< than on the form
};

} // namespace bolster
