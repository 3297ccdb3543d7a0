#include "rupture/forces/interface_law.hpp"

#include <type_traits>

#include "rupture/forces/decaying_law.hpp"
#include "rupture/forces/distance_law.hpp"
#include "rupture/forces/reference_law.hpp"
#include "rupture/forces/simplified_law.hpp"
#include "rupture/model/laws.hpp"

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
    case Law::distance:
      return action(Type<DistanceLaw>{});
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

void change_law(const Parameters& before, const Parameters& after, double t, Junctions& junctions) {
  const LawInfo &old_law = law_info(before.law), &new_law = law_info(after.law);
  const bool both_at_a_drawn_time = old_law.repinning == Repinning::at_a_drawn_time &&
                                    new_law.repinning == Repinning::at_a_drawn_time;
  if (before.law == after.law || both_at_a_drawn_time) return;
  if (old_law.memory) (junctions.*old_law.memory->array).resize(0, 0);
  if (new_law.memory) (junctions.*new_law.memory->array).setZero(after.Nx, junctions.draws.cols());
  with_class_of(after.law, [&](auto chosen) {
    using NewLaw = typename decltype(chosen)::type;
    if constexpr (std::is_base_of_v<JunctionLaw<NewLaw>, NewLaw>) {
      for (Eigen::Index i = 0; i < junctions.repin_time.rows(); ++i) {
        for (Eigen::Index j = 0; j < junctions.repin_time.cols(); ++j) {
          if (!is_slipping(junctions.repin_time(i, j))) continue;
          NewLaw::start_slipping(after, junctions, i, j, t);
        }
      }
    }
  });
}

}  // namespace rupture
