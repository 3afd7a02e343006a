#include "shared/octahedron.h"
