// Takes a damaged project apart, in a process that nobody minds losing. Private to the library and bolster-salvage.
#pragma once

#include "Salvage.h"

namespace bolster {

/// Where the work is done, and what its files are called in sentences.
struct SalvageWork {
    QString copy; ///< of the damaged file, with a head that is right
    QString name; ///< of the damaged file itself
    QString out;
    double seconds = 0; ///< of processor time after which nothing more is taken
};

/// In this process, with whatever the file does to it.
Salvaged salvageHere(const SalvageWork& work);

/// As it goes through the pipe. The other side may be anybody.
std::string bytesOf(const Salvaged& salvaged);
std::optional<Salvaged> salvagedFrom(std::string_view bytes);

} // namespace bolster
