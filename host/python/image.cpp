#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/bindings.hpp"

namespace lavaray::python {
namespace {

using Path = std::filesystem::path;

// Of an array of the shape (height, width, 3), which the caller has checked.
Image imageOf(const Array<float>& array) {
  Image image;
  image.height = static_cast<int>(array.shape(0));
  image.width = static_cast<int>(array.shape(1));
  image.rgb.assign(array.data(), array.data() + array.size());
  return image;
}

py::object read(const Path& file) {
  Image image;
  {
    const py::gil_scoped_release release;
    image = readImage(file);
  }
  return arrayOf(std::move(image));
}

void write(const Array<float>& array, const Path& file) {
  const Image image = imageOf(array);
  const py::gil_scoped_release release;
  writeImage(image, file);
}

py::dict compareImages(const Array<float>& first, const Array<float>& second, double tolerance) {
  const Image image = imageOf(first);
  const Image reference = imageOf(second);
  Difference difference;
  double flip = 0.0;
  {
    const py::gil_scoped_release release;
    difference = compare(image, reference, tolerance);
    flip = meanFlip(image, reference);
  }
  py::dict result;
  result["pixels"] = difference.pixels;
  result["differing"] = difference.differing;
  result["largest"] = difference.color.largest;
  result["largest_at"] = std::pair(difference.color.x, difference.color.y);
  result["rmse"] = difference.color.rmse;
  result["flip"] = flip;
  return result;
}

py::array_t<float> flip(const Array<float>& first, const Array<float>& second) {
  const Image image = imageOf(first);
  const Image reference = imageOf(second);
  std::vector<float> values;
  {
    const py::gil_scoped_release release;
    values = flipMap(image, reference);
  }
  return arrayOf(std::move(values), {image.height, image.width});
}

}  // namespace

void bindImage(py::module_& module) {
  module.def("read_image", &read);
  module.def("write_image", &write);
  module.def("compare", &compareImages);
  module.def("flip_map", &flip);
}

}  // namespace lavaray::python
