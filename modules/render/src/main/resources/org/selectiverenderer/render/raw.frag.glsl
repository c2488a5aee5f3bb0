in vec3 facing;
out vec4 pixel;

void main() {
  pixel = vec4(0.5 * facing + 0.5, 1.0);
}
