// The folder of a sweep: what was asked for, and the samples that are solved so far.
#pragma once

#include "JobFolder.h"
#include "Sweep.h"

#include <QString>

#include <optional>

namespace bolster::cli {

/// What is read of `--spec`.
struct SweepSpec {
    Tolerances tolerances;
    std::optional<double> limitDistance; ///< mm: of what 95 % of a cover do not exceed
    std::optional<double> limitStrain;   ///< 1: of what 99 % of it do not exceed
    std::string drawn;                   ///< everything of it that samples follow from, as text
};

/// docs/command-line.md has the keys. Throws UsageError, with the place.
SweepSpec readSweepSpec(const QString& path, const Design& design);

/// Samples in files of some dozens each, so that a sweep that was ended goes on where it was.
class SweepFolder {
public:
    static constexpr int samplesOfPart = 20;

    /// `asked`: what each sample follows from; another one than that of the files that are there already is a
    /// problem. Of another number of `samples` those that are there count.
    SweepFolder(const QString& path, const std::string& asked, int samples);

    /// Makes the folder, or says why not.
    Message open() const;
    int parts() const { return (m_samples + samplesOfPart - 1) / samplesOfPart; }
    std::uint64_t firstOf(int part) const { return static_cast<std::uint64_t>(part) * samplesOfPart; }
    int countOf(int part) const { return std::min(samplesOfPart, m_samples - part * samplesOfPart); }
    QString file(const QString& name) const { return m_folder.file(name); }

    bool has(int part, std::size_t vertices) const;
    Message write(int part, const std::vector<SweepSample>& samples) const;
    /// Empty when the file is not there, or is not what was written.
    std::vector<SweepSample> read(int part, std::size_t vertices) const;

private:
    QString partFile(int part) const;

    JobFolder m_folder;
    int m_samples;
};

} // namespace bolster::cli
