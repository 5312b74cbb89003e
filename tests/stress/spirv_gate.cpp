// Whether the compiled shaders still say what makes the tests of rays exact: no operation of the intersection
// tests and the offsets may be contracted into a fused multiply-add.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <span>

#include "boxGateSpirv.spv.h"
#include "offsetGateSpirv.spv.h"
#include "planeGateSpirv.spv.h"
#include "rayGateSpirv.spv.h"
#include "renderFewPrimitivesSpirv.spv.h"
#include "renderNamedSpirv.spv.h"
#include "renderSpirv.spv.h"
#include "sphereGateSpirv.spv.h"
#include "stress/report.hpp"
#include "stress/spirv_module.hpp"
#include "triangleGateSpirv.spv.h"

namespace lavaray {
namespace {

std::string describe(const Arithmetic& arithmetic) {
  return std::to_string(arithmetic.decorated) + " operations NoContraction, " +
         std::to_string(arithmetic.undecorated) + " not, " + std::to_string(arithmetic.fusedMultiplyAdds) +
         " Fma";
}

// What decides where a ray enters a box or leaves a surface, outside of intersect.glsl.
const std::set<std::string> kOffsets{"decodeSides",     "preciseDot",   "pointOnPlane", "pointOnSphere",
                                     "pointOnTriangle", "surfacePoint", "leave"};

// And all of intersect.glsl, by its source, so that a new test cannot be forgotten here: the lines that are
// not indented, begin with a type, a space and a name, and go on with a parenthesis.
std::set<std::string> functionsOfIntersect() {
  std::set<std::string> names;
  std::ifstream file(LAVARAY_SHADERS_DIR "/intersect.glsl");
  for (std::string line; std::getline(file, line);) {
    const std::size_t space = line.find(' ');
    const std::size_t parenthesis = line.find('(');
    if (parenthesis == std::string::npos || space == 0 || space > parenthesis || line[0] == '/') continue;
    names.insert(line.substr(space + 1, parenthesis - space - 1));
  }
  return names;
}

// In the renderer's shader before optimization, where functions still have names.
TEST(SpirvGate, MarksIntersectionsAndOffsetsNoContraction) {
  const std::map<std::string, Arithmetic> functions = arithmeticOf(renderNamedSpirv);
  std::set<std::string> guarded = functionsOfIntersect();
  ASSERT_TRUE(guarded.contains("intersectSphere") && guarded.contains("intersectPlane"));
  guarded.insert(kOffsets.begin(), kOffsets.end());
  for (const std::string& name : guarded) {
    ASSERT_TRUE(functions.contains(name)) << "render.comp has no function " << name << " any more";
    const Arithmetic& arithmetic = functions.at(name);
    EXPECT_TRUE(arithmetic.decorated > 0 || name == "permute") << name;
    EXPECT_EQ(arithmetic.undecorated, 0) << name;
    EXPECT_EQ(arithmetic.fusedMultiplyAdds, 0) << name;
    report(name + ": " + describe(arithmetic));
  }
}

Arithmetic total(const std::map<std::string, Arithmetic>& functions) {
  Arithmetic sum;
  for (const auto& [name, arithmetic] : functions) sum += arithmetic;
  return sum;
}

// The optimizer makes Fma of what is not marked. It inlines everything, so each function is looked at in a
// shader that has no arithmetic but that function's, compiled as the renderer's shader is.
TEST(SpirvGate, SurvivesTheOptimizer) {
  std::map<std::string, Arithmetic> named = arithmeticOf(renderNamedSpirv);
  struct Gate {
    const char* name;
    std::span<const std::uint32_t> spirv;
    int least;  // operations that must be left
  };
  const int dot = named["preciseDot"].decorated;
  const int offsets = named["pointOnPlane"].decorated + named["leave"].decorated + 2 * dot;
  for (const Gate& gate : {Gate{"constants of a ray", rayGateSpirv, named["rayConstants"].decorated},
                           Gate{"slab distances", boxGateSpirv, named["intersectBoxes"].decorated},
                           Gate{"edge functions", triangleGateSpirv, named["intersectTriangle"].decorated},
                           Gate{"spheres", sphereGateSpirv, named["intersectSphere"].decorated + 3 * dot},
                           Gate{"planes", planeGateSpirv, named["intersectPlane"].decorated + 2 * dot},
                           Gate{"offsets", offsetGateSpirv, offsets}}) {
    const Arithmetic arithmetic = total(arithmeticOf(gate.spirv));
    EXPECT_GE(arithmetic.decorated, gate.least) << gate.name;
    EXPECT_EQ(arithmetic.undecorated, 0) << gate.name;
    EXPECT_EQ(arithmetic.fusedMultiplyAdds, 0) << gate.name;
    report(std::string(gate.name) + ", optimized: " + describe(arithmetic));
  }
}

// The very modules that the programs run: nothing of what is marked is lost in them. That of few primitives
// has no boxes.
TEST(SpirvGate, SurvivesInTheRenderersShader) {
  std::map<std::string, Arithmetic> functions = arithmeticOf(renderNamedSpirv);
  const Arithmetic named = total(functions);
  EXPECT_GT(named.decorated, 0);
  const int ofBoxes = functions["intersectBoxes"].decorated + functions["decodeSides"].decorated;
  const Arithmetic general = total(arithmeticOf(renderSpirv));
  const Arithmetic few = total(arithmeticOf(renderFewPrimitivesSpirv));
  EXPECT_GE(general.decorated, named.decorated);
  EXPECT_GE(few.decorated, named.decorated - ofBoxes);
  report("the renderer's shader, optimized: " + describe(general) + "; of few primitives: " + describe(few) +
         "; before: " + describe(named));
}

}  // namespace
}  // namespace lavaray
