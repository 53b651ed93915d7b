/// The items of the gallery, each made by the source of its name.
#pragma once

#include "gallery/gallery.h"

namespace brindle {

GalleryItem liver_item();
GalleryItem nested_item();
GalleryItem vortices_item();
GalleryItem aneurysm_item();
GalleryItem molecule_item();
GalleryItem hatching_item();
GalleryItem glyphs_item();
GalleryItem crosses_item();
GalleryItem rough_item();
GalleryItem giant_item();

}  // namespace brindle
