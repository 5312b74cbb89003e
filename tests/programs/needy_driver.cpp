// A library that cannot be loaded where the one that it needs is missing.
extern "C" int neededByDriver();

extern "C" __attribute__((visibility("default"))) int needyDriver() {
  return neededByDriver();
}
