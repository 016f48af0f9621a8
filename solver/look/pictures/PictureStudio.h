// Where pictures of one cover are taken: in its fabrics or with a map, one, turned, or all colourways on a sheet.
#pragma once

#include "PictureDirection.h"
#include "PictureLegend.h"
#include "PictureScene.h"

#include <variant>

namespace bolster {

/// What the scene depends on.
struct PictureLook {
    ElementId colourway = noElement; ///< noElement: the patches' own fabrics
    bool checker = false;            ///< instead of the fabrics, in their colours
    std::optional<CoverMap::Kind> map;
    bool sheet = false;  ///< all colourways, each as large as the options say, with their names
    bool refined = true; ///< else drawn at once, coarser
    bool frames = true;  ///< and foam, in their materials

    friend bool operator==(const PictureLook&, const PictureLook&) = default;
};

struct PictureOrder {
    PictureLook look;
    std::variant<PictureDirection, RayCamera> from;
    double turn = 0; ///< of the viewer around the cover, radians
    PreviewOptions options;
};

struct Picture {
    PreviewImage image;          ///< empty when it was cancelled
    std::optional<CoverMap> map; ///< what was measured for it
    std::string problem;         ///< of what is missing in it
};

/// Most pixels that a picture or a sheet may have.
constexpr std::int64_t mostPicturePixels = 64'000'000;
/// Pixels of the sheet of all colourways of a design; 0 when it has none.
std::int64_t sheetPixels(const Design& design, const PreviewOptions& options);

/// Keeps what the next picture can use again. Not to be used by two threads at once.
class PictureStudio {
public:
    /// What the legend of a map says, in the user's language. No function: pictures of maps have no legend.
    using Legend = std::function<PictureLegend(const CoverMap&)>;

    struct Subject {
        SurfaceMeshPtr surface;
        Design design;
        DesignFiles files;
        FabricBaker bake;   ///< for refined pictures
        FabricBaker atOnce; ///< for the others: null for what would take its time
        Legend legend;
    };

    explicit PictureStudio(Subject subject);
    ~PictureStudio();

    Picture draw(const PictureOrder& order, const std::stop_token& stop);

private:
    struct Stage;

    Stage staged(const PictureLook& look);
    Scene sceneOf(const PictureLook& look, const CoverMap* map);
    const Stage& stage(const PictureLook& look);
    static PreviewImage drawOne(const Stage& stage, const PictureOrder& order, const std::stop_token& stop);
    Picture drawSheet(const PictureOrder& order, const std::stop_token& stop);

    Subject m_subject;
    CoverMeshPtr m_cover, m_sewn;   ///< the same without and with its seams
    std::unique_ptr<Stage> m_stage; ///< the last one
    std::optional<std::vector<Scene::FrameLook>> m_frames;
};

} // namespace bolster
