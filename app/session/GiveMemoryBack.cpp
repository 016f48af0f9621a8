#include "GiveMemoryBack.h"

#include "Background.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace bolster {

void giveMemoryBack()
{
#ifdef __GLIBC__
    backgroundPool().start([] { malloc_trim(0); });
#endif
}

} // namespace bolster
