// Whether a large frame shall have fewer triangles.
#pragma once

#include <QWidget>

#include <optional>

class QCheckBox;

namespace bolster {

class NumberBox;

class SimplifyChoice : public QWidget {
    Q_OBJECT

public:
    /// Meshes with fewer triangles need no choice.
    static constexpr std::size_t fewest = 20'000;

    explicit SimplifyChoice(std::size_t triangles, QWidget* parent = nullptr);

    /// About so many triangles; nothing: as it is.
    std::optional<std::size_t> wanted() const;

private:
    QCheckBox* m_on;
    NumberBox* m_triangles;
};

} // namespace bolster
