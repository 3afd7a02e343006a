#include "editor/search_text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace editor {

std::string lowerCase(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, char>, 30> kBare{{
        {"á", 'a'}, {"č", 'c'}, {"ď", 'd'}, {"é", 'e'}, {"ě", 'e'}, {"í", 'i'}, {"ň", 'n'}, {"ó", 'o'},
        {"ř", 'r'}, {"š", 's'}, {"ť", 't'}, {"ú", 'u'}, {"ů", 'u'}, {"ý", 'y'}, {"ž", 'z'}, {"Á", 'a'},
        {"Č", 'c'}, {"Ď", 'd'}, {"É", 'e'}, {"Ě", 'e'}, {"Í", 'i'}, {"Ň", 'n'}, {"Ó", 'o'}, {"Ř", 'r'},
        {"Š", 's'}, {"Ť", 't'}, {"Ú", 'u'}, {"Ů", 'u'}, {"Ý", 'y'}, {"Ž", 'z'},
    }};
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const std::string_view two = text.substr(i, 2);
        char bare = 0;
        for (const auto& [accented, letter] : kBare)
            if (c < 0 && two == accented) bare = letter;
        if (bare) ++i;
        result += bare ? bare : c >= 'A' && c <= 'Z' ? char(c + 32) : c;
    }
    return result;
}

bool holds(std::string_view text, std::string_view lowered)
{
    return lowered.empty() || lowerCase(text).find(lowered) != std::string::npos;
}

bool holdsWords(std::string_view text, std::string_view lowered)
{
    const std::string all = lowerCase(text);
    while (!lowered.empty()) {
        const std::string_view word = lowered.substr(0, lowered.find(' '));
        if (all.find(word) == std::string::npos) return false;
        lowered.remove_prefix(std::min(word.size() + 1, lowered.size()));
    }
    return true;
}

} // namespace editor
