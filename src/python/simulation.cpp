// The module behind rupture.Simulation (python/rupture/simulation.py): a Simulation of the library
// with its arrays as those of NumPy. All that is computed is computed by the library.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <unistd.h>

#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/dynamics/condition.hpp"
#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/dynamics/guard.hpp"
#include "rupture/dynamics/run.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/laws.hpp"

namespace py = pybind11;

namespace rupture {
namespace {

/// Looks at the run as load and restart do, which stop at an alarm.
class Alarms : public Observer {
 public:
  explicit Alarms(const Simulation& simulation)
      : guard_(simulation), next_(simulation.state().step) {}

  std::int64_t next_step() const override { return next_; }

  void observe(const Simulation& simulation) override {
    next_ = next_look(simulation.state().step);
    for (const Finding& finding : guard_.look(simulation)) {
      if (finding.severity == Severity::alarm) throw Failure(finding.sentence);
    }
  }

 private:
  Guard guard_;
  std::int64_t next_;
};

/// Calls `use` with the name in files, the first element, the shape and the elements from one row
/// to the next of each array of the state.
template <class Use>
void each_array(State& state, const Use& use) {
  const auto use_field = [&](const char* name, Field& field) {
    use(name, field.row(0), field.Nz(), field.Nx(), field.stride());
  };
  use_field("u_x", state.u_x);
  use_field("u_z", state.u_z);
  use_field("v_x", state.v_x);
  use_field("v_z", state.v_z);
  use_field("f_x", state.f_x);
  use_field("f_z", state.f_z);
  const auto use_junctions = [&](std::string_view name, auto& array) {
    if (array.size() == 0) return;
    use(fmt::format("junctions/{}", name), array.data(), array.rows(), array.cols(), array.cols());
  };
  Junctions& junctions = state.junctions;
  use_junctions("attachment", junctions.attachment);
  use_junctions("repin_time", junctions.repin_time);
  use_junctions("draws", junctions.draws);
  for (const LawInfo& law : law_table()) {
    if (law.memory) use_junctions(law.memory->name, junctions.*law.memory->array);
  }
}

/// Copies all of them.
void copy_arrays(State& state, std::string& copy) {
  copy.clear();
  each_array(state, [&](const std::string&, const auto* row, auto rows, auto cols, auto stride) {
    for (; rows > 0; --rows, row += stride) {
      const auto bytes = std::as_bytes(std::span(row, static_cast<std::size_t>(cols)));
      copy.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
  });
}

py::array read_only(py::array array) {
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

using Settings = std::vector<std::pair<std::string, std::string>>;  // names and texts of parameters

Parameters with(Parameters parameters, const Settings& settings) {
  for (const auto& [name, text] : settings) set_parameter(parameters, name, text);
  return parameters;
}

class Model {
 public:
  /// `source`: the file of `start`, empty if there is none.
  Model(Checkpoint start, std::filesystem::path source, std::optional<int> threads)
      : source_(std::move(source)),
        provenance_(std::move(start.provenance)),
        checksum_(std::move(start.checksum)),
        threads_(threads.value_or(default_thread_count(start.parameters))) {
    begin(start.parameters, std::move(start.state), start.run ? start.run->event : LatestEvent{});
  }

  void step(std::int64_t steps);
  void set(const Settings& settings);
  /// Returns the content checksum. `program`: argv, for the provenance.
  std::string save(const std::filesystem::path& path, IfExists if_exists,
                   const std::vector<std::string>& program);

  /// The simulation between two steps,
  Simulation& between_steps() {
    if (getpid() != process_) throw UsageError("a fork of this process cannot use its simulations");
    if (is_stepping_) throw UsageError("another thread steps this simulation: wait for it");
    return *simulation_;
  }
  /// and with what follows from all that was written into its arrays.
  Simulation& now() {
    State& state = between_steps().state_to_change();
    if (has_views_) copy_arrays(state, now_);
    if (has_views_ && now_ != seen_) take_changes();
    return *simulation_;
  }
  py::dict views();
  py::dict derived();
  Settings parameters();

 private:
  struct Stepping {
    explicit Stepping(Model& owner) : model(owner) { model.is_stepping_ = true; }
    Stepping(const Stepping&) = delete;
    Stepping& operator=(const Stepping&) = delete;
    ~Stepping() {
      model.is_stepping_ = false;
      if (model.has_views_) copy_arrays(model.simulation_->state_to_change(), model.seen_);
    }
    Model& model;
  };

  void begin(const Parameters& parameters, State state, LatestEvent event) {
    simulation_ = std::make_shared<Simulation>(parameters, std::move(state), threads_);
    has_views_ = false;
    follow(std::move(event));
  }
  /// What follows is a run of its own, in the same event.
  void follow(LatestEvent event) {
    const std::int64_t step = simulation_->state().step;
    simulation_->resume_from(run_from(simulation_->parameters(), step, std::move(event)));
    alarms_.emplace(*simulation_);
  }
  void take_changes();
  /// Keeps the arrays alive while NumPy uses them.
  py::capsule owner() const {
    using Shared = std::shared_ptr<Simulation>;
    return {new Shared(simulation_), [](void* shared) { delete static_cast<Shared*>(shared); }};
  }

  const std::filesystem::path source_;
  const std::vector<ProvenanceEntry> provenance_;
  const std::string checksum_;
  const int threads_;  // which a fork lacks
  const pid_t process_ = getpid();
  std::shared_ptr<Simulation> simulation_;
  std::optional<Alarms> alarms_;
  bool is_stepping_ = false;
  bool has_views_ = false;
  std::string seen_, now_;  // the arrays as the last step left them, if there are views, and now
};

/// What a file could not hold is refused as if it were in one.
void Model::take_changes() {
  const Content content =
      checkpoint_content({simulation_->parameters(), simulation_->state(), {}, {}, {}});
  check_finite(content);
  checkpoint_from(content);
  LatestEvent event = simulation_->run().event;
  simulation_->state_was_changed();
  follow(std::move(event));
  seen_ = now_;
}

void Model::step(std::int64_t steps) {
  check_arithmetic();  // other modules may have changed how this thread rounds
  Simulation& simulation = now();
  StopRule rule = {.last_step = simulation.state().step + steps};
  rule.interrupted = [] {
    const py::gil_scoped_acquire gil;
    return PyErr_CheckSignals() != 0;
  };
  const Stepping stepping(*this);
  Ending ending = Ending::last_step;
  {
    const py::gil_scoped_release free;
    ending = run(simulation, rule, {&*alarms_});
  }
  if (ending == Ending::interrupted) throw py::error_already_set();
}

void Model::set(const Settings& settings) {
  const Simulation& before = now();
  const Parameters after = with(before.parameters(), settings);
  begin(after, continued(before.state(), after), before.run().event);
}

std::string Model::save(const std::filesystem::path& path, IfExists if_exists,
                        const std::vector<std::string>& program) {
  const Simulation& simulation = now();
  const State& state = simulation.state();
  std::error_code none;  // if one of them is not there
  if (std::filesystem::equivalent(path, source_, none)) {
    throw UsageError("{} is what this simulation began with: give another name", path.string());
  }
  if (if_exists == IfExists::refuse && is_there(path)) {
    throw Failure("{} exists; give force=True to replace it", path.string());
  }
  check_output(path, if_exists);
  alarms_->observe(simulation);
  auto chain = provenance_;
  chain.push_back(make_provenance("python", program, checksum_));
  const Parameters& p = simulation.parameters();
  return write_checkpoint(
      path, {p, state, chain, run_from(p, state.step, simulation.run().event), {}}, if_exists);
}

py::dict Model::views() {
  State& state = between_steps().state_to_change();
  py::dict all;
  const auto add = [&](const std::string& name, auto* first, Eigen::Index rows, Eigen::Index cols,
                       Eigen::Index stride) {
    constexpr Eigen::Index size = sizeof *first;
    const auto type = py::dtype::of<std::remove_pointer_t<decltype(first)>>();
    all[name.c_str()] = py::array(type, std::vector<Eigen::Index>{rows, cols},
                                  std::vector<Eigen::Index>{stride * size, size}, first, owner());
  };
  each_array(state, add);
  if (!has_views_) copy_arrays(state, seen_);
  has_views_ = true;
  return all;
}

py::dict Model::derived() {
  const Simulation& simulation = now();
  const auto view = [&](std::span<const double> values) {
    return read_only(py::array_t<double>(std::ssize(values), values.data(), owner()));
  };
  const auto& pinned = simulation.pinned();
  py::dict all;
  all["p"] = view(simulation.p());
  all["tau"] = view(simulation.tau());
  all["pinned"] = read_only(py::array_t<std::int32_t>(std::ssize(pinned), pinned.data()));
  return all;
}

Settings Model::parameters() {
  const Parameters& p = between_steps().parameters();
  Settings all;
  for (const ParameterInfo& info : parameter_table()) {
    all.emplace_back(info.name, parameter_text(p, info));
  }
  return all;
}

std::unique_ptr<Model> opened(const std::string& path, std::optional<int> threads) {
  Checkpoint start = read_checkpoint(path);
  refuse_state_of_alarm(start, path);
  return std::make_unique<Model>(std::move(start), std::filesystem::absolute(path), threads);
}

std::unique_ptr<Model> loaded(const Settings& settings, std::optional<int> threads) {
  const Parameters p = with({}, settings);
  validate(p);
  const py::gil_scoped_release free;
  Checkpoint start = {p, normal_load_equilibrium(p), {}, {}, {}};
  start.checksum = content_checksum(checkpoint_content(start));
  return std::make_unique<Model>(std::move(start), std::filesystem::path{}, threads);
}

/// The errors of the library are those of rupture.errors.
void translate(std::exception_ptr error) {
  const auto raise = [](const char* name, const std::exception& what) {
    const auto sentence = py::reinterpret_steal<py::str>(PyUnicode_DecodeFSDefault(what.what()));
    PyErr_SetObject(py::module_::import("rupture.errors").attr(name).ptr(), sentence.ptr());
  };
  try {
    std::rethrow_exception(std::move(error));
  } catch (const UsageError& what) {
    raise("UsageError", what);
  } catch (const MachineFailure& what) {
    raise("MachineFailure", what);
  } catch (const Failure& what) {
    raise("Failure", what);
  }
}

}  // namespace

PYBIND11_MODULE(rupture_simulation, module) {
  kernels();  // checks the arithmetic
  py::register_exception_translator(&translate);
  module.def("opened", &opened);
  module.def("loaded", &loaded);
  py::class_<Model>(module, "Model")
      .def("step", &Model::step)
      .def("set", &Model::set)
      .def("save",
           [](Model& model, const std::string& path, bool force,
              const std::vector<std::string>& program) {
             return model.save(path, force ? IfExists::replace : IfExists::refuse, program);
           })
      .def("views", &Model::views)
      .def("derived", &Model::derived)
      .def("parameters", &Model::parameters)
      .def("steps_done", [](Model& model) { return model.between_steps().state().step; })
      .def("time", [](Model& model) { return model.between_steps().time(); })
      .def("springs",
           [](Model& model) { return springs_per_block(model.between_steps().parameters()); })
      .def("F_T", [](Model& model) { return model.now().F_T(); })
      .def("what_holds",
           [](Model& model, const std::string& condition) {
             const Simulation& now = model.now();
             return Condition(condition, now.parameters()).what_holds(now);
           })
      .def("step_at", [](Model& model, double t) {
        const Simulation& now = model.between_steps();
        return step_at(now.parameters(), now.state().clock, t);
      });
}

}  // namespace rupture
