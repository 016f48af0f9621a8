// What is not used any more, to the system.
#pragma once

namespace bolster {

/// What large objects have left lies between smaller ones that stay: the system gets it only when it is asked to.
/// Takes its time beside the GUI thread.
void giveMemoryBack();

} // namespace bolster
