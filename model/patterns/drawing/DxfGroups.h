// DXF as a row of groups, each a code and a value: of text, and of AutoCAD's binary form. Private to the library.
#pragma once

#include "FileBytes.h"

#include <memory>
#include <optional>
#include <string_view>

namespace bolster {

struct DxfGroup {
    int code = 0;
    std::string_view words;       ///< as it stands there; empty for numbers of a binary file
    std::optional<double> number; ///< of a binary file
};

class DxfGroups {
public:
    virtual ~DxfGroups() = default;
    /// False at the end of the file.
    virtual bool next(DxfGroup& group) = 0;
    /// Of what was read last.
    virtual FilePlace place() const = 0;

protected:
    /// Throws FileRefused when there are more than any drawing needs, ImportStopped when somebody asks for that.
    void count(const ImportWatch& watch, double done);

private:
    std::size_t m_groups = 0;
};

/// `file` and `watch` must stay. Throws FileRefused.
std::unique_ptr<DxfGroups> dxfGroups(std::string_view file, const ImportWatch& watch);

/// The number of a group. Refuses what is none, or too large to be a coordinate.
double numberOf(const DxfGroup& group, const FilePlace& place);

} // namespace bolster
