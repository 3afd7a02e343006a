// make_small_world DIR: for tests that are scripts.
#include "tests/support/small_world.h"

int main(int count, char** words)
{
    if (count != 2) return 2;
    test::makeSmallWorld(words[1]);
    return 0;
}
