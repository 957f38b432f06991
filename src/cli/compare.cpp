#include "output/compare.h"

#include <fmt/format.h>

#include "cli/commands.h"

namespace weir {

namespace {

struct CompareCommand {
  std::string a;
  std::string b;
  ComparisonOptions comparison;
  std::string difference;
  bool json = false;
};

// Unreadable files are mistakes of the command line here, not failures of output.
ComparisonResult compare_files(const CompareCommand& options) {
  try {
    return compare(options.a, options.b, options.comparison);
  } catch (const OutputError& error) {
    throw UsageError(error.what());
  }
}

ExitCode compare_two(const CompareCommand& options) {
  ComparisonResult result = compare_files(options);
  if (!options.difference.empty()) {
    ComparisonOptions with_picture = options.comparison;
    with_picture.difference = options.difference;
    result = compare(options.a, options.b, with_picture);  // both are readable: errors from here on are of writing
  }
  if (options.json) {
    fmt::print("{}", result.json());
  } else {
    fmt::print("{}{}\n", result.text(), result.same ? "the same" : "different");
  }
  return result.same ? ExitCode::done : ExitCode::internal;
}

}  // namespace

void add_compare(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("compare", "Compare two images, movies or run folders");
  const auto options = std::make_shared<CompareCommand>();
  command->add_option("a", options->a, "A .png, an .mp4 or a run folder")->type_name("A")->required();
  command->add_option("b", options->b, "Another of the same kind")->type_name("B")->required();
  command
      ->add_option("--tolerance", options->comparison.max,
                   "Largest difference of a colour channel that does not count, 0 to 255; default: 0")
      ->type_name("N")
      ->check(CLI::Range(0, 255));
  command
      ->add_option("--fraction", options->comparison.fraction,
                   "Fraction of the pixels of a picture that may differ by more, 0 to 1; default: 0")
      ->type_name("F")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--difference", options->difference, "Write the largest difference as a picture")
      ->type_name("FILE.png");
  command->add_flag("--json", options->json, "As a JSON object");
  command->footer(
      "Exit 0: the same within the tolerance. Exit 1: different. With a tolerance, run folders are compared by their\n"
      "pictures; without one, by particles and log as well.");
  command->callback([&action, options] { action = [options] { return compare_two(*options); }; });
}

}  // namespace weir
