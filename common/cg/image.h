#pragma once

/// Library cg_image: pictures in files. It stands alone because the OpenImageIO that it uses loads
/// hundreds of libraries; a program that rarely needs a picture opens libcg_image.so when it does
/// (dlopen) and calls the C functions below.

#include <cg/Pixels.h>

#include <cstddef>
#include <string>

namespace cg {

/// Reads any picture that OpenImageIO knows: grey is spread over the three colours, missing alpha
/// is 255, values are those in the file (8 bits, sRGB, alpha not multiplied in). Files of floats
/// (EXR, HDR) hold linear values: they are brought to sRGB, and what is no number is `broken`.
/// Only what is flat, at most maxSide pixels a side and 2^26 in all. Throws cg::Error that names
/// the file.
Pixels readImage(const std::string& path);

/// Writes a picture; the name's ending decides the format (use .png). Alpha is dropped: the file
/// is opaque RGB. The same pixels always give the same bytes. Throws cg::Error that names the file.
void writeImage(const std::string& path, const Pixels& pixels);

}  // namespace cg

extern "C" {

/// As cg::readImage: 0 and the picture in *rgba (4 * width * height bytes, to be given to free()),
/// or 1 and a sentence in error[0 .. errorSize), with both pointers null. *broken is null,
/// or width * height bytes (to be given to free()) that are 1 where the file holds no number.
int cg_image_read(const char* path, int* width, int* height, unsigned char** rgba,
                  unsigned char** broken, char* error, std::size_t errorSize);

/// As cg::writeImage: 0, or 1 and a sentence in error[0 .. errorSize).
int cg_image_write(const char* path, int width, int height, const unsigned char* rgba, char* error,
                   std::size_t errorSize);
}
