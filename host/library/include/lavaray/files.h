#ifndef LAVARAY_FILES_H
#define LAVARAY_FILES_H

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <lavaray/types.h>

// Files that are written whole or not at all; films: what a render has gathered so far, in a file; reports.
namespace lavaray::v0 {

// A file to write, and the name that messages give to where that comes from, such as "--output".
struct OutputName {
  std::string option;
  std::filesystem::path file;
  // A file that is read but may be replaced all the same: the film that a render resumes, by its checkpoint.
  std::filesystem::path mayReplace = {};
};

// A file that is created whole or not at all: it is written in the target's folder and replaces the target in
// commit(). Without that call it vanishes, and whatever was there before stays. If the target is a symbolic
// link, the file that it points to is replaced, not the link.
class LAVARAY_API OutputFile {
 public:
  // Finds out now what would make commit() fail. Throws Error(kOutput) if the folder cannot be written to, or
  // if what is there is not an ordinary file or cannot be replaced; Error(kUsage) if it is being written
  // already, or is read (see protectInputs).
  explicit OutputFile(const OutputName& output);
  // What `descriptor` is open for, which stays open: standard output, say, which messages call stdout. It is
  // written as it goes.
  OutputFile(int descriptor, const OutputName& output);
  ~OutputFile();
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) noexcept;

  std::FILE* stream() const;
  // Throws Error(kOutput) if not everything could be written. If everything was but the target cannot be
  // replaced, the file is kept under a name that the message gives.
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Removes what OutputFile has not committed. For a signal handler that ends the process; in a forked child it
// does nothing.
LAVARAY_API void removeTemporaryFiles() noexcept;

// From here on no OutputFile replaces a file that the library has read. For a program whose user names both,
// and may name one twice.
LAVARAY_API void protectInputs() noexcept;
// Counts a file among those that are read; `what` is for messages: "the scene". If a name is noted more than
// once, the first note counts. Throws Error(kUsage) if the file is being written.
LAVARAY_API void noteRead(const std::filesystem::path& file, const std::string& what = "the file");
// For use before anything is done: throws Error(kUsage) if one of the files is one that is read, or if two
// are the same.
LAVARAY_API void checkOutputs(const std::vector<OutputName>& outputs);

// What a film says of itself.
struct FilmInfo {
  std::string device;
  ImageSize size;     // of the whole picture
  Rectangle crop;     // the part of the picture that the film is of
  SampleRange range;  // which of each pixel's `samples` it has; with a target error 0:1
  std::uint32_t samples;
  bool isComplete;  // everything that was asked for is in it
};

// Verifies the whole file. Throws Error(kInput) if it is not a film, is damaged or ends early.
LAVARAY_API FilmInfo readFilmInfo(const std::filesystem::path& film);

// The films of one picture's parts, merged row by row, so that the picture need not fit into memory. The
// values are bit for bit those of one render of the whole, but for a render to a target error, whose parts
// choose their own samples: there the error of each part, and so of the whole, is at most the target.
class LAVARAY_API FilmMerge {
 public:
  // Opens and verifies all parts; each stays open. Throws Error(kInput) naming each part that is damaged,
  // incomplete, or of a different picture from the first.
  explicit FilmMerge(const std::vector<std::filesystem::path>& films);
  ~FilmMerge();
  FilmMerge(FilmMerge&&) noexcept;
  FilmMerge& operator=(FilmMerge&&) noexcept;

  ImageSize size() const;  // of the whole picture
  const std::string& device() const;
  // What may make the picture differ from that of one render in the last bits; empty if nothing does.
  std::vector<std::string> warnings() const;

  // Throws Error(kInput) if a pixel of the area lacks samples or has some twice, saying which pixels and
  // samples, and which parts overlap.
  void checkCoverage(const Rectangle& area) const;
  // The values of row y of the picture from column x0 on, `columns` of them; `rgb` has room for 3 * columns.
  void readRow(int y, int x0, int columns, float* rgb);
  // All of the area, which checkCoverage checks. Throws Error(kUsage) if it does not lie within the picture.
  Image image(const Rectangle& area);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct ComparedPair;  // see image.h

enum class ReportFormat {
  kHtml,  // a page that shows the pictures in any browser, with all that it needs in it
  kJson,
};

// A report of pairs of images, written as they are compared.
class LAVARAY_API ReportWriter {
 public:
  // The file must outlive it, and is to be committed after finish(). `title` is of a page.
  ReportWriter(OutputFile& file, ReportFormat format, const std::string& title = {});
  ~ReportWriter();
  ReportWriter(ReportWriter&&) noexcept;
  ReportWriter& operator=(ReportWriter&&) noexcept;

  void add(const ComparedPair& compared);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lavaray::v0

#endif
