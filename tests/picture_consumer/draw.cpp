// draw FILE OFFSET: draws a gradient that is so much brighter.
#include <cstdlib>
#include <fstream>

int main(int count, char** arguments) {
  if (count != 3) return 2;
  std::ofstream file(arguments[1], std::ios::binary);
  file << "P6 64 48 255\n";
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      file.put(static_cast<char>(3 * x + std::atoi(arguments[2])));
      file.put(static_cast<char>(4 * y));
      file.put(static_cast<char>(128));
    }
  }
  return file.good() ? 0 : 1;
}
