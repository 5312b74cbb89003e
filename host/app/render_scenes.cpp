#include "app/render_scenes.hpp"

#include "app/render_context.hpp"
#include "app/session.hpp"

namespace lavaray {

ExitCode renderScene(const Options& options) {
  RenderContext context(options);
  Session session(options, context);
  context.progress.begin("reading the scene");
  session.inputs().readScene({});
  session.times().endStep("read scene");
  context.progress.begin("compiling the shaders");
  if (session.inputs().compileShaders({})) session.times().endStep("compile shaders");
  session.printWarnings();
  const ExitCode code = session.renderAndWrite();
  session.viewer().waitUntilClosed();
  return session.viewer().hasFailed() && code == ExitCode::kSuccess ? ExitCode::kOutput : code;
}

}  // namespace lavaray
