#include "io/files/text.h"

#include "io/base/contract.h"

#include <charconv>
#include <cmath>

namespace io {
namespace {

// Bytes of the valid UTF-8 sequence at the start of `text`; 0 when it is broken (RFC 3629: no surrogates,
// no overlong forms, nothing above U+10FFFF).
std::size_t sequenceLength(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
    const unsigned lead = byte(0);
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead <= 0xDF) return follows(1) ? 2 : 0;
    if (lead >= 0xE0 && lead <= 0xEF) {
        const bool inRange = lead == 0xE0 ? byte(1) >= 0xA0 : lead == 0xED ? byte(1) <= 0x9F : true;
        return inRange && follows(1) && follows(2) ? 3 : 0;
    }
    if (lead >= 0xF0 && lead <= 0xF4) {
        const bool inRange = lead == 0xF0 ? byte(1) >= 0x90 : lead == 0xF4 ? byte(1) <= 0x8F : true;
        return inRange && follows(1) && follows(2) && follows(3) ? 4 : 0;
    }
    return 0;
}

void appendEscaped(std::string& out, char c)
{
    constexpr char kHex[] = "0123456789abcdef";
    switch (c) {
    case '"':
        out += "\\\"";
        break;
    case '\\':
        out += "\\\\";
        break;
    case '\n':
        out += "\\n";
        break;
    case '\r':
        out += "\\r";
        break;
    case '\t':
        out += "\\t";
        break;
    default:
        out += "\\u00";
        out += kHex[(c >> 4) & 15];
        out += kHex[c & 15];
    }
}

bool plain(char c)
{
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x20 && byte < 0x7F && c != '"' && c != '\\';
}

// 100000 rather than 1e+05, which some readers do not take for an integer.
bool appendedWhole(std::string& out, double value)
{
    constexpr double kExact = 9007199254740992; // 2^53
    if (std::abs(value) > kExact || value != std::trunc(value)) return false;
    char digits[32];
    out.append(digits, std::to_chars(digits, digits + sizeof digits, static_cast<long long>(value)).ptr);
    return true;
}

} // namespace

void appendNumber(std::string& out, double value)
{
    EXPECTS(std::isfinite(value));
    if (appendedWhole(out, value)) return;
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    out.append(digits, end);
}

void appendNumber(std::string& out, float value)
{
    EXPECTS(std::isfinite(value));
    if (appendedWhole(out, double(value))) return;
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    // Readers parse a double and round it once more, which for a few floats is not the value we started from.
    double back = 0;
    std::from_chars(digits, end, back);
    if (float(back) != value) return appendNumber(out, double(value));
    out.append(digits, end);
}

void appendString(std::string& out, std::string_view text)
{
    out += '"';
    while (!text.empty()) {
        std::size_t run = 0;
        while (run < text.size() && plain(text[run]))
            ++run;
        out.append(text.substr(0, run));
        text.remove_prefix(run);
        if (text.empty()) break;

        const std::size_t length = sequenceLength(text);
        if (length == 0)
            out += "\uFFFD";
        else if (length == 1)
            appendEscaped(out, text[0]);
        else
            out.append(text.substr(0, length));
        text.remove_prefix(length == 0 ? 1 : length);
    }
    out += '"';
}

std::string repairedUtf8(std::string_view text)
{
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = sequenceLength(text);
        if (length == 0)
            out += "\uFFFD";
        else
            out.append(text.substr(0, length));
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return out;
}

} // namespace io
