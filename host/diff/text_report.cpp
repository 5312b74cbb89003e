#include "diff/text_report.hpp"

#include <algorithm>
#include <iostream>

#include "command_line/shown.hpp"

namespace lavaray {
namespace {

std::string position(int x, int y) {
  return std::to_string(x) + "," + std::to_string(y);
}

void printNotes(const char* name, const Image& image) {
  for (const std::string& note : image.source.notes)
    std::cout << "note         " << name << ' ' << note << '\n';
}

void printDifference(const Difference& difference, double flip) {
  const ChannelDifference& color = difference.color;
  std::cout << "differing    " << difference.differing << " of " << difference.pixels << " pixels\n"
            << "largest      " << color.largest * 255.0 << " / 255 at " << position(color.x, color.y) << '\n'
            << "RMSE         " << color.rmse << '\n'
            << "PSNR         " << psnr(color.rmse) << " dB\n"
            << "mean FLIP    " << flip << '\n';
}

void printAlpha(const Image& image, const Image& reference, const ChannelDifference& alpha) {
  if (image.alpha.empty() && reference.alpha.empty()) return;
  std::cout << "alpha        " << alpha.differing << " pixels differ, largest " << alpha.largest * 255.0
            << " / 255 at " << position(alpha.x, alpha.y) << ", RMSE " << alpha.rmse;
  if (image.alpha.empty()) std::cout << "; IMAGE has none, which is 1";
  if (reference.alpha.empty()) std::cout << "; REFERENCE has none, which is 1";
  std::cout << '\n';
}

void printNotFinite(const Difference& difference) {
  const std::size_t notFinite = difference.pixels - difference.finite;
  if (notFinite == 0) return;
  std::cout << "not finite   " << difference.unlike << " pixels differ by infinity or NaN";
  if (difference.unlike > 0)
    std::cout << ", the first at " << position(difference.unlikeX, difference.unlikeY);
  std::cout << "; " << notFinite - difference.unlike << " are the same in both\n"
            << "finite       " << difference.finite
            << " pixels in both images: largest, RMSE, PSNR, mean FLIP and alpha are over these\n";
}

std::string sizeOf(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

const char* wordFor(Verdict verdict) {
  switch (verdict) {
    case Verdict::kAlike:
      return "alike";
    case Verdict::kImageMissing:
    case Verdict::kReferenceMissing:
      return "missing";
    case Verdict::kUnreadable:
      return "unreadable";
    default:
      return "differs";
  }
}

}  // namespace

bool isCompared(const ComparedPair& compared) {
  return compared.verdict == Verdict::kAlike || compared.verdict == Verdict::kDiffers;
}

void printPair(const ComparedPair& compared) {
  if (!compared.image || !compared.reference) return;
  std::cout << "size         " << sizeOf(*compared.image) << '\n';
  printNotes("IMAGE", *compared.image);
  printNotes("REFERENCE", *compared.reference);
  if (!isCompared(compared)) {
    std::cout << "reference    " << sizeOf(*compared.reference) << '\n';
    return;
  }
  if (!compared.comparedAs.empty()) std::cout << "compared as  " << compared.comparedAs << '\n';
  printDifference(compared.difference, compared.flip);
  printAlpha(*compared.image, *compared.reference, compared.difference.alpha);
  printNotFinite(compared.difference);
}

void printLine(const ComparedPair& compared) {
  const Difference& difference = compared.difference;
  std::string word = wordFor(compared.verdict);
  word.resize(13, ' ');
  std::cout << word << shown(compared.pair.name);
  switch (compared.verdict) {
    case Verdict::kAlike:
    case Verdict::kDiffers:
      if (difference.differing == 0 && compared.verdict == Verdict::kAlike) break;
      std::cout << ": " << difference.differing << " of " << difference.pixels << " pixels, largest "
                << difference.color.largest * 255.0 << " / 255 at "
                << position(difference.color.x, difference.color.y) << ", RMSE " << difference.color.rmse
                << ", mean FLIP " << compared.flip;
      break;
    case Verdict::kSizesDiffer:
      std::cout << ": " << sizeOf(*compared.image) << ", the reference " << sizeOf(*compared.reference);
      break;
    case Verdict::kImageMissing:
      std::cout << ": there is no such image to compare with the reference";
      break;
    case Verdict::kReferenceMissing:
      std::cout << ": there is no reference";
      break;
    case Verdict::kUnreadable:
      std::cout << ": " << compared.problem;
      break;
  }
  std::cout << '\n';
}

void printSummary(const std::vector<Verdict>& verdicts) {
  const auto count = [&](const char* word) {
    return std::count_if(verdicts.begin(), verdicts.end(),
                         [&](Verdict verdict) { return std::string(wordFor(verdict)) == word; });
  };
  std::cout << "pairs        " << verdicts.size() << ": " << count("alike") << " alike, " << count("differs")
            << " different, " << count("missing") << " without a partner, " << count("unreadable")
            << " unreadable\n";
}

}  // namespace lavaray
