// File > Render: a picture of the cover as a customer should see it.
#pragma once

#include "Camera.h"
#include "LatestJob.h"
#include "PictureFile.h"
#include "PictureStudio.h"

#include <QDialog>
#include <QTimer>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace bolster {

class RunningJob;

class RenderDialog : public QDialog {
    Q_OBJECT

public:
    struct Subject {
        SurfaceMeshPtr surface;
        Design design;
        DesignFiles files;
        FabricBaker bake;
        FabricBaker bakedByNow; ///< for the first, coarse preview
        QString title;
        Camera view;        ///< that of the window
        QString proposal{}; ///< the file that is proposed
    };

    explicit RenderDialog(Subject subject, QWidget* parent = nullptr);
    ~RenderDialog() override;

    /// Draws and writes what is chosen. Goes on in the background; `rendered` says how it ended.
    void renderTo(const QString& path);
    bool rendering() const { return m_rendering; }

signals:
    void previewed();
    /// `problem` is "" when the picture is written.
    void rendered(const QString& problem);

protected:
    void reject() override; ///< while a picture is drawn, gives that up

private:
    struct Request {
        PictureOrder picture;
        std::string path;  ///< "": only to look at
        int turntable = 1; ///< pictures, each with its number in the name
        PictureFormat format = PictureFormat::Png;
        PictureNotes notes;
    };
    struct Result {
        PreviewImage image; ///< the last one
        bool toFile = false;
        bool rough = false;
        std::string problem;
    };

    static Result drawn(PictureStudio& studio, const Request& request, const std::stop_token& stop);

    void build();
    void buildChoices();
    QSpinBox* sideBox(int pixels);
    QFormLayout* buildForm();
    void addMessages(QVBoxLayout& layout);
    QDialogButtonBox* buildButtons();
    void fillShown();
    const PictureLook& chosenLook() const;
    Request request(QSize size) const;
    QString sizeProblem() const;
    /// Of a look that was not seen yet a rough picture comes first.
    void requestPreview();
    void receive(const Result& result);
    void choosePath();
    QString whereItIs() const;
    void setRendering(bool rendering);

    Subject m_subject;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QComboBox* m_view;
    QComboBox* m_samples;
    QComboBox* m_shown;
    QSpinBox* m_turntable;
    QCheckBox* m_frames;
    QCheckBox* m_transparent;
    QLabel* m_picture;
    QLabel* m_message;
    QProgressBar* m_progress;
    QPushButton* m_render;
    QPushButton* m_close; ///< cancels the picture while one is drawn
    QTimer m_pause;       ///< before a preview, so that typing a number costs one
    bool m_rendering = false;
    std::unique_ptr<RunningJob> m_running; ///< of the picture that is drawn to a file
    QString m_written;                     ///< the file that is drawn, or was; of several the first
    std::vector<PictureLook> m_looks;      ///< in the order of the list
    std::vector<PictureLook> m_seen;       ///< as rough pictures
    LatestJob<Request, Result> m_job;      ///< last: it uses the others
};

} // namespace bolster
