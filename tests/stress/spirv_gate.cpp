// Whether the compiled shaders still say what makes the tests of rays exact: no operation of the edge
// functions, the slab distances and the offsets may be contracted into a fused multiply-add.
#include <gtest/gtest.h>

#include <array>
#include <span>

#include "boxGateSpirv.spv.h"
#include "offsetGateSpirv.spv.h"
#include "renderNamedSpirv.spv.h"
#include "renderSpirv.spv.h"
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

constexpr std::array kGuarded{"intersectBoxes", "decodeSides",   "intersectTriangle", "preciseDot",
                              "pointOnPlane",   "pointOnSphere", "pointOnTriangle",   "leave"};

// In the renderer's shader before optimization, where functions still have names.
TEST(SpirvGate, MarksEdgesSlabsAndOffsetsNoContraction) {
  const std::map<std::string, Arithmetic> functions = arithmeticOf(renderNamedSpirv);
  for (const char* name : kGuarded) {
    ASSERT_TRUE(functions.contains(name)) << "render.comp has no function " << name << " any more";
    const Arithmetic& arithmetic = functions.at(name);
    EXPECT_GT(arithmetic.decorated, 0) << name;
    EXPECT_EQ(arithmetic.undecorated, 0) << name;
    EXPECT_EQ(arithmetic.fusedMultiplyAdds, 0) << name;
    report(std::string(name) + ": " + describe(arithmetic));
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
  const int offsets =
      named["pointOnPlane"].decorated + named["leave"].decorated + 2 * named["preciseDot"].decorated;
  for (const Gate& gate : {Gate{"slab distances", boxGateSpirv, named["intersectBoxes"].decorated},
                           Gate{"edge functions", triangleGateSpirv, named["intersectTriangle"].decorated},
                           Gate{"offsets", offsetGateSpirv, offsets}}) {
    const Arithmetic arithmetic = total(arithmeticOf(gate.spirv));
    EXPECT_GE(arithmetic.decorated, gate.least) << gate.name;
    EXPECT_EQ(arithmetic.undecorated, 0) << gate.name;
    EXPECT_EQ(arithmetic.fusedMultiplyAdds, 0) << gate.name;
    report(std::string(gate.name) + ", optimized: " + describe(arithmetic));
  }
}

// The very module that the programs run: nothing of what is marked is lost in it.
TEST(SpirvGate, SurvivesInTheRenderersShader) {
  const Arithmetic optimized = total(arithmeticOf(renderSpirv));
  const Arithmetic named = total(arithmeticOf(renderNamedSpirv));
  EXPECT_GT(named.decorated, 0);
  EXPECT_GE(optimized.decorated, named.decorated);
  report("the renderer's shader, optimized: " + describe(optimized) + "; before: " + describe(named));
}

}  // namespace
}  // namespace lavaray
