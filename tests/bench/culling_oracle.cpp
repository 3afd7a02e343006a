// Asks the oracle of culling (tests/gl/support/culling_oracle.h) about many random cameras; the counts go to stdout as JSON,
// what is missing to stderr. usage: culling_oracle [--cameras N] [--sizes WxH,WxH] [--objects N] [--seed N]
// Ends with 1 when anything is missing.
#include "io/files/json.h"
#include "tests/bench/clock.h"
#include "tests/gl/support/culling_oracle.h"

#include <CLI/CLI.hpp>
#include <cstdio>

namespace {

struct Words {
    int cameras = 1000, objects = 10'000;
    unsigned seed = 1;
    std::vector<std::string> sizes{"1920x1080", "1281x719", "333x777"};
};

void tell(const test::Missing& m)
{
    const io::Camera& c = m.camera;
    std::fprintf(stderr, "missing, %s: id %u, which owns %u pixels, from %.6f,%.6f,%.6f,%.4f,%.4f,%.4f\n", m.how, m.id, m.pixels,
                 c.eye.x, c.eye.y, c.eye.z, double(c.yaw), double(c.pitch), double(c.fov));
}

io::Value::Object figuresOf(const test::OracleCounts& counts)
{
    const double cameras = double(std::max<std::uint64_t>(counts.cameras, 1));
    return {{"cameras", counts.cameras},
            {"ids_compared", counts.ids},
            {"ids_missing", counts.missing()},
            {"missing_cpu", counts.cpuMissing},
            {"missing_gpu_after_cut", counts.gpuCutMissing},
            {"missing_gpu", counts.gpuMissing},
            {"drawn_by_cpu", double(counts.drawn) / cameras},
            {"drawn_by_gpu", double(counts.gpuDrawn) / cameras},
            {"too_small", double(counts.tooSmall) / cameras}};
}

int run(const Words& words)
{
    if (!test::haveContext()) return 1;
    test::TestWorld world = test::oracleWorld(words.objects);
    test::load(world);
    const double start = bench::wallMs();
    std::uint64_t cameras = 0, ids = 0, missing = 0;
    io::Value::Array sizes;
    for (const std::string& text : words.sizes) {
        glm::ivec2 size{0};
        if (std::sscanf(text.c_str(), "%dx%d", &size.x, &size.y) != 2 || size.x < 1 || size.y < 1)
            return std::fprintf(stderr, "culling_oracle: --sizes %s: write 1280x720\n", text.c_str()), 2;
        std::mt19937 random{words.seed};
        test::OracleCounts counts;
        for (int i = 0; i < words.cameras; ++i)
            test::askOracle(test::cameraIn(world, random), size, counts, tell);
        cameras += counts.cameras, ids += counts.ids, missing += counts.missing();
        io::Value::Object row = figuresOf(counts);
        row.insert(row.begin(), {"size", text});
        sizes.emplace_back(std::move(row));
    }
    const io::Value figures = io::Value::Object{{"objects", words.objects},
                                                {"cameras", cameras},
                                                {"ids_compared", ids},
                                                {"ids_missing", missing},
                                                {"sizes", std::move(sizes)},
                                                {"seconds", (bench::wallMs() - start) / 1e3},
                                                {"gl_errors", test::shared().glErrors()},
                                                {"gl_renderer", test::shared().deviceName()}};
    std::puts(io::writeJson(figures).c_str());
    return missing == 0 ? 0 : 1;
}

} // namespace

int main(int count, char** arguments)
{
    Words words;
    CLI::App line{"what owns a pixel while nothing is culled, and is missing while things are"};
    line.add_option("--cameras", words.cameras, "of each size")->check(CLI::PositiveNumber);
    line.add_option("--sizes", words.sizes)->delimiter(',');
    line.add_option("--objects", words.objects)->check(CLI::PositiveNumber);
    line.add_option("--seed", words.seed);
    CLI11_PARSE(line, count, arguments);
    return run(words);
}
