#include <algorithm>
#include <cstdint>

#include "brindle/base/random.h"
#include "brindle/shapes/implicit_shapes.h"
#include "gallery/charges.h"
#include "gallery/items.h"

namespace brindle {
namespace {

constexpr double kNanometres = 0.6;  // per unit of the built-in molecule

MoleculeShape molecule_shape() { return {.atoms = 26, .seed = 5}; }

std::vector<GalleryFile> make_charged_molecule(double detail, const Progress& progress) {
  return {charged_molecule(detail, progress)};
}

}  // namespace

std::vector<PointCharge> charges_of_molecule() {
  std::vector<PointCharge> charges;
  double sum = 0;
  std::uint64_t drawn = 0;
  for (const Capsule& atom : molecule_atoms(molecule_shape())) {
    // The sides differ, as at a binding site.
    const double side = atom.a.x() + 0.6 * atom.a.z();
    const double of_side = random_number(17, drawn++);
    const double own = 2 * random_number(17, drawn++) - 1;
    charges.push_back({kNanometres * atom.a, (side > 0 ? 0.55 : -0.55) * of_side + 0.35 * own});
    sum += charges.back().charge;
  }
  for (PointCharge& charge : charges) charge.charge -= sum / static_cast<double>(charges.size());
  return charges;
}

double potential_at(const Eigen::Vector3d& at, std::span<const PointCharge> charges) {
  double sum = 0;
  for (const PointCharge& charge : charges) sum += charge.charge / (at - charge.at).norm();
  return kBjerrumLength * sum;
}

GalleryFile charged_molecule(double detail, const Progress& progress) {
  MoleculeShape shape = molecule_shape();
  shape.resolution = std::max(2, static_cast<int>(60 * detail));
  GalleryFile file{"molecule.vtp", make_molecule(shape, progress), {}, {}};
  const std::vector<PointCharge> charges = charges_of_molecule();
  std::vector<float> potential;
  for (Vec3& position : file.mesh.positions) {
    position *= static_cast<float>(kNanometres);
    potential.push_back(static_cast<float>(potential_at(position.cast<double>(), charges)));
  }
  file.arrays.points = {make_data_array("potential", 1, potential)};
  return file;
}

GalleryItem molecule_item() {
  return {
      "molecule",
      "electric potential as signs, and as colours",
      make_charged_molecule,
      {{"signs",
        "plus where the potential is positive, minus where it is negative, dots between",
        "stripe {surface=molecule.vtp} --field {field=smooth} --stripes 40 --texture minus "
        "--texture-by {values=array:potential},regions=-0.4,dots@#a9a9a3,0.4,plus@#d9661f "
        "--legend {own='potential in kT/e'} --colors #2e8b6f,#f6f3ec,#ffffff --occlusion 0.6 "
        "--up z --camera -15,18",
        "600x440",
        {"stripes", "regions", "occlusion"}},
       {"colors",
        "the potential as colours of the surface",
        "stripe {surface=molecule.vtp} --field {field=smooth} --stripes 40 --stripe-width 0 "
        "--color-by {values=array:potential}{own=@-2.5..2.5} --color-on surface "
        "--colormap coolwarm --legend {own='potential in kT/e'} --colors #2e8b6f,#f6f3ec,#ffffff "
        "--occlusion 0.6 --up z --camera -15,18",
        "600x440",
        {"color-range", "colormap", "occlusion"}}}};
}

}  // namespace brindle
