// The buffers of the library's texture shaders as textures of any width, row by row.

uniform highp usampler2D broken_words;

const bool kWholeTiles = true;

vec4 texel_of(sampler2D rows, int number) {
  int width = textureSize(rows, 0).x;
  return texelFetch(rows, ivec2(number % width, number / width), 0);
}

uint broken_word(uint number) {
  int width = textureSize(broken_words, 0).x;
  return texelFetch(broken_words, ivec2(int(number) % width, int(number) / width), 0).x;
}
