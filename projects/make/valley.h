// The steps in which the valley is furnished. Each takes ground on the stage, so the order matters: what must stand
// where it stands comes first.
#pragma once

#include "projects/make/stage.h"

namespace make {

io::ObjectId setCamp(Stage& stage); // the group of what belongs to it
void smokeOverFire(Stage& stage, io::ObjectId camp);
io::Status addSounds(Stage& stage); // templates and files
void setSounds(Stage& stage);
void layRocks(Stage& stage);
void plantForest(Stage& stage);
void plantFarForest(Stage& stage);
void plantUndergrowth(Stage& stage);
void growGrass(Stage& stage);
void setViews(Stage& stage);

float forestAt(const Stage& stage, glm::vec2 p); // 0 open … 1 deep forest

} // namespace make
