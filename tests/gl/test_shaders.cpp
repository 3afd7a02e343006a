// Programs are rebuilt while they run, and a fault costs nothing but a message.
#include "renderer/shader_library.h"
#include "renderer/shader_source.h"
#include "tests/gl/support/shared_renderer.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {

class Shaders : public testing::Test {
protected:
    void SetUp() override
    {
        ASSERT_TRUE(test::haveContext());
        folder = fs::temp_directory_path() / ("wold-shaders-" + std::to_string(getpid()));
        fs::create_directories(folder / "shared");
        write("full_screen.vert.glsl", "void main() { gl_Position = vec4(0.0); }\n");
        write("shared/values.h", "#define VALUE 1.0\n");
        write("paint.frag.glsl", "// first line\n#include \"shared/values.h\"\nout vec4 c;\nvoid main() { c = vec4(VALUE); }\n");
    }
    void TearDown() override { fs::remove_all(folder); }

    void write(const std::string& name, const std::string& text)
    {
        std::ofstream{folder / name} << text;
        // Files of one test are written within one tick of the file system's clock.
        fs::last_write_time(folder / name, fs::file_time_type::clock::now() + std::chrono::seconds{++writes});
    }

    fs::path folder;
    int writes = 0;
};

TEST_F(Shaders, FaultKeepsTheLastGoodProgramAndIsNamed)
{
    renderer::ShaderLibrary library{folder};
    const renderer::gl::Program& program = library.fullScreen("paint");
    ASSERT_TRUE(program);
    ASSERT_TRUE(library.faults().empty());
    const GLuint good = program.id();

    write("paint.frag.glsl", "// first line\n#include \"shared/values.h\"\nout vec4 c;\nvoid main() { c = vec4(WRONG); }\n");
    library.reload();
    EXPECT_EQ(program.id(), good);
    ASSERT_EQ(library.faults().size(), 1u);
    EXPECT_EQ(library.faults()[0].where, (folder / "paint.frag.glsl").string() + ":4");
    EXPECT_NE(library.faults()[0].what.find("WRONG"), std::string::npos);

    write("paint.frag.glsl", "#include \"shared/values.h\"\nout vec4 c;\nvoid main() { c = vec4(VALUE * 0.5); }\n");
    library.reload();
    EXPECT_TRUE(library.faults().empty());
    EXPECT_TRUE(program);
    EXPECT_NE(program.id(), good);
}

TEST_F(Shaders, IncludesAreWatchedAndTheirLinesAreTheirOwn)
{
    renderer::ShaderLibrary library{folder};
    const renderer::gl::Program& program = library.fullScreen("paint");
    const GLuint good = program.id();
    write("shared/values.h", "#define VALUE 1.0\n\nfloat broken() { return ; }\n");
    library.reload();
    EXPECT_EQ(program.id(), good);
    ASSERT_FALSE(library.faults().empty());
    EXPECT_EQ(library.faults()[0].where, (folder / "shared/values.h").string() + ":3");
}

TEST_F(Shaders, MissingIncludeIsNamedWithItsPlace)
{
    write("paint.frag.glsl", "out vec4 c;\n#include \"shared/nowhere.h\"\nvoid main() { c = vec4(1.0); }\n");
    renderer::ShaderLibrary library{folder};
    EXPECT_FALSE(library.fullScreen("paint"));
    ASSERT_EQ(library.faults().size(), 1u);
    EXPECT_EQ(library.faults()[0].where, (folder / "paint.frag.glsl").string() + ":2");
}

TEST(ShaderSource, PlacesOfSeveralCompilers)
{
    const renderer::ShaderSource source{.text = "", .files = {"a.glsl", "b.h"}};
    EXPECT_EQ(renderer::placeOf(source, "1:12(5): error: something"), "b.h:12");
    EXPECT_EQ(renderer::placeOf(source, "0(7) : error C1008: undefined variable"), "a.glsl:7");
    EXPECT_EQ(renderer::placeOf(source, "ERROR: 1:3: 'x' : undeclared"), "b.h:3");
    EXPECT_EQ(renderer::placeOf(source, "no number at all"), "a.glsl");
}

} // namespace
