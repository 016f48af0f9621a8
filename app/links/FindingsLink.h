// Looks the cover over whenever it has come to rest, beside the GUI thread.
#pragma once

#include "CoverFindings.h"
#include "LatestJob.h"

namespace bolster {

class DesignSession;
class SolverLink;

class FindingsLink : public QObject {
    Q_OBJECT

public:
    FindingsLink(DesignSession& session, SolverLink& solver, QObject* parent = nullptr);
    ~FindingsLink() override;

    /// The cover that is shown is at rest and has been looked over.
    bool known() const { return m_known; }
    /// What matters most first; those of the cover before while it is not known.
    const std::vector<CoverFinding>& findings() const { return m_findings; }

signals:
    void changed();

private:
    struct Request {
        SurfaceMeshPtr surface;
        Design design;
        DesignFiles files;
    };
    struct Result {
        SurfaceMeshPtr surface;
        std::vector<CoverFinding> findings;
    };

    void look();
    void receive(Result result);

    DesignSession& m_session;
    SolverLink& m_solver;
    std::vector<CoverFinding> m_findings;
    SurfaceMeshPtr m_asked;            ///< for this surface
    std::uint64_t m_askedRevision = 0; ///< of this design: limits of fabrics ask for no other surface
    bool m_known = false;
    LatestJob<Request, Result> m_job; ///< last: it uses the others
};

} // namespace bolster
