// Flat shapes in pixels over the picture.
layout(location = 0) in vec3 position;
uniform vec4 place;  // offset and scale to clip coordinates

void main() {
  gl_Position = vec4(position.xy * place.zw + place.xy, 0.0, 1.0);
}
