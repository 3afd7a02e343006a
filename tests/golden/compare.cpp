#include "tests/golden/compare.h"

#include "io/base/contract.h"

#include <algorithm>
#include <cstdlib>

namespace test {

Difference compare(const io::Image& a, const io::Image& b)
{
    EXPECTS(a.size == b.size && a.type == io::PixelType::U8 && b.type == io::PixelType::U8);
    EXPECTS(std::min(a.channels, b.channels) >= 3);
    Difference result{.picture = {.size = a.size, .channels = 3, .type = io::PixelType::U8}};
    result.picture.bytes.resize(result.picture.rowBytes() * std::size_t(a.size.y));
    double sum = 0;
    std::size_t outliers = 0;
    for (int y = 0; y < a.size.y; ++y)
        for (int x = 0; x < a.size.x; ++x) {
            int furthest = 0;
            for (int c = 0; c < 3; ++c) {
                const int off =
                    std::abs(a.row<std::uint8_t>(y)[x * a.channels + c] - b.row<std::uint8_t>(y)[x * b.channels + c]);
                sum += off;
                furthest = std::max(furthest, off);
                result.picture.row<std::uint8_t>(y)[x * 3 + c] = std::uint8_t(std::min(255, off * 8));
            }
            outliers += furthest > kFar;
        }
    const double pixels = double(a.size.x) * a.size.y;
    result.mean = sum / (pixels * 3);
    result.outliers = double(outliers) / pixels;
    return result;
}

} // namespace test
