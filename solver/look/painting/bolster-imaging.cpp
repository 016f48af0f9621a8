// The module that answers what Imaging.h asks.
#include "EncodePicture.h"
#include "PaintFabric.h"

extern "C" __attribute__((visibility("default"))) const bolster::Imaging* bolsterImaging()
{
    static const bolster::Imaging all{&bolster::paintedFabric, &bolster::encodedPicture, &bolster::drawnText};
    return &all;
}
