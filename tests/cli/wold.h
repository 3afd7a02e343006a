// The built program in an environment of its own: no display, a home that is thrown away.
#pragma once

#include "io/base/value.h"
#include "tests/support/program.h"
#include "tests/support/small_world.h"

#include <gtest/gtest.h>

namespace test {

Ran wold(std::vector<std::string> words, std::string input = {},
         std::vector<std::pair<std::string, std::string>> environment = {});

// stdout as JSON; fails the test when it is none.
io::Value json(const std::string& text);
double number(const io::Value& object, std::string_view key);
std::string text(const io::Value& object, std::string_view key);

// The promise for what is not the caller's fault, and for what is.
void expectFault(const Ran& ran, std::string_view named);  // 1, and the last line on stderr names this
void expectMisuse(const Ran& ran, std::string_view named); // 2

struct SmallWorld : testing::Test {
    Folder folder;
    std::string project = folder / "world";
    SmallWorld() { makeSmallWorld(project); }
};

} // namespace test
