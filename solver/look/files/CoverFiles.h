// A cover as files for other programs, and for customers.
#pragma once

#include "CustomerPage.h"
#include "MakeCoverModel.h"
#include "Message.h"
#include "ObjFile.h"

#include <memory>

namespace bolster {

enum class CoverFormat {
    Glb,     ///< binary glTF
    Usdz,    ///< for the room view of phones
    Obj,     ///< with materials and pictures beside it
    Page,    ///< HTML
    Stl,     ///< as thick as the material
    ThreeMf, ///< the same
    FoamStl, ///< the body between frame and cover
    FoamThreeMf,
    FoamStep, ///< with fewer triangles
    Step      ///< fixation curves and seams
};

struct CoverFileOptions {
    std::string title;          ///< of the page
    std::string stem = "cover"; ///< of the names of files beside one
    bool frames = true;         ///< in models
    double thickness = 1.2;     ///< of the material, mm
    double foamEdge = 5;        ///< of the grid that foam is measured on, mm
    double foamDensity = 35;    ///< kg/m3
    PageParts page;
};

struct CoverFile {
    std::string bytes;
    std::vector<NamedFile> beside;
    Message problem;            ///< why there is none
    std::vector<Message> notes; ///< what there is to be said of it
};

/// Keeps what several formats have in common. Each thread at its turn.
class CoverFiles {
public:
    CoverFiles(ModelSubject subject, CoverFileOptions options);

    /// With the problem "interrupted" when it was stopped.
    CoverFile make(CoverFormat format, const std::stop_token& stop = {});

private:
    CoverFile made(CoverFormat format, const std::stop_token& stop);
    const CoverModel& model(bool small, const std::stop_token& stop);
    CoverFile solid(CoverFormat format) const;
    CoverFile foam(CoverFormat format, const std::stop_token& stop) const;
    CoverFile curves() const;

    ModelSubject m_subject;
    CoverFileOptions m_options;
    std::unique_ptr<const CoverModel> m_models[2]; ///< with large pictures, with small ones
};

} // namespace bolster
