/// The items of the gallery, one source file each.
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
