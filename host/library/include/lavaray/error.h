#ifndef LAVARAY_ERROR_H
#define LAVARAY_ERROR_H

#include <cstddef>
#include <stdexcept>
#include <string>

#define LAVARAY_API __attribute__((visibility("default")))

// The version of the binary interface is part of every name, so that programs that are built with headers of
// different versions do not link. A program writes lavaray::Scene all the same. Inside the library, whose own
// types have some of the same names, it is written v0::Scene.
namespace lavaray {
#ifndef LAVARAY_INSIDE
inline
#endif
    namespace v0 {
}
}  // namespace lavaray

namespace lavaray::v0 {

// The values are those of the programs' exit codes.
enum class ErrorKind {
  kInternal = 1,  // a defect of the library
  kUsage = 2,     // options that are out of range, or contradict each other
  kInput = 3,     // a scene, mesh, image, film or shader
  kDevice = 4,    // there is no device, or it fails
  kOutput = 5,    // a file cannot be written
  kMemory = 6,
};

// What every function of the library throws that fails. what() is a sentence for the user, which names the
// file and the line where there is one.
class LAVARAY_API Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message, std::string file = {}, std::size_t line = 0);
  Error(const Error&);
  ~Error() override;

  ErrorKind kind() const noexcept { return kind_; }
  const std::string& file() const noexcept { return file_; }  // empty where it is about none
  std::size_t line() const noexcept { return line_; }         // from 1; 0 where it is about none

 private:
  ErrorKind kind_;
  std::string file_;
  std::size_t line_;
};

// Such as "0.2.0".
LAVARAY_API const char* version() noexcept;

}  // namespace lavaray::v0

#endif
