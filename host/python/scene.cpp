#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/bindings.hpp"

namespace lavaray::python {
namespace {

using Path = std::filesystem::path;

template <typename Value>
std::vector<Value> vectorOf(const Array<Value>& array) {
  return {array.data(), array.data() + array.size()};
}

Material material(const Vec3& ambient, const Vec3& diffuse, const Vec3& specular, double shininess,
                  const std::optional<Vec3>& reflectance) {
  return {ambient, diffuse, specular, shininess, reflectance};
}

void addMesh(Scene& scene, const Array<double>& vertices, const Array<std::uint32_t>& faces,
             const Array<double>& normals, const Array<std::uint32_t>& corners, const Material& material) {
  Mesh mesh;
  mesh.vertices = vectorOf(vertices);
  mesh.faces = vectorOf(faces);
  mesh.normals = vectorOf(normals);
  mesh.corners = vectorOf(corners);
  mesh.material = material;
  const py::gil_scoped_release release;
  scene.add(mesh);
}

}  // namespace

void bindScene(py::module_& module) {
  py::class_<Material>(module, "Material").def(py::init(&material));
  py::class_<Scene>(module, "Scene")
      .def(py::init<>())
      .def_static(
          "read",
          [](const Path& file, double reflect, double lightRadius) {
            return Scene::read(file, {reflect, lightRadius});
          },
          py::call_guard<py::gil_scoped_release>())
      .def_static(
          "parse",
          [](const std::string& text, const Path& file, double reflect, double lightRadius) {
            return Scene::parse(text, file, {reflect, lightRadius});
          },
          py::call_guard<py::gil_scoped_release>())
      .def("set_camera",
           [](Scene& scene, const Vec3& position, double fov, double focalLength, double aspect) {
             scene.setCamera({position, fov, focalLength, aspect});
           })
      .def("set_defaults",
           [](Scene& scene, double reflect, double lightRadius) {
             scene.setDefaults({reflect, lightRadius});
           })
      .def("add_plane",
           [](Scene& scene, const Vec3& normal, const Vec3& point, const Material& m) {
             scene.add(Plane{normal, point, m});
           })
      .def("add_sphere",
           [](Scene& scene, const Vec3& center, double radius, const Material& m) {
             scene.add(Sphere{center, radius, m});
           })
      .def("add_triangle",
           [](Scene& scene, const std::array<Vec3, 3>& vertices, const Material& m) {
             scene.add(Triangle{vertices, m});
           })
      .def("add_mesh", &addMesh)
      .def("add_light",
           [](Scene& scene, const Vec3& position, const Vec3& ambient, const Vec3& diffuse,
              const Vec3& specular, const std::optional<double>& radius) {
             scene.add(Light{position, ambient, diffuse, specular, radius});
           })
      .def_property_readonly("warnings", &Scene::warnings)
      .def_property_readonly("files", &Scene::files)
      .def_property_readonly("size", [](const Scene& scene) {
        const ImageSize size = scene.summary().image;
        return std::pair(size.width, size.height);
      });
}

}  // namespace lavaray::python
