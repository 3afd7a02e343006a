// The trees that grow in our worlds: three broadleaves and a fir, at several ages.
#pragma once

#include "projects/make/trees.h"

namespace make {

TreeShape oak();
TreeShape oakYoung();
TreeShape oakOld();
TreeShape birch();
TreeShape birchYoung();
TreeShape birchOld();
TreeShape beech();
TreeShape beechYoung();
TreeShape beechOld();
TreeShape inAutumn(TreeShape shape, const char* leaf, std::uint64_t seed);
FirShape firOf(std::uint64_t seed, float height, float radius, float crown, int branches, float base);

} // namespace make
