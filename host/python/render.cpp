#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/bindings.hpp"

namespace lavaray::python {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& name, const char* allowed) {
  throw Error(ErrorKind::kUsage, what + " is '" + name + "', allowed are " + allowed);
}

struct Options : RenderOptions {
  void setView(const std::string& word) {
    const std::optional<View> named = viewNamed(word);
    if (!named) refuse("view", word, kViewNames);
    view = *named;
  }
  void setFilter(const std::string& word) {
    const std::optional<PixelFilter> named = filterNamed(word);
    if (!named) refuse("filter", word, kPixelFilterNames);
    filter = *named;
  }
  void setSampler(const std::string& word) {
    const std::optional<Sampler> named = samplerNamed(word);
    if (!named) refuse("sampler", word, kSamplerNames);
    sampler = *named;
  }
  void setCrop(const std::optional<std::array<int, 4>>& part) {
    crop.reset();
    if (part) crop = Rectangle{(*part)[0], (*part)[1], (*part)[2], (*part)[3]};
  }
};

// Ctrl-C raises KeyboardInterrupt, which ends the render; so does what the user's function raises.
bool goesOn(const py::object& progress, double share) {
  const py::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return progress.is_none() || progress(share).cast<bool>();
}

py::dict describe(const Statistics& statistics) {
  py::dict result;
  result["stop_reason"] = name(statistics.stopReason);
  result["samples_per_pixel"] = statistics.samplesPerPixel;
  result["estimated_error"] = statistics.estimatedError;
  result["camera_rays"] = statistics.rays.camera;
  result["mirror_rays"] = statistics.rays.mirror;
  result["shadow_rays"] = statistics.rays.shadow;
  return result;
}

py::tuple render(const Renderer& renderer, const Scene& scene, const Options& options,
                 const py::object& progress) {
  Picture picture;
  {
    const py::gil_scoped_release release;
    picture = renderer.render(scene, options, [&](double share) { return goesOn(progress, share); });
  }
  const py::dict statistics = describe(picture.statistics);
  return py::make_tuple(arrayOf(std::move(picture.image)), statistics);
}

py::array_t<float> run(const Renderer& renderer, const Shader& shader, const Scene& scene,
                       const Options& options, const py::object& progress) {
  Image image;
  {
    const py::gil_scoped_release release;
    image = renderer.run(shader, scene, options, [&](double share) { return goesOn(progress, share); });
  }
  return arrayOf(std::move(image));
}

py::list devices() {
  DeviceList list;
  {
    const py::gil_scoped_release release;
    list = listDevices();
  }
  py::list result;
  for (const DeviceInfo& device : list.devices) {
    result.append(py::make_tuple(device.name, device.kind, device.driver, device.isUsable));
  }
  return result;
}

}  // namespace

void bindRender(py::module_& module) {
  py::class_<Options>(module, "Options")
      .def(py::init<>())
      .def_readwrite("width", &Options::width)
      .def_readwrite("height", &Options::height)
      .def_readwrite("samples", &Options::samples)
      .def_readwrite("max_samples", &Options::maxSamples)
      .def_readwrite("max_depth", &Options::maxDepth)
      .def_readwrite("seed", &Options::seed)
      .def_readwrite("target_error", &Options::targetError)
      .def_readwrite("time_limit", &Options::timeLimitSeconds)
      .def_readwrite("normalize", &Options::normalize)
      .def_readwrite("count_rays", &Options::countRays)
      .def("set_view", &Options::setView)
      .def("set_filter", &Options::setFilter)
      .def("set_sampler", &Options::setSampler)
      .def("set_crop", &Options::setCrop);
  py::class_<Renderer>(module, "Renderer")
      .def(py::init([](const std::string& device) { return Renderer(Device(device)); }))
      .def("device_name",
           [](const Renderer& renderer) {
             const py::gil_scoped_release release;
             return renderer.device().info().name;
           })
      .def("render", &render)
      .def("run", &run);
  const py::call_guard<py::gil_scoped_release> withoutGil;
  py::class_<Shader>(module, "Shader")
      .def(py::init<const std::filesystem::path&>(), withoutGil)
      .def("reload", &Shader::reload, withoutGil)
      .def("take_warnings", &Shader::takeWarnings)
      .def_property_readonly("files", &Shader::files);
  module.def("devices", &devices);
}

}  // namespace lavaray::python
