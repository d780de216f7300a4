#include "shading/color/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "geometry/files/input_file.h"
#include "geometry/files/output_file.h"
#include "geometry/files/parse_error.h"

namespace xnewell {

namespace {

constexpr int kLargest = 8192;

/// The zlib compression level: the fastest, since the files are small. The Sub filter runs first: it stores
/// each byte's difference from the byte one pixel to the left. Measured with a shaded teapot of 800 x 600:
/// level 1 gives 37 kB in 2.5 ms, 4 gives 29 kB in 4.3 ms, 6 gives 26 kB in 8 ms, 9 gives 24 kB in 58 ms.
constexpr int kCompression = 1;

struct Pixels {
  int width, height, colorType;
  const std::uint8_t* bytes;  ///< rows without padding
  int bytesPerRow;
  const png_color* palette;  ///< 256 entries, or null
  const std::string& note;
};

/// The keyword of the note: what PNG calls an international text chunk.
constexpr const char* kNote = "xnewell";

/// The longest chunk besides pixels that is read, and the longest text that one may unfold to. Bytes.
constexpr png_alloc_size_t kLongestChunk = 1 << 20;

struct Output {
  std::string bytes;
  std::array<char, 200> error{};
  bool withoutMemory = false;  ///< libpng may go on without a chunk, or give another reason
};

// libpng is written in C, so no exception may pass through it. An error jumps back to encode(), which has no
// object to destroy.
void onError(png_structp png, png_const_charp what) {
  std::array<char, 200>& error = static_cast<Output*>(png_get_error_ptr(png))->error;
  std::snprintf(error.data(), error.size(), "%s", what);
  png_longjmp(png, 1);
}
void onWarning(png_structp, png_const_charp) {}

png_voidp allocate(png_structp png, png_alloc_size_t size) {
  void* const block = std::malloc(size);
  if (block == nullptr) static_cast<Output*>(png_get_mem_ptr(png))->withoutMemory = true;
  return block;
}
void release(png_structp, png_voidp block) { std::free(block); }

void append(png_structp png, png_bytep data, png_size_t size) {
  auto* const output = static_cast<Output*>(png_get_io_ptr(png));
  try {
    output->bytes.append(reinterpret_cast<const char*>(data), size);
  } catch (...) {
    output->withoutMemory = true;
  }
  if (output->withoutMemory) png_error(png, "out of memory");
}

/// Returns false after an error; the error's text is then in the Output.
bool encode(png_structp png, png_infop info, const Pixels& p) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_IHDR(png, info, p.width, p.height, 8, p.colorType, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (p.palette) png_set_PLTE(png, info, p.palette, 256);
  png_set_compression_level(png, kCompression);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  if (!p.note.empty()) {
    png_text text{};
    text.compression = PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(kNote);  // libpng only reads them
    text.text = const_cast<char*>(p.note.c_str());
    text.itxt_length = p.note.size();
    png_set_text(png, info, &text, 1);
  }
  png_write_info(png, info);
  for (int j = 0; j < p.height; ++j) png_write_row(png, p.bytes + std::size_t(j) * p.bytesPerRow);
  png_write_end(png, nullptr);
  return true;
}

struct Writer {
  png_structp png;
  png_infop info;
  explicit Writer(Output& output)
      : png{png_create_write_struct_2(PNG_LIBPNG_VER_STRING, &output, onError, onWarning, &output, allocate,
                                      release)},
        info{png ? png_create_info_struct(png) : nullptr} {
    if (png) png_set_write_fn(png, &output, append, nullptr);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

std::string encoded(const Pixels& pixels) {
  Output output;
  const Writer writer{output};
  if (!writer.info) throw std::bad_alloc{};
  const bool done = encode(writer.png, writer.info, pixels);
  if (output.withoutMemory) throw std::bad_alloc{};
  if (!done) throw std::runtime_error{std::string{"PNG: "} + output.error.data()};
  return std::move(output.bytes);
}

InputFile openPng(const std::string& file) {
  InputFile input = openInput(file);
  std::array<std::uint8_t, 8> signature{};
  const std::size_t there = std::fread(signature.data(), 1, signature.size(), input.get());
  if (std::ferror(input.get())) throw std::system_error{errno, std::generic_category(), file};
  if (there < signature.size() || png_sig_cmp(signature.data(), 0, signature.size()) != 0)
    throw ParseError{file, 0, "not a PNG file"};
  std::rewind(input.get());
  return input;
}

struct Reader {
  png_structp png;
  png_infop info;
  explicit Reader(Output& output)
      : png{png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &output, onError, onWarning, &output, allocate,
                                     release)},
        info{png ? png_create_info_struct(png) : nullptr} {}
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Reads all that stands before the pixels. Returns false after an error; the Output has its text.
bool readHead(png_structp png, png_infop info, std::FILE* input) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_chunk_malloc_max(png, kLongestChunk);
  png_init_io(png, input);
  png_read_info(png, info);
  return true;
}

/// Reads the rows of a palette PNG. Returns false after an error; the Output has its text.
bool readRows(png_structp png, png_infop info, std::uint8_t** rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_packing(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  png_read_image(png, rows);
  return true;
}

/// Throws unless libpng has `done` all of its work.
void checked(bool done, const Output& output, const std::string& file, std::FILE* input) {
  if (output.withoutMemory) throw std::bad_alloc{};
  if (!done) throw ParseError{file, 0, std::feof(input) ? "the PNG file ends early" : output.error.data()};
}

}  // namespace

std::string encodePng(const IndexImage& image, const Palette& palette, const std::string& note) {
  assert(image.pixels.size() == std::size_t(image.width) * image.height);
  std::array<png_color, 256> colors;
  for (int c = 0; c < 256; ++c) {
    const auto shown = [](std::uint16_t v) { return static_cast<png_byte>(v >> 8); };
    colors[c] = {shown(palette[c].r), shown(palette[c].g), shown(palette[c].b)};
  }
  return encoded({image.width, image.height, PNG_COLOR_TYPE_PALETTE, image.pixels.data(), image.width,
                  colors.data(), note});
}

std::string encodePng(const RgbImage& image, const std::string& note) {
  assert(image.rgb.size() == std::size_t{3} * image.width * image.height);
  return encoded(
      {image.width, image.height, PNG_COLOR_TYPE_RGB, image.rgb.data(), 3 * image.width, nullptr, note});
}

void writePng(const std::string& file, const IndexImage& image, const Palette& palette) {
  writeFile(file, encodePng(image, palette));
}

void writePng(const std::string& file, const RgbImage& image) { writeFile(file, encodePng(image)); }

RgbImage readPng(const std::string& file) {
  const auto input = openPng(file);
  const auto fail = [&](const char* what) {
    if (std::string_view{what}.find("memory") != std::string_view::npos) throw std::bad_alloc{};
    throw ParseError{file, 0, std::feof(input.get()) ? "the PNG file ends early" : what};
  };
  // libpng's simplified reader prints no errors; it leaves them in `message`.
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> freed{&png, &png_image_free};
  if (!png_image_begin_read_from_stdio(&png, input.get())) fail(png.message);
  if (png.width > kLargest || png.height > kLargest)
    throw ParseError{file, 0, "the picture is larger than 8192 pixels"};
  png.format = PNG_FORMAT_RGB;
  RgbImage image{static_cast<int>(png.width), static_cast<int>(png.height)};
  const png_color black{0, 0, 0};
  if (!png_image_finish_read(&png, &black, image.rgb.data(), 0, nullptr)) fail(png.message);
  return image;
}

std::optional<IndexedPng> readIndexedPng(const std::string& file) {
  const auto input = openPng(file);
  Output output;
  const Reader reader{output};
  if (!reader.info) throw std::bad_alloc{};
  checked(readHead(reader.png, reader.info, input.get()), output, file, input.get());
  if (png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_PALETTE) return std::nullopt;
  const png_uint_32 width = png_get_image_width(reader.png, reader.info),
                    height = png_get_image_height(reader.png, reader.info);
  if (width > kLargest || height > kLargest)
    throw ParseError{file, 0, "the picture is larger than 8192 pixels"};
  IndexedPng read{.image = {static_cast<int>(width), static_cast<int>(height), 0}};
  png_colorp palette = nullptr;
  int colors = 0;
  png_get_PLTE(reader.png, reader.info, &palette, &colors);
  for (int c = 0; c < std::min(colors, 256); ++c)
    read.held[c] = {palette[c].red, palette[c].green, palette[c].blue};
  std::vector<std::uint8_t*> rows;
  for (int j = 0; j < read.image.height; ++j) rows.push_back(read.image.row(j));
  checked(readRows(reader.png, reader.info, rows.data()), output, file, input.get());
  return read;
}

std::optional<std::string> noteInPng(const std::string& file) {
  const auto input = openPng(file);
  Output output;
  const Reader reader{output};
  if (!reader.info) throw std::bad_alloc{};
  checked(readHead(reader.png, reader.info, input.get()), output, file, input.get());
  png_textp texts = nullptr;
  const int count = png_get_text(reader.png, reader.info, &texts, nullptr);
  for (const png_text& text : std::span{texts, static_cast<std::size_t>(count)})
    if (std::string_view{text.key} == kNote)
      return std::string{text.text, std::max(text.text_length, text.itxt_length)};
  return std::nullopt;
}

}  // namespace xnewell
