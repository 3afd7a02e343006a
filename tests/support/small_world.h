// A world small enough to be made anew by every test: flat ground 64 m wide with a hill in a corner, five crates in a
// row along x, a post (a marker without a model), one camera that sees them and one path.
#pragma once

#include <filesystem>

namespace test {

// Crate i (id i + 1) stands at x = 4 * (i - 2), z = 0; the post has id 6. Aborts when it cannot be written.
void makeSmallWorld(const std::filesystem::path& folder);

} // namespace test
