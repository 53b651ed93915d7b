#include "brindle/gpu_animator.h"

#include <algorithm>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gpu/gpu_hierarchy.h"
#include "brindle/gpu/gpu_kernels.h"
#include "brindle/gpu/gpu_measure.h"
#include "brindle/gpu/gpu_relaxation.h"
#include "brindle/gpu/stage_trace.h"
#include "brindle/phase_graph.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/sliced_waves.h"
#include "brindle/pipeline/frames/frame_input.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

/// Bindings of kernels in addition to those of the levels.
enum Binding : unsigned {
  kPositions = 1,
  kDirections = 2,
  kFrequencies = 3,
  kLoadedWaves = 4,
  kLoadedLastWaves = 5,
  kLoadedLastPhases = 6,
  kLoadedTurnedPhases = 7,
  kCoupledWaves = 5,
  kCoupledLastPhases = 6,
  kFinishedLastPhases = 5,
  kPhasesByNode = 7
};

constexpr GLint kLast = 0;                                 // of load_waves
constexpr int kNoLast = 0, kByLastWaves = 1, kByNode = 2;  // what it is
constexpr GLint kLambda = 0;                               // of couple
constexpr GLint kTrapezoid = 1;                            // of couple

/// One list of the caller's input, on host and device.
template <class Item>
struct InputList {
  std::vector<Item> kept;  ///< of the last completed frame
  bool differs = true;     ///< whether the last compared list differs from `kept`
  GlBuffer buffer;
  bool buffer_is_kept = false;

  bool compare(std::span<const Item> now) {
    differs = !std::equal(now.begin(), now.end(), kept.begin(), kept.end());
    return differs;
  }
  /// Uploads changes.
  void upload(std::span<const Item> now, const char* what) {
    if (buffer_is_kept && !differs) return;
    buffer_is_kept = false;
    if (buffer == 0) {
      buffer = make_buffer(now.size_bytes(), now.data(), what, GL_DYNAMIC_STORAGE_BIT);
    } else {
      glNamedBufferSubData(buffer, 0, static_cast<GLsizeiptr>(now.size_bytes()), now.data());
    }
  }
  void keep(std::span<const Item> now) {
    if (!buffer_is_kept) kept.assign(now.begin(), now.end());
    buffer_is_kept = true;
  }
};

/// The caller's input.
struct Input {
  InputList<Vec3> positions, directions;
  InputList<float> frequencies;
  bool is_last = false;  ///< whether `kept` is the input of the last frame
  GlFence read;          ///< signalled after the last frame has read the buffers

  /// Whether the input differs from that of the last frame.
  bool compare(const FrameInput& now) {
    bool differs = positions.compare(now.positions);
    differs |= directions.compare(now.directions);
    differs |= frequencies.compare(now.frequencies);
    return differs || !is_last;
  }
  WaveBuffers upload(const FrameInput& now) {
    // NVIDIA's driver lets small writes overtake shaders that still read the old content.
    read.await();
    positions.upload(now.positions, "positions");
    directions.upload(now.directions, "directions");
    frequencies.upload(now.frequencies, "frequencies");
    return {positions.buffer, directions.buffer, frequencies.buffer};
  }
  void keep(const FrameInput& now) {
    positions.keep(now.positions);
    directions.keep(now.directions);
    frequencies.keep(now.frequencies);
    is_last = true;
  }
};

template <class Item>
std::vector<Item> read_buffer(GLuint buffer, std::size_t count) {
  std::vector<Item> items(count);
  glGetNamedBufferSubData(buffer, 0, static_cast<GLsizeiptr>(count * sizeof(Item)), items.data());
  return items;
}

}  // namespace

struct GpuAnimator::State {
  std::shared_ptr<const GpuKernels> kernels;
  std::shared_ptr<const Adjacency> neighborhood;
  AnimatorOptions options;
  double topology_milliseconds = 0;

  std::shared_ptr<const GpuTopology> topology;  ///< null before the first frame
  std::optional<GpuHierarchy> hierarchy;
  std::optional<GpuRelaxation> relaxation;  ///< for the relaxation solver only
  std::optional<GpuMeasure> measure;
  GlBuffer waves, last_z, z_by_node;  ///< of the last frame
  GlBuffer next_waves;                ///< of the present frame
  GlBuffer turned_z;                  ///< the last phases, turned with their directions
  std::vector<Complex>
      given_z;     ///< phases that the next frame continues instead, by node; or empty
  GlBuffer given;  ///< on the device
  Input input;
  RelaxedFrequencySolver relaxed;
  RestNormals in_place;
  FrameSewing sewing;
  bool has_frame = false;   ///< whether a frame has been completed
  bool is_sibling = false;  ///< whether the topology is shared
  bool has_last = false;
  bool forgets_momenta = false;  ///< before the next frame

