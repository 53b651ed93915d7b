// The light of a picture, set by the renderer. Twin of `lights_of` in surface_tones.cpp.

uniform bool light_is_moved;  // otherwise, the usual lights
uniform vec3 key_from;
uniform vec3 fill_from;
uniform vec3 up;  // the world's up in view coordinates

vec3 lit_here(vec3 surface, vec3 view_normal, vec3 sight) {
  // The usual lights are constants: a driver would compute other bits than the processor.
  Lights lights = usual_lights();
  if (light_is_moved) {
    lights.key = key_from;
    lights.fill = fill_from;
  }
  return lit_by(lights, surface, view_normal, sight, up);
}
