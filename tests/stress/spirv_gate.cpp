// Whether the shaders that the driver gets still say what makes their arithmetic the same everywhere: no
// operation may be contracted into a fused multiply-add, reordered or replaced, and none is used whose result
// is the driver's choice.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "render2RaysSpirv.spv.h"
#include "render4RaysSpirv.spv.h"
#include "renderFewPrimitivesSpirv.spv.h"
#include "renderFromStorage2RaysSpirv.spv.h"
#include "renderFromStorage4RaysSpirv.spv.h"
#include "renderFromStorageSpirv.spv.h"
#include "renderSpirv.spv.h"
#include "renderUnfinishedSpirv.spv.h"
#include "stress/report.hpp"
#include "stress/spirv_arithmetic.hpp"

namespace lavaray {
namespace {

// The functions of GLSL.std.450 that the shaders may use. Those of the first row choose a value or change a
// sign. The others had the same bits in each version of Mesa's software driver, 22.3 to 26.2, on all that was
// tried; others differ there, like Fma (50), Length (66), Normalize (69), FMix (46), Acos (17) and Atan2
// (25).
const std::map<std::uint32_t, const char*> kBuiltIns{
    {4, "FAbs"}, {37, "FMin"}, {38, "UMin"}, {40, "FMax"}, {41, "UMax"}, {43, "FClamp"},  //
    {13, "Sin"}, {14, "Cos"},  {26, "Pow"},  {29, "Exp2"}, {31, "Sqrt"},
};

// Before they are marked, most operations are not; so this knows the difference.
TEST(SpirvGate, SeesWhatIsNotMarked) {
  const Arithmetic arithmetic = arithmeticOf(renderUnfinishedSpirv);
  EXPECT_GT(arithmetic.others, 100);  // of functions that are not inlined yet
  EXPECT_EQ(arithmetic.exact, 0);
}

void expectExactOnly(const std::string& name, std::span<const std::uint32_t> spirv) {
  const Arithmetic arithmetic = arithmeticOf(spirv);
  EXPECT_GT(arithmetic.exact, 300) << name;
  EXPECT_EQ(arithmetic.others, 0) << name;
  EXPECT_EQ(arithmetic.products, 0) << name
                                    << ": dot() and products with matrices add in an order of the driver's";
  std::string names;
  for (const std::uint32_t number : arithmetic.builtIns) {
    EXPECT_TRUE(kBuiltIns.contains(number)) << name << ": GLSL.std.450 " << number;
    if (kBuiltIns.contains(number)) names += std::string(" ") + kBuiltIns.at(number);
  }
  report(name + ": " + std::to_string(arithmetic.exact) + " operations NoContraction, " +
         std::to_string(arithmetic.others) + " not, " + std::to_string(arithmetic.products) +
         " products of vectors; built-in functions" + names);
}

TEST(SpirvGate, HasExactArithmeticOnly) {
  expectExactOnly("the renderer's shader", renderSpirv);
  expectExactOnly("of few primitives", renderFewPrimitivesSpirv);
  expectExactOnly("from storage buffers", renderFromStorageSpirv);
  expectExactOnly("of two rays", render2RaysSpirv);
  expectExactOnly("of four rays", render4RaysSpirv);
  expectExactOnly("of two rays from storage buffers", renderFromStorage2RaysSpirv);
  expectExactOnly("of four rays from storage buffers", renderFromStorage4RaysSpirv);
}

}  // namespace
}  // namespace lavaray
