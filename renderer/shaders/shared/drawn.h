// One thing that a view draws: which record, at which level of detail, and how much of it while it fades. In the copy
// of the record the flags of the instance take the slot's place.
#ifndef SHARED_DRAWN_H
#define SHARED_DRAWN_H

#define DRAWN_SLOT_MASK 0xffffffu // of the instance records
#define DRAWN_FLAGS_MASK 0xffu
#define DRAWN_PHASE_SHIFT 8       // of what sways, in a copy: 256ths of a turn
#define DRAWN_FLUTTER_SHIFT 16    // and of its leaves: 255ths of WIND_MOST_FLUTTER
#define DRAWN_LEVEL_SHIFT 24
#define DRAWN_LEVEL_MASK 7u
#define MOST_LEVELS 8             // of a model, the full one among them
#define DRAWN_FADE_SHIFT 27       // 0: whole; 1..15: that many sixteenths of the pixels; 16 + 1..15: the others
#define DRAWN_FADE_STEPS 16
#define DRAWN_FADE_OTHERS 16u

#endif
