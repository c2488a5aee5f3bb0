// Sky and ground gradients (X3D 4.0, 24.4.1): colours at angles from the zenith and the nadir,
// linear in between. A chain without branches: each stop takes over from its predecessor.
uniform vec4 sky[MAX_STOPS];  // colour, angle from the zenith
uniform vec4 ground[MAX_STOPS];  // colour, angle from the nadir
uniform int skyStops;
uniform int groundStops;
uniform float opacity;
in vec3 direction;
out vec4 pixel;

void main() {
  float up = clamp(normalize(direction).y, -1.0, 1.0);
  float angle = acos(up);
  vec3 color = sky[0].rgb;
  for (int i = 1; i < skyStops; i++) {
    float span = max(sky[i].a - sky[i - 1].a, 1e-6);
    color = mix(color, sky[i].rgb, clamp((angle - sky[i - 1].a) / span, 0.0, 1.0));
  }
  float below = acos(-up);
  if (groundStops > 0 && below <= ground[groundStops - 1].a) {
    color = ground[0].rgb;
    for (int i = 1; i < groundStops; i++) {
      float span = max(ground[i].a - ground[i - 1].a, 1e-6);
      color = mix(color, ground[i].rgb, clamp((below - ground[i - 1].a) / span, 0.0, 1.0));
    }
  }
  pixel = vec4(color * opacity, 1.0);
}
