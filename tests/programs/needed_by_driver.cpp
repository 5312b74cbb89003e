// A library without an entry point for Vulkan, which another needs.
extern "C" __attribute__((visibility("default"))) int neededByDriver() {
  return 1;
}
