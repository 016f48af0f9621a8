// The pattern of a form, beside the window.
#pragma once

#include "CoverFindings.h"
#include "Division.h"
#include "FileGuess.h"
#include "Flatten.h"
#include "FormPattern.h"
#include "Frame.h"
#include "FrameEdges.h"
#include "SolveInput.h"

#include <QDateTime>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace bolster {

struct FormWanted {
    int number = 0;
    std::shared_ptr<const TriangleMesh> mesh; ///< mm; null: that of the file
    QString file;                             ///< its unit and axes are guessed where it does not say them
    Box3 there = {};                          ///< mm, of the cover: what lies there is taken as it lies
    std::optional<Frame> frame = {};          ///< the mesh is of, as it stands
    QString cadFile = {};                     ///< at the edges of whose faces the form is cut, too; "": of none
    FormCuts cuts;
    bool divide = false; ///< it is cut wherever it would not lie flat, too, but for drafts
    FormPatternOrder order;
    bool draft = false; ///< something moves: nearly right, soon
    DivisionProgress progress = {};
};

struct FormMade {
    int number = 0;
    bool draft = false;
    Message problem;
    std::optional<Vec3> size; ///< mm, of the form of a file
    Form form;
    std::vector<FlatPiece> flat;
    FormPattern pattern;
};

/// Knows what was read and drafted last, so that it need not be read and cut again while something moves.
class FormPatternJob {
public:
    FormMade make(const FormWanted& wanted, const std::stop_token& stop);

private:
    /// As it was when it was read.
    struct FileState {
        QString path;
        QDateTime changed;
        friend bool operator==(const FileState&, const FileState&) = default;
    };
    struct FormOfFile {
        FileState state;
        std::shared_ptr<const TriangleMesh> mesh; ///< mm
        Placement placement;
        Message warning; ///< what is odd about the file
        FileFacts said;
        Box3 box; ///< file units
    };
    struct EdgesOfFile {
        FileState state;
        std::vector<FrameEdge> edges; ///< file units
    };

    /// Of a mesh with too many triangles.
    struct Thinned {
        std::shared_ptr<const TriangleMesh> of;
        std::size_t rows = 0; ///< of CAD faces' edges, which stay
        std::shared_ptr<const TriangleMesh> mesh;
        std::vector<Message> notes;
    };

    /// What took long, and is asked for again when who tries things goes back.
    struct Divided {
        std::shared_ptr<const TriangleMesh> of;
        FormCuts cuts;
        Fabric fabric;
        double edgeLength = 0;
        Form form;
    };

    static FileState stateOf(const QString& path);
    Message read(const QString& path, const Box3& there, const std::stop_token& stop);
    Message readEdges(const QString& path, const std::stop_token& stop);
    void addEdges(FormCuts& cuts, const std::optional<Frame>& frame) const;
    std::shared_ptr<const TriangleMesh> withFewTriangles(const std::shared_ptr<const TriangleMesh>& mesh,
                                                         const FormCuts& cuts, std::vector<Message>& notes,
                                                         const std::stop_token& stop);

    Form cutAndDivided(const std::shared_ptr<const TriangleMesh>& mesh, const FormCuts& cuts,
                       const FormWanted& wanted, const std::stop_token& stop);

    FormOfFile m_form;
    EdgesOfFile m_edges;
    Thinned m_thinned;
    std::vector<Divided> m_divided; ///< the last one last
    std::shared_ptr<FormDraft> m_draft = newFormDraft();
};

/// The cover of a pattern that was made of a form.
struct FormCoverWanted {
    int number = 0;
    SolveInput input;
    std::shared_ptr<const FormMade> of;
};

struct FormCover {
    int number = 0;
    bool atRest = false;
    std::vector<CoverFinding> findings; ///< cloth that is strained too much, or folds
    double beside = 0;                  ///< mm: how far it lies from the form at most
};

FormCover coverOfForm(const FormCoverWanted& wanted, const std::stop_token& stop);

} // namespace bolster
