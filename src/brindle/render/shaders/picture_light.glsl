// The light of a picture, which the renderer sets; its twin is `lights_of` in surface_tones.cpp.

uniform bool light_is_moved;  // else the lights are the usual ones
uniform vec3 key_from;
uniform vec3 fill_from;
uniform vec3 up;  // of the world, seen from the camera

vec3 lit_here(vec3 surface, vec3 view_normal, vec3 sight) {
  // The usual lights are constants here: a driver's bits of them are not the processor's.
  Lights lights = usual_lights();
  if (light_is_moved) {
    lights.key = key_from;
    lights.fill = fill_from;
  }
  return lit_by(lights, surface, view_normal, sight, up);
}
