// A slider that is pushed ten times as fast as the reference slider for a hundred steps.
#include <rupture/checkpoint/checkpoint.hpp>
#include <rupture/dynamics/equilibrium.hpp>
#include <rupture/dynamics/simulation.hpp>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  rupture::Parameters parameters;
  parameters.V *= 10;
  rupture::Simulation simulation(parameters, rupture::normal_load_equilibrium(parameters));
  simulation.advance(100);
  const auto provenance = rupture::make_provenance("my_program", {argv, argv + argc}, "");
  rupture::write_checkpoint(argv[1], {parameters, simulation.state(), {provenance}},
                            rupture::IfExists::refuse);
}
