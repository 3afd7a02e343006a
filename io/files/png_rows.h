// PNG read row by row from its file.
#pragma once

#include "io/files/file_reader.h"
#include "io/files/image_rows.h"

namespace io {

// Null when it is interlaced: its rows come only with the last of them.
Result<std::unique_ptr<ImageRows>> openPngRows(FileReader file, const std::string& where, int largestSide);

} // namespace io
