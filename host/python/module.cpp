// The extension module lavaray._core: the library's functions for arrays of numpy. What users see is in the
// folder lavaray beside this file.

#include <optional>

#include <pybind11/pybind11.h>

#include "python/bindings.hpp"

namespace lavaray::python {
namespace {

const char* kindName(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kUsage:
      return "usage";
    case ErrorKind::kInput:
      return "input";
    case ErrorKind::kDevice:
      return "device";
    case ErrorKind::kOutput:
      return "output";
    case ErrorKind::kMemory:
      return "memory";
    case ErrorKind::kInternal:
      break;
  }
  return "internal";
}

// Raises lavaray.Error.
void raise(const Error& error) {
  const py::object type = py::module_::import("lavaray._errors").attr("Error");
  py::object file = py::none();
  py::object line = py::none();
  if (!error.file().empty()) file = py::str(error.file());
  if (error.line() > 0) line = py::int_(error.line());
  const py::object value = type(error.what(), kindName(error.kind()), file, line);
  PyErr_SetObject(type.ptr(), value.ptr());
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  py::register_exception_translator([](std::exception_ptr exception) {
    try {
      if (exception) std::rethrow_exception(exception);
    } catch (const Error& error) {
      raise(error);
    }
  });
  module.attr("version") = version();
  bindScene(module);
  bindRender(module);
  bindImage(module);
}

}  // namespace lavaray::python
