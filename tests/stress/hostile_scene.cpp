#include "stress/hostile_scene.hpp"

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "base/number_text.hpp"

namespace lavaray {
namespace {

struct Kind {
  int planes, spheres, triangles;
  bool mesh, normals;  // normals: of the mesh
  int lights;
  bool mirrors, radii;  // radii: of the lights
};

constexpr std::array<Kind, kSceneKinds> kKinds{{{0, 0, 0, false, false, 1, false, false},
                                                {1, 0, 0, false, false, 2, false, false},
                                                {0, 3, 0, false, false, 1, false, false},
                                                {1, 3, 0, false, false, 2, false, false},
                                                {1, 3, 0, false, false, 2, true, false},
                                                {1, 2, 0, false, false, 2, false, true},
                                                {0, 0, 4, false, false, 1, false, false},
                                                {1, 2, 3, false, false, 2, false, false},
                                                {0, 0, 0, true, false, 1, false, false},
                                                {1, 1, 0, true, true, 2, false, false},
                                                {2, 2, 2, true, true, 2, true, true},
                                                {1, 2, 2, false, false, 0, true, false}}};

constexpr std::array kHostileNumbers{"0",     "-0",    "-1",    "-1e-3", "1e-310", "1e-45", "1e-38", "1e-30",
                                     "1e-20", "1e-7",  "1e7",   "1e14",  "1e15",   "-1e15", "1e16",  "1e38",
                                     "1e400", "-1e39", "nan",   "inf",   "-inf",   "0.5",   "1000",  "0x10",
                                     "",      "1e",    "1e+15", "180",   "179.999"};

// The products of these are no floats any more, and infinity times zero is no number at all.
constexpr std::array kHostileColors{"0 0 0", "1e15 1e15 1e15", "1e15 0 1e-30", "1e-40 1e14 0"};

class Writer {
 public:
  Writer(const Kind& kind, bool hostile, Random& random) : kind_(kind), random_(random) {
    if (!hostile) return;
    // Most scenes have a few bad numbers only, or hardly one would be read to its end.
    numberRate_ = std::array{0.0, 0.005, 0.02, 0.1}[random_() % 4];
    coincidenceRate_ = std::array{0.0, 0.2, 0.7}[random_() % 3];
  }

  SceneText write() {
    scene_ = std::to_string(1 + kind_.planes + kind_.spheres + kind_.triangles + (kind_.mesh ? 1 : 0) +
                            kind_.lights) +
             "\n";
    camera();
    for (int i = 0; i < kind_.planes; ++i) plane();
    for (int i = 0; i < kind_.spheres; ++i) sphere();
    for (int i = 0; i < kind_.triangles; ++i) triangle();
    if (kind_.mesh) mesh();
    for (int i = 0; i < kind_.lights; ++i) light();
    return {scene_, mesh_};
  }

 private:
  bool chance(double rate) { return std::uniform_real_distribution<double>(0.0, 1.0)(random_) < rate; }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

  std::string number(double fine) {
    if (!chance(numberRate_)) return numberText(fine);
    return kHostileNumbers[random_() % kHostileNumbers.size()];
  }
  std::string vector(const glm::dvec3& v) { return number(v.x) + ' ' + number(v.y) + ' ' + number(v.z); }

  // A new place, or one where something is already, or one on a sphere of radius 1 about that.
  glm::dvec3 place(const glm::dvec3& fine) {
    glm::dvec3 place = fine;
    if (!places_.empty() && chance(coincidenceRate_)) {
      place = places_[random_() % places_.size()];
      if (chance(0.3)) place[static_cast<int>(random_() % 3)] += random_() % 2 == 0 ? 1.0 : -1.0;
    }
    places_.push_back(place);
    return place;
  }
  glm::dvec3 anywhere() { return {uniform(-3.0, 3.0), uniform(-2.0, 2.0), uniform(-9.0, -3.0)}; }

  void line(const std::string& key, const std::string& value) { scene_ += key + ": " + value + "\n"; }
  void kind(const std::string& name) { scene_ += name + "\n"; }
  void color(const std::string& key, double most) {
    if (chance(2.0 * numberRate_)) return line(key, kHostileColors[random_() % kHostileColors.size()]);
    line(key, vector({uniform(0.0, most), uniform(0.0, most), uniform(0.0, most)}));
  }
  void material() {
    color("amb", 0.3);
    color("dif", 0.8);
    color("spe", 0.8);
    line("shi", number(uniform(0.0, 100.0)));
    if (kind_.mirrors) color("ref", 0.8);
  }

  void camera() {
    kind("camera");
    line("pos", vector(place(glm::dvec3(0.0))));
    line("fov", number(60.0));
    line("f", number(20.0));
    line("a", number(1.33));
  }
  void plane() {
    kind("plane");
    line("nor", vector({uniform(-0.2, 0.2), 1.0, uniform(-0.2, 0.2)}));
    line("pos", vector(place({0.0, -2.0, 0.0})));
    material();
  }
  void sphere() {
    kind("sphere");
    line("pos", vector(place(anywhere())));
    line("rad", number(chance(coincidenceRate_) ? 1.0 : uniform(0.2, 2.0)));
    material();
  }
  void triangle() {
    kind("triangle");
    for (const char* key : {"v1", "v2", "v3"}) line(key, vector(place(anywhere())));
    material();
  }
  void light() {
    kind("light");
    line("pos", vector(place({uniform(-9.0, 9.0), uniform(2.0, 9.0), uniform(-9.0, 3.0)})));
    color("amb", 0.3);
    color("dif", 1.0);
    color("spe", 1.0);
    if (kind_.radii) line("rad", number(uniform(0.1, 1.0)));
  }

  void mesh() {
    kind("mesh");
    line("file", "mesh.obj");
    material();
    constexpr int kVertices = 12;
    for (int i = 0; i < kVertices; ++i) {
      mesh_ += "v " + vector(place(anywhere())) + "\n";
      if (kind_.normals) mesh_ += "vn " + vector({uniform(-1.0, 1.0), uniform(-1.0, 1.0), 1.0}) + "\n";
    }
    for (int i = 0; i < 10; ++i) {
      mesh_ += "f";
      for (int corner = 0; corner < 3; ++corner) {
        const std::string index = std::to_string(1 + random_() % kVertices);
        mesh_ += ' ' + index;
        if (kind_.normals) mesh_ += "//" + index;
      }
      mesh_ += "\n";
    }
  }

  const Kind& kind_;
  Random& random_;
  double numberRate_ = 0.0;
  double coincidenceRate_ = 0.0;
  std::vector<glm::dvec3> places_;
  std::string scene_;
  std::string mesh_;
};

}  // namespace

SceneText makeSceneText(int kind, bool hostile, Random& random) {
  return Writer(kKinds.at(kind), hostile, random).write();
}

}  // namespace lavaray
