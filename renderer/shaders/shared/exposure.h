// Automatic exposure: how the picture is measured, and what came of it.
#ifndef SHARED_EXPOSURE_H
#define SHARED_EXPOSURE_H
#include "shared.h"

#define EXPOSURE_BINS 256
#define EXPOSURE_DARKEST -24.0f  // log2 of luminance, of the first bin
#define EXPOSURE_BRIGHTEST 16.0f // of the end of the last
#define EXPOSURE_WIDTH 192       // places that are looked at, along the picture and across
#define EXPOSURE_HEIGHT 108

SHARED_BEGIN

struct Metering {
    float compensation; float lowest; // EV
    float highest;      float share;  // EV; share of the way to go in this frame, 1: all of it
    float darkness;     float unused0; // share that stays of what the picture is darker than by day
    float unused1;      float unused2;
};
SHARED_STRUCT_END(Metering, 32)

struct ChosenExposure {
    float exposure; float before; // factors, 2^EV: of this frame, and of the one before it
    float ev;       float target; // of this frame; of which it would be without time to adapt
};
SHARED_STRUCT_END(ChosenExposure, 16)

SHARED_END
#endif