  bool follows() const { return has_last || !given_z.empty(); }
  bool starts_afresh() const {
    return !follows() || (options.solver == FrameSolver::multilevel && options.lambda == 0);
  }

  int frames = 0;
  int measured_frames = 0;
  bool measures = false;
  std::optional<FrameMeasure> measured;
  StageTimer timer;
  std::size_t dispatches = 0;

  void build(const FrameInput& first, const Progress& progress);
  void allocate();
  void load_waves(const WaveBuffers& buffers);
  void couple();
  void solve(const Progress& progress);
  void sew(const WaveBuffers& buffers);
  void keep();
  void take_back();
  void take_measure();
};

namespace {

/// A frame's input, read back from the device.
struct ReadInput {
  std::vector<Vec3> positions, directions;
  std::vector<float> frequencies;

  ReadInput(const WaveBuffers& buffers, std::size_t vertices)
      : positions(read_buffer<Vec3>(buffers.positions, vertices)),
        directions(read_buffer<Vec3>(buffers.directions, vertices)),
        frequencies(read_buffer<float>(buffers.frequencies, vertices)) {}

  operator FrameInput() const { return {positions, directions, frequencies}; }
};

/// The hierarchy of the first frame, used by all later ones, as in StripeAnimator.
Hierarchy first_hierarchy(std::shared_ptr<const Adjacency> neighborhood, const FrameInput& input,
                          PhaseShiftKind kind, const Progress& progress) {
  if (kind == PhaseShiftKind::common_source) {
    const WaveSet waves{{input.positions.begin(), input.positions.end()},
                        {input.directions.begin(), input.directions.end()},
                        {input.frequencies.begin(), input.frequencies.end()}};
    return build_hierarchy(build_phase_graph(std::move(neighborhood), waves, kind), progress);
  }
  Hierarchy hierarchy = finest_level(*neighborhood);
  Level& finest = hierarchy.levels[0];
  std::vector<SlicedWave> waves;
  brindle::load_waves(finest.layout(), input.positions, input.directions, input.frequencies, waves);
  std::vector<float> degree(finest.layout().slot_count());
  brindle::couple(finest.layout(), waves, kind, {}, finest.couplings, degree);
  coarsen(hierarchy, progress);
  return hierarchy;
}

}  // namespace

void GpuAnimator::State::build(const FrameInput& first, const Progress& progress) {
  if (hierarchy) return;
  if (!topology) {
    Stopwatch watch;
    const Hierarchy built = first_hierarchy(neighborhood, first, options.phase_shift, progress);
    topology = topology_of(built, options.sweeps);
    topology_milliseconds = watch.lap();
  }
  allocate();
}

void GpuAnimator::State::allocate() {
  const std::size_t slots = topology->level(0).slot_count;
  waves = make_buffer(slots * sizeof(SlicedWave), nullptr, "waves");
  next_waves = make_buffer(slots * sizeof(SlicedWave), nullptr, "waves");
  last_z = make_buffer(slots * sizeof(Complex), nullptr, "phases");
  turned_z = make_buffer(slots * sizeof(Complex), nullptr, "phases");
  z_by_node = make_buffer(topology->node_count() * sizeof(Complex), nullptr, "phases");
  GpuHierarchy levels(kernels, topology);
  if (options.solver == FrameSolver::relaxation) {
    relaxation.emplace(levels, SolverOptions().momentum);
  }
  hierarchy.emplace(std::move(levels));
}

void GpuAnimator::State::load_waves(const WaveBuffers& buffers) {
  topology->bind();
  bind_storage(kPositions, buffers.positions);
  bind_storage(kDirections, buffers.directions);
  bind_storage(kFrequencies, buffers.frequencies);
  bind_storage(kLoadedWaves, next_waves);
  bind_storage(kLoadedLastWaves, waves);
  bind_storage(kLoadedTurnedPhases, turned_z);
  if (!given_z.empty()) {
    given = make_buffer(given_z.size() * sizeof(Complex), given_z.data(), "phases");
  }
  bind_storage(kLoadedLastPhases, given_z.empty() ? last_z : given);
  const int last = given_z.empty() ? (has_last ? kByLastWaves : kNoLast) : kByNode;
  glProgramUniform1i(kernels->load_waves.name(), kLast, last);
  dispatch(kernels->load_waves, topology->level(0).slot_count);
}

