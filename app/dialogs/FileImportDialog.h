// Asks what the numbers in a mesh or scan file mean, and shows the size that follows.
#pragma once

#include "FileContent.h"
#include "FileGuess.h"

#include <QDialog>

#include <optional>

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;

namespace bolster {

class NumberBox;
class PartsTree;
class SimplifyChoice;

class FileImportDialog : public QDialog {
    Q_OBJECT

public:
    /// `replaced`: where the element stands that gets this content; kept unless the user wants another place. What
    /// the file has `said` of its numbers is chosen, the rest is guessed.
    FileImportDialog(const QString& file, FileContent content, std::optional<Placement> replaced = {},
                     const FileFacts& said = {}, QWidget* parent = nullptr);

    /// Parts of a mesh can be left out; those with an `unwanted` name are so from the start. `tree`: to what they
    /// belong, if the file says it.
    void offerParts(std::vector<PartOutline> tree, const std::vector<std::string>& unwanted);

    /// The largest size (mm) of what was there before. Where the kept scale would make something else of it and the
    /// unit that the file says would not, the file's unit is taken and only position and rotation are kept.
    void replaces(double largest);
    /// What is odd about the file.
    void warn(const QString& text);

    /// As chosen.
    Placement placement() const;
    /// Names of parts that are not to be there.
    std::vector<std::string> unwantedParts() const;
    /// About how many triangles a large mesh is to have; nothing: as it is.
    std::optional<std::size_t> wantedTriangles() const;
    void setUnit(FileUnit unit);
    void setUpAxis(UpAxis up);

    void accept() override;

private:
    QString aboutText(const QString& file) const;
    void layOut(const QString& file);
    void connectFields();
    void choose(const QString& file, const FileFacts& said);
    void sayGuesses();
    QString saidText(const QString& file, const FileFacts& said) const;
    void updateSize();
    std::vector<bool> wantedParts() const;
    void takeColors(const std::vector<PartOutline>& tree);
    void updateShown();
    void updatePicture();
    void showThinning();
    double largestSize() const; ///< mm: what is usual
    double largestWith(double scale) const;
    QString oddity(double largest) const;

    FileContent m_content;
    std::vector<Vec3> m_shown; ///< file units: points of the parts that are wanted
    QLabel* m_picture;
    QHBoxLayout* m_besidePicture;
    std::vector<std::uint32_t> m_colors; ///< 0xRRGGBB of each part of the mesh; empty: no part has one
    PartsTree* m_parts = nullptr;
    SimplifyChoice* m_simplify = nullptr;
    std::optional<Placement> m_replaced;
    std::optional<double> m_saidUnit; ///< mm
    bool m_unitIsGuess = false, m_axesAreGuess = false;
    double m_oldSize = 0; ///< mm; 0: unknown
    QCheckBox* m_keep;
    QComboBox* m_unit;
    NumberBox* m_factor;
    QComboBox* m_up;
    QCheckBox* m_onFloor;
    QLabel* m_said;
    QLabel* m_size;
    QLabel* m_hint;
    QLabel* m_warning;
    QLabel* m_thinned; ///< why there are fewer points than in the file
};

} // namespace bolster
