#include "app/fonts.h"

#include <fontconfig/fontconfig.h>
#include <initializer_list>
#include <memory>
#include <strings.h>

namespace app {
namespace {

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
constexpr FcChar32 kCzech = 0x011b; // e with caron

Pattern match(const char* family, int weight)
{
    const Pattern wanted{FcPatternCreate(), FcPatternDestroy};
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
    FcPatternAddInteger(wanted.get(), FC_WEIGHT, weight);
    FcPatternAddInteger(wanted.get(), FC_SLANT, FC_SLANT_ROMAN);
    FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    return {FcFontMatch(nullptr, wanted.get(), &result), FcPatternDestroy};
}

bool isOf(FcPattern* font, const char* family)
{
    FcChar8* name = nullptr;
    for (int i = 0; FcPatternGetString(font, FC_FAMILY, i, &name) == FcResultMatch; ++i)
        if (strcasecmp(reinterpret_cast<const char*>(name), family) == 0) return true;
    return false;
}

bool hasCzech(FcPattern* font)
{
    FcCharSet* letters = nullptr;
    return FcPatternGetCharSet(font, FC_CHARSET, 0, &letters) == FcResultMatch && FcCharSetHasChar(letters, kCzech);
}

// fontconfig always answers something: a name that begins with "sans" or "mono" may be answered by any family.
std::filesystem::path fileOf(const char* family, int weight, bool any)
{
    const Pattern font = match(family, weight);
    FcChar8* file = nullptr;
    int index = 0;
    if (!font || FcPatternGetString(font.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
    if (FcPatternGetInteger(font.get(), FC_INDEX, 0, &index) == FcResultMatch && index != 0)
        return {}; // of a collection
    if (!hasCzech(font.get()) || (!any && !isOf(font.get(), family))) return {};
    return reinterpret_cast<const char*>(file);
}

std::filesystem::path firstOf(std::initializer_list<const char*> families, const char* anyOf, int weight)
{
    for (const char* family : families)
        if (auto file = fileOf(family, weight, false); !file.empty()) return file;
    return fileOf(anyOf, weight, true);
}

} // namespace

editor::FontFiles findFonts()
{
    return {.regular = firstOf({"Inter", "DejaVu Sans", "Noto Sans"}, "sans-serif", FC_WEIGHT_REGULAR),
            .bold = firstOf({"Inter", "DejaVu Sans", "Noto Sans"}, "sans-serif", FC_WEIGHT_SEMIBOLD),
            .mono = firstOf({"DejaVu Sans Mono", "Noto Sans Mono"}, "monospace", FC_WEIGHT_REGULAR)};
}

} // namespace app