void GpuAnimator::State::couple() {
  hierarchy->bind();
  bind_storage(kCoupledWaves, next_waves);
  bind_storage(kCoupledLastPhases, turned_z);
  const bool paper = options.phase_shift == PhaseShiftKind::common_source;
  const ShaderProgram& kernel = paper ? kernels->couple_common_source : kernels->couple;
  const bool anchored = follows() && options.solver == FrameSolver::multilevel;
  glProgramUniform1f(kernel.name(), kLambda, anchored ? options.lambda : 0);
  if (!paper) {
    const bool trapezoid = options.phase_shift == PhaseShiftKind::trapezoid;
    glProgramUniform1i(kernel.name(), kTrapezoid, trapezoid ? 1 : 0);
  }
  dispatch(kernel, topology->level(0).slot_count);
}

void GpuAnimator::State::solve(const Progress& progress) {
  if (options.solver == FrameSolver::multilevel || !follows()) {
    hierarchy->solve(&timer);
    hierarchy->run_cycles(options.cycles, progress);
    if (options.cycles > 0) timer.stage("cycles");
    if (relaxation) relaxation->clear();
    return;
  }
  if (forgets_momenta) relaxation->clear();
  relaxation->follow(*hierarchy, turned_z, waves, next_waves);
  const std::size_t colors = topology->colors(0).size();
  for (int i = 0; i < options.iterations; ++i) relaxation->iterate(*hierarchy, colors);
  timer.stage("relaxation");
}

/// Aligns stripes across creases, on the processor; frames that follow stay aligned.
void GpuAnimator::State::sew(const WaveBuffers& buffers) {
  std::vector<Complex> by_slot = hierarchy->read_phases(), by_node(topology->node_count());
  const std::span<const std::uint32_t> nodes = topology->node_at();
  for (std::size_t slot = 0; slot < nodes.size(); ++slot) {
    if (nodes[slot] != kNone) by_node[nodes[slot]] = by_slot[slot];
  }
  sewing.sew(ReadInput(buffers, by_node.size()), by_node);
  for (std::size_t slot = 0; slot < nodes.size(); ++slot) {
    if (nodes[slot] != kNone) by_slot[slot] = by_node[nodes[slot]];
  }
  hierarchy->upload_phases(by_slot);
}

/// Makes the solved frame the last one.
void GpuAnimator::State::keep() {
  if (measures) take_measure();
  hierarchy->bind();
  bind_storage(kFinishedLastPhases, last_z);
  bind_storage(kPhasesByNode, z_by_node);
  dispatch(kernels->to_nodes, topology->level(0).slot_count);
  timer.stage("nodes");
  std::swap(waves, next_waves);
  input.is_last = false;
  has_last = has_frame = true;
  forgets_momenta = false;
  given_z.clear();
  ++frames;
}

/// Restores the state before a frame that failed or was cancelled. Before `keep`, no data of the
/// last frame are overwritten.
void GpuAnimator::State::take_back() {
  if (has_frame) return;
  hierarchy.reset();
  relaxation.reset();
  measure.reset();
  // Aggregates are those of the first completed frame.
  if (!is_sibling) topology = nullptr;
}

void GpuAnimator::State::take_measure() {
  if (!measure) measure.emplace(*hierarchy);
  const auto last = measure->end();
  if (last) measured = FrameMeasure{measured_frames, last->energy, last->phase_step};
  measure->begin(*hierarchy, follows() ? GLuint{turned_z} : hierarchy->phases());
  measured_frames = frames;
  timer.stage("measure");
}

GpuAnimator::GpuAnimator(std::shared_ptr<const GpuKernels> kernels,
                         std::shared_ptr<const Adjacency> neighborhood,
                         const AnimatorOptions& options)
    : state_(std::make_unique<State>()) {
  check_animator_options(options);
  refuse_slack(options);
  if (!options.edge_weights.empty()) {
    throw Error(
        "animator options: the GPU knows no edge weights; leave them out, or take StripeAnimator");
  }
  state_->kernels = std::move(kernels);
  state_->neighborhood = std::move(neighborhood);
  state_->options = options;
}

GpuAnimator::GpuAnimator(std::shared_ptr<const GpuKernels> kernels, const Surface& surface,
                         const AnimatorOptions& options)
    : GpuAnimator(std::move(kernels), surface.neighborhood, without_slack(options)) {
  state_->sewing = FrameSewing(surface);
  state_->relaxed = frame_relaxation(surface, options.slack);
  state_->options.slack = options.slack;
  state_->in_place = {surface.mesh.positions, surface.normals};
}

GpuAnimator::GpuAnimator(std::unique_ptr<State> state) : state_(std::move(state)) {}
GpuAnimator::~GpuAnimator() = default;
GpuAnimator::GpuAnimator(GpuAnimator&&) noexcept = default;
GpuAnimator& GpuAnimator::operator=(GpuAnimator&&) noexcept = default;

