// Golden pictures: each entry of pictures.json is drawn and compared with pictures/NAME.png. A picture that is too far
// off leaves NAME.now.png and NAME.difference.png in the build folder.
#include "io/files/atomic_file.h"
#include "io/files/image_file.h"
#include "io/files/json.h"
#include "tests/golden/compare.h"
#include "tests/golden/valley.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path{WOLD_SOURCE_DIR} / "tests/golden";
const fs::path kOut = WOLD_GOLDEN_OUT;

struct Golden {
    std::string name, camera;
    renderer::Show show = renderer::Show::Final;
    double mean = 1, outliers = 0.005; // tolerances; drivers round differently at edges
};

std::string textOr(const io::Value& entry, std::string_view key, std::string otherwise)
{
    const io::Value* value = entry.find(key);
    return value ? *value->asString() : otherwise;
}

double numberOr(const io::Value& entry, std::string_view key, double otherwise)
{
    const io::Value* value = entry.find(key);
    return value ? *value->asNumber() : otherwise;
}

std::vector<Golden> readList()
{
    const auto text = io::readFile(kFolder / "pictures.json");
    EXPECTS(text);
    const auto list = io::parseJson(*text, "pictures.json");
    EXPECTS(list);
    std::vector<Golden> result;
    const auto names = enumNames(renderer::Show{});
    for (const io::Value& entry : *list->asArray()) {
        const auto show = std::find(names.begin(), names.end(), textOr(entry, "show", "final"));
        EXPECTS(show != names.end());
        result.push_back({textOr(entry, "name", ""), textOr(entry, "camera", ""), renderer::Show(show - names.begin()),
                          numberOr(entry, "mean", 1), numberOr(entry, "outliers", 0.005)});
    }
    return result;
}

io::Image draw(const Golden& golden)
{
    valley().renderer().render({.camera = valley().camera(golden.camera), .size = {480, 270}, .show = golden.show});
    return valley().renderer().readPicture();
}

void check(const Golden& golden, const io::Image& now)
{
    const fs::path file = kFolder / "pictures" / (golden.name + ".png");
    if (std::getenv("WOLD_GOLDEN_UPDATE")) {
        ASSERT_TRUE(io::writeImage(file, now));
        return;
    }
    const auto kept = io::readImage(file);
    ASSERT_TRUE(kept) << kept.error().text() << "; tests/golden/update draws it";
    ASSERT_EQ(kept->size, now.size);
    const Difference difference = compare(*kept, now);
    if (difference.mean <= golden.mean && difference.outliers <= golden.outliers) return;
    const fs::path seen = kOut / (golden.name + ".now.png"), off = kOut / (golden.name + ".difference.png");
    EXPECT_TRUE(io::writeImage(seen, now));
    EXPECT_TRUE(io::writeImage(off, difference.picture));
    ADD_FAILURE() << golden.name << ": mean " << difference.mean << " (at most " << golden.mean << "), outliers "
                  << difference.outliers << " (at most " << golden.outliers << "); see " << seen << " and " << off;
}

TEST(GoldenPictures, valleyLooksAsItDid)
{
    fs::create_directories(kOut);
    for (const Golden& golden : readList())
        check(golden, draw(golden));
    EXPECT_EQ(valley().renderer().glErrors(), 0u);
}

} // namespace
} // namespace test
