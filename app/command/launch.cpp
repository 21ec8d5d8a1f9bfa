#include <ringwatch/app/command/launch.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <string_view>

namespace ringwatch {

std::optional<Launch> launchOf(const std::function<const char*(const char*)>& environment) {
  const auto number = [&](const char* variable) -> std::optional<int> {
    const char* text = environment(variable);
    if (!text) return std::nullopt;
    const std::string_view digits(text);
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size() ? std::optional(value) : std::nullopt;
  };
  struct Variables {
    const char *rank, *size;
  };
  // Slurm sets the last pair in batch scripts too, so it counts with PMIx alone, which only a started process has.
  constexpr std::array<Variables, 3> known{{{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                            {"PMI_RANK", "PMI_SIZE"},
                                            {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}}};
  for (const Variables& variables : known) {
    const auto rank = number(variables.rank), size = number(variables.size);
    if (rank && size && *rank >= 0 && *rank < *size) return Launch{*rank, *size};
  }
  return std::nullopt;
}

RanksWanted ranksWantedBy(int argc, char** argv) {
  constexpr std::string_view option = "--ranks";
  for (int i = 2; i < argc; ++i) {
    const std::string_view word(argv[i]);
    std::string_view value;
    if (word == option && i + 1 < argc)
      value = argv[i + 1];
    else if (word.starts_with(option) && word.size() > option.size() && word[option.size()] == '=')
      value = word.substr(option.size() + 1);
    if (value == "yes") return RanksWanted::yes;
    if (value == "no") return RanksWanted::no;
  }
  return RanksWanted::automatic;
}

bool runsOnRanks(int argc, char** argv) {
  const std::string_view command(argc < 2 ? "" : argv[1]);
  if (command != "run" && command != "inspect") return false;
  const RanksWanted wanted = ranksWantedBy(argc, argv);
  if (wanted != RanksWanted::automatic) return wanted == RanksWanted::yes;
  const std::optional<Launch> launch = launchOf([](const char* variable) { return std::getenv(variable); });
  return launch && launch->size > 1;
}

}  // namespace ringwatch