bool GpuAnimator::frame(const FrameInput& input, const Progress& progress) {
  State& s = *state_;
  check_frame_input(input, s.neighborhood->node_count());
  const bool may_stay = s.has_last && s.given_z.empty();
  if (may_stay && s.input.is_last && s.relaxed.is_kept(relaxation_of(input))) {
    s.timer.start();
    return false;
  }
  if (s.relaxed.relaxes()) check_values(input, *s.neighborhood, s.in_place);
  const FrameInput relaxed = relaxed_input(s.relaxed, input, progress);
  if (!s.input.compare(relaxed) && may_stay) {
    s.timer.start();
    return false;
  }
  if (!s.relaxed.relaxes()) check_values(input, *s.neighborhood, s.in_place);
  solve(progress, [&] {
    s.build(relaxed, progress);
    s.timer.start();
    return s.input.upload(relaxed);
  });
  s.input.keep(relaxed);
  s.relaxed.keep(relaxation_of(input));
  return true;
}

void GpuAnimator::frame(const WaveBuffers& input, const Progress& progress) {
  State& s = *state_;
  refuse_slack(s.options);
  solve(progress, [&] {
    if (!s.hierarchy) {
      glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
      const ReadInput first(input, s.neighborhood->node_count());
      check_gl("reading the buffers of the first frame");
      check_values(first, *s.neighborhood, {});
      s.build(first, progress);
    }
    s.timer.start();
    return input;
  });
}

/// Solves from the buffers that `prepare` provides.
template <class Prepare>
void GpuAnimator::solve(const Progress& progress, const Prepare& prepare) {
  State& s = *state_;
  const std::size_t before = dispatch_count();
  try {
    const WaveBuffers input = prepare();
    // The caller's shaders may have written to them.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    s.load_waves(input);
    s.timer.stage("load");
    s.couple();
    s.timer.stage("couple");
    s.solve(progress);
    if (s.sewing.has_creases() && s.starts_afresh()) s.sew(input);
    check_gl("solving a frame on the GPU");
  } catch (...) {
    s.take_back();
    throw;
  }
  s.keep();
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  s.input.read.set();
  s.dispatches = dispatch_count() - before;
  check_gl("keeping a frame on the GPU");
}

std::span<const float> GpuAnimator::frequencies() const {
  return state_->input.is_last ? state_->relaxed.frequencies() : std::span<const float>();
}

const FrequencyChange& GpuAnimator::frequency_change() const {
  static const FrequencyChange none;
  return state_->input.is_last ? state_->relaxed.kept_change() : none;
}

unsigned GpuAnimator::phases() const { return state_->z_by_node; }

std::vector<Complex> GpuAnimator::read_phases() const {
  return state_->hierarchy ? read_buffer<Complex>(state_->z_by_node, state_->topology->node_count())
                           : std::vector<Complex>();
}

void GpuAnimator::measure_frames(bool measures) { state_->measures = measures; }

const std::optional<FrameMeasure>& GpuAnimator::measured() const { return state_->measured; }

std::optional<FrameMeasure> GpuAnimator::measure_now() {
  State& s = *state_;
  if (const auto last = s.measure ? s.measure->end() : std::nullopt) {
    s.measured = FrameMeasure{s.measured_frames, last->energy, last->phase_step};
  }
  return s.measured;
}

std::vector<StageTime> GpuAnimator::stage_milliseconds() const {
  return state_->timer.milliseconds();
}

std::size_t GpuAnimator::dispatches() const { return state_->dispatches; }

GpuAnimator GpuAnimator::sibling() const {
  auto state = std::make_unique<State>();
  state->kernels = state_->kernels;
  state->neighborhood = state_->neighborhood;
  state->sewing = state_->sewing;
  state->options = state_->options;
  state->topology = state_->topology;
  state->is_sibling = state->topology != nullptr;
  state->measures = state_->measures;
  state->relaxed = state_->relaxed.sibling();
  state->in_place = state_->in_place;
  return GpuAnimator(std::move(state));
}

void GpuAnimator::set_last_phases(std::span<const Complex> z) {
  check_last_phases(z, state_->neighborhood->node_count());
  state_->given_z.assign(z.begin(), z.end());
}

void GpuAnimator::set_slack(const Slack& slack) {
  check_made_with_slack(state_->relaxed.relaxes());
  state_->relaxed.set_slack(slack);
  state_->options.slack = slack;
}

void GpuAnimator::restart() {
  state_->has_last = false;
  state_->forgets_momenta = true;
  state_->given_z.clear();
  state_->relaxed.restart();
}

double GpuAnimator::topology_milliseconds() const { return state_->topology_milliseconds; }

}  // namespace brindle
