// The bytes of a PNG that pixels depend on, read from its file as they are asked for.
#pragma once

#include "io/files/file_reader.h"

#include <cstddef>
#include <string>
#include <zlib.h>

namespace io {

// Chunk after chunk as withoutMetadata() leaves a PNG.
class PngChunks {
public:
    explicit PngChunks(FileReader file) : m_file{std::move(file)} {}
    bool take(void* to, std::size_t size); // false where the file ends early

    // Once the header of the first IDAT was taken: as much as there is of the data of all of them, 0 at its end and after a fault.
    std::size_t takeData(void* to, std::size_t size);
    bool finishData(); // the rest of this IDAT, which must be sound
    const std::string& fault() const { return m_fault; }

private:
    bool toNext();
    bool checkSum();

    FileReader m_file;
    unsigned char m_header[8] = {};
    std::size_t m_headerLeft = 0;
    std::uint64_t m_left = 8; // of the chunk, or of the signature before the first
    uLong m_sum = crc32(0, reinterpret_cast<const Bytef*>("IDAT"), 4); // so far, of an IDAT
    std::string m_fault;
};

// What the data of a PNG unpacks to: rows of a filter's number and filtered bytes.
class PngInflater {
public:
    explicit PngInflater(PngChunks& chunks);
    ~PngInflater() { inflateEnd(&m_stream); }
    PngInflater(const PngInflater&) = delete;
    PngInflater& operator=(const PngInflater&) = delete;
    bool read(void* to, std::size_t size);
    const std::string& fault() const { return m_fault; }

private:
    PngChunks& m_chunks;
    std::string m_packed, m_fault;
    z_stream m_stream = {};
};

// Undoes a filter (PNG 9.2) of a row of `size` bytes with `pixel` of them in each pixel, 1 or 2; `above` is the row before, zeros at first.
// False when there is no such filter.
bool unfilterPng(int filter, int pixel, const unsigned char* filtered, const unsigned char* above, unsigned char* row, std::size_t size);

} // namespace io
