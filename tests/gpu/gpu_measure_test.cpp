#include "brindle/gpu/gpu_measure.h"

#include <array>
#include <cmath>

#include "brindle/error.h"
#include "device.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::wavy_surface;

struct GpuMeasureTest : test::GpuTest {
  testing_support::WavySurface surface =
      wavy_surface("torus,resolution=80", Vec3(0.31f, 0.9f, 0.27f), 25);

  /// A hierarchy of one level with the couplings of the surface.
  GpuHierarchy hierarchy(const PhaseGraph& graph, SlicedLayout& layout) {
    const auto shared = std::make_shared<const SlicedLayout>(
        sliced_layout(*graph.adjacency, greedy_coloring(*graph.adjacency)));
    layout = *shared;
    SlicedCouplings couplings(layout);
    load_couplings(graph, layout, couplings);
    const std::array<LevelTopology, 1> levels{{{shared, nullptr}}};
    GpuHierarchy result(device.solver.kernels(),
                        std::make_shared<const GpuTopology>(flatten(levels, 0)));
    result.upload(layout, couplings);
    return result;
  }
};

TEST_F(GpuMeasureTest, IsTheEnergyOfThePhaseGraph) {
  flip_half(surface.waves, 9);
  const PhaseGraph graph = surface.graph();
  SlicedLayout layout;
  GpuHierarchy on_device = hierarchy(graph, layout);
  std::vector<Complex> by_slot(layout.slot_count(), Complex(1));
  for (Index slot = 0; slot < layout.slot_count(); ++slot) {
    by_slot[slot] = std::polar(1.0f, 0.001f * static_cast<float>(slot));
  }
  on_device.upload_phases(by_slot);
  GpuMeasure measure(on_device);
  measure.begin(on_device, on_device.phases());
  const PhaseMeasure measured = *measure.end();
  const double expected = energy(graph, to_nodes(layout, by_slot));
  EXPECT_NEAR(measured.energy, expected, 1e-5 * expected);
  EXPECT_NEAR(measured.phase_step, 0, 1e-6);
  double weight = 0;
  for (const Complex& coupling : graph.coupling) weight += std::abs(coupling);
  EXPECT_NEAR(measured.weight, weight, 1e-5 * weight);
}

TEST_F(GpuMeasureTest, StepsAreAnglesBetweenPhases) {
  SlicedLayout layout;
  GpuHierarchy before = hierarchy(surface.graph(), layout);
  GpuHierarchy after = hierarchy(surface.graph(), layout);
  before.upload_phases(std::vector<Complex>(layout.slot_count(), std::polar(1.0f, 3.0f)));
  after.upload_phases(std::vector<Complex>(layout.slot_count(), std::polar(1.0f, -3.0f)));
  GpuMeasure measure(after);
  measure.begin(after, before.phases());
  EXPECT_NEAR(measure.end()->phase_step, 2 * M_PI - 6, 1e-5);
}

TEST_F(GpuMeasureTest, EnergyOfWhatIsNoNumberIsNone) {
  PhaseGraph graph = surface.graph();
  graph.coupling[5] = std::nanf("");
  SlicedLayout layout;
  const GpuHierarchy on_device = hierarchy(graph, layout);
  GpuMeasure measure(on_device);
  measure.begin(on_device, on_device.phases());
  EXPECT_TRUE(std::isnan(measure.end()->energy));
}

TEST_F(GpuMeasureTest, TwoMayBeUnderWayAndComeInTheirOrder) {
  SlicedLayout layout;
  GpuHierarchy one = hierarchy(surface.graph(), layout);
  GpuHierarchy two = hierarchy(surface.graph(), layout);
  two.upload_phases(std::vector<Complex>(layout.slot_count(), Complex(1)));
  GpuMeasure measure(one);
  EXPECT_FALSE(measure.end().has_value());
  measure.begin(one, one.phases());
  measure.begin(one, two.phases());
  EXPECT_THROW(measure.begin(one, one.phases()), Error);
  EXPECT_NEAR(measure.end()->phase_step, 0, 1e-6);
  EXPECT_NEAR(measure.end()->phase_step, M_PI / 2, 1e-5);  // all phases begin at the peak
  EXPECT_FALSE(measure.end().has_value());
}

}  // namespace
}  // namespace brindle
