in vec4 shade;
#ifdef PICTURE
uniform sampler2D picture;  // shade has the place in it
#endif
out vec4 pixel;

void main() {
#ifdef PICTURE
  pixel = texture(picture, shade.xy);
#else
  pixel = shade;
#endif
}
