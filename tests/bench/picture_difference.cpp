// How far two pictures of one size differ. usage: picture_difference A.png B.png; prints the mean and the largest
// difference of a channel, of 255, as JSON.
#include "io/files/image_file.h"

#include <cstdio>
#include <cstdlib>

int main(int count, char** words)
{
    if (count != 3) return std::puts("usage: picture_difference A.png B.png"), 2;
    const auto a = io::readImage(words[1]), b = io::readImage(words[2]);
    for (const auto* image : {&a, &b})
        if (!*image) return std::fprintf(stderr, "picture_difference: %s\n", image->error().text().c_str()), 1;
    if (a->size != b->size || a->channels != b->channels || a->type != io::PixelType::U8 || b->type != a->type)
        return std::fprintf(stderr, "picture_difference: the pictures are not of one size and kind\n"), 1;
    double sum = 0;
    int largest = 0;
    for (std::size_t i = 0; i < a->bytes.size(); ++i) {
        const int difference = std::abs(int(a->bytes[i]) - int(b->bytes[i]));
        sum += difference;
        largest = std::max(largest, difference);
    }
    std::printf("{\"mean\": %.4f, \"largest\": %d}\n", sum / double(a->bytes.size()), largest);
}
