#include "simplify/cost/method_names.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "simplify/cost/policies.h"

namespace limber {
namespace {

template <size_t... rows>
std::vector<std::string> namesOf(std::index_sequence<rows...>) {
  return {std::string(std::tuple_element_t<rows, CostPolicies>::kName)...};
}

}  // namespace

Method methodNamed(std::string_view name) {
  const auto names = namesOf(std::make_index_sequence<std::tuple_size_v<CostPolicies>>());
  std::string choices;
  for (size_t row = 0; row < names.size(); ++row) {
    if (names[row] == name) return static_cast<Method>(row);
    choices += (row == 0 ? "" : row + 1 < names.size() ? ", " : " or ") + names[row];
  }
  throw std::invalid_argument("There is no method \"" + std::string(name) + "\": take " + choices + ".");
}

}  // namespace limber
