// Small worlds in memory that the editor's tests work on.
#pragma once

#include "editor/document.h"
#include "editor/picker.h"
#include "editor/random.h"

#include <memory>
#include <string>

namespace test {

// A triangle with a front side only, a box, a sphere-like blob and a card with a hole in its alpha.
io::Model pyramid(float size, bool doubleSided = false);
io::Model blob(float radius, int rings);
io::Model leafCard(float size); // two crossed cards; their image is opaque in a disc only

std::shared_ptr<const io::HeightMap> hills(int size, double metresPerTexel, std::uint64_t seed);
std::shared_ptr<const io::HeightMap> flat(int size, float height);

// Templates "pyramid", "blob", "leaf", "marker" and `count` objects of them, ids 1..count, scattered over 400 m.
std::unique_ptr<editor::Document> forest(int count, std::uint64_t seed, bool withGround = true);

// As the renderer would look at it.
editor::Picker& followed(editor::Picker& picker, editor::Document& document);

io::Transform randomTransform(editor::Random& random, double extent);
std::string text(const io::Scene& scene); // as its file would read

} // namespace test
