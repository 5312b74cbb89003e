#pragma once

#include <memory>
#include <vector>

#include <lavaray/renderer.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace lavaray::python {

namespace py = pybind11;

// Arrays of a function's arguments: copied where they are of another type or not contiguous.
template <typename Value>
using Array = py::array_t<Value, py::array::c_style | py::array::forcecast>;

// An array that owns the values.
template <typename Value>
py::array_t<Value> arrayOf(std::vector<Value> values, std::vector<py::ssize_t> shape) {
  auto owner = std::make_unique<std::vector<Value>>(std::move(values));
  const Value* const data = owner->data();
  const py::capsule capsule(owner.get(),
                            [](void* vector) { delete static_cast<std::vector<Value>*>(vector); });
  owner.release();
  return py::array_t<Value>(std::move(shape), data, capsule);
}

// Its colours, of the shape (height, width, 3).
inline py::array_t<float> arrayOf(Image&& image) {
  return arrayOf(std::move(image.rgb), {image.height, image.width, 3});
}

void bindScene(py::module_& module);
void bindRender(py::module_& module);
void bindImage(py::module_& module);

}  // namespace lavaray::python
