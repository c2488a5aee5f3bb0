// Keeps the pixels in which one bit of Bayer's index matrix of 8 x 8 (1973) is set: its bits,
// the highest first, are those of x XOR y and of y in turn, the lowest first.
uniform ivec2 corner; // of the viewport
uniform int bit;
out vec4 pixel;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) - corner;
  int source = (bit & 1) == 1 ? at.x ^ at.y : at.y;
  if (((source >> (2 - bit / 2)) & 1) == 0) {
    discard;
  }
  pixel = vec4(0.0);
}
