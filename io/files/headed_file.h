// Reading and writing of a file that begins with "format" and "version".
#pragma once

#include "io/files/field_reader.h"
#include "io/files/field_writer.h"
#include "io/files/file_formats.h"

namespace io {

// A missing header is complained of; another format or a newer version is refused.
inline Status checkHeader(const std::string& format, int version, const char* expectedFormat, Source& source)
{
    const char* start = source.text().data();
    if (format.empty())
        source.complain(Severity::Error, start,
                        std::string{"format: missing; add \"format\": \""} + expectedFormat + '"');
    else if (format != expectedFormat)
        return Error{source.whereIs(start), "format: \"" + format + "\" where \"" + expectedFormat + "\" was expected"};
    if (version < 1) source.complain(Severity::Error, start, "version: missing; add \"version\": 1");
    if (version > kFileVersion)
        return Error{source.whereIs(start), "version: " + std::to_string(version) +
                                                " was written by a newer Wold; this one reads " +
                                                std::to_string(kFileVersion) + ": update Wold"};
    return {};
}

// Reads `text` as the file `name`; `other` may take keys of the root that are no fields.
template <class Body, class Other> Result<Body> readHeaded(Source& source, const char* format, Other other)
{
    Headed<Body> file;
    const Status parsed = readRoot(source, [&](JsonObject root) {
        readSection(file, root, nullptr, Unknown{&file.body.extra, {}}, source, other);
    });
    if (!parsed) return parsed.error();
    if (Status known = checkHeader(file.format, file.version, format, source); !known) return known.error();
    return std::move(file.body);
}

template <class Body>
Result<Body> readHeadedText(std::string text, const std::string& name, const char* format, Complaints& complaints)
{
    const std::size_t size = text.size();
    text.append(simdjson::SIMDJSON_PADDING, '\0');
    Complaints found;
    Source source{name, std::string_view{text}.substr(0, size), found};
    Result<Body> body = readHeaded<Body>(source, format, [](auto&&...) { return false; });
    if (body) {
        source.finish();
        complaints.insert(complaints.end(), found.begin(), found.end());
    }
    return body;
}

template <class Body> std::string headedText(const Body& body, const char* format)
{
    std::string out;
    FieldWriter writer{out, 0, &body.extra};
    const Headed<Body> file{format, kFileVersion, body};
    writer.section(file);
    return out + '\n';
}

} // namespace io
