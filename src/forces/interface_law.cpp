#include "rupture/forces/interface_law.hpp"

#include "rupture/forces/decaying_law.hpp"
#include "rupture/forces/reference_law.hpp"
#include "rupture/forces/simplified_law.hpp"

namespace rupture {
namespace {

template <class OfLaw>
struct Type {
  using type = OfLaw;
};

/// action(Type<...>) with the class of the law. No other function lists them.
template <class Action>
auto with_class_of(Law law, Action action) {
  switch (law) {
    case Law::reference:
      break;
    case Law::simplified:
      return action(Type<SimplifiedLaw>{});
    case Law::decaying:
      return action(Type<DecayingLaw>{});
  }
  return action(Type<ReferenceLaw>{});
}

}  // namespace

std::unique_ptr<InterfaceLaw> make_law(const Parameters& parameters, Junctions& junctions) {
  return with_class_of(parameters.law, [&](auto chosen) -> std::unique_ptr<InterfaceLaw> {
    return std::make_unique<typename decltype(chosen)::type>(parameters, junctions);
  });
}

void break_by_law(const Parameters& parameters, Junctions& junctions, Eigen::Index i,
                  Eigen::Index j, double u, double w, double t) {
  with_class_of(parameters.law, [&](auto chosen) {
    decltype(chosen)::type::break_spring(parameters, junctions, i, j, u, w, t);
  });
}

}  // namespace rupture
