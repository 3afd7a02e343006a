// Reads the images named on stdin, one a line, and prints "read", "refused" for each. For the test that feeds it
// damaged files and sees how far it gets.
#include "io/files/image_file.h"

#include <cstdio>
#include <iostream>
#include <sys/resource.h>
#include <unistd.h>

int main()
{
#ifndef __SANITIZE_ADDRESS__
    const rlimit memory{rlim_t(3) << 30, rlim_t(3) << 30};
    ::setrlimit(RLIMIT_AS, &memory);
#endif
    const rlimit core{0, 0};
    ::setrlimit(RLIMIT_CORE, &core);
    for (std::string file; std::getline(std::cin, file);) {
        ::alarm(10); // s; a file that hangs is a file that kills
        std::cout << (io::readImage(file) ? "read" : "refused") << std::endl;
    }
}
