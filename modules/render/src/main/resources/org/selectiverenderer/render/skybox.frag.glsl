// A picture of a background over its sky and ground (X3D 4.0, 24.2.1).
uniform sampler2D image;
uniform float opacity;
in vec2 coordinate;
out vec4 pixel;

void main() {
  vec4 texel = texture(image, coordinate);
  pixel = vec4(texel.rgb, texel.a * opacity);
}
