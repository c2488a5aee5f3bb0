package org.selectiverenderer.render.gpu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import org.junit.jupiter.api.Test;

class ShaderSourceLoaderTest {
  private final ShaderSourceLoader texts = new ShaderSourceLoader();

  @Test
  void partsStandWhereTheyAreNamed() throws IOException {
    String expected =
        raw("light.glsl")
            .replace("#include environment.glsl\n", raw("environment.glsl") + "\n")
            .replace("#include physical.glsl\n", raw("physical.glsl") + "\n");

    assertThat(texts.of("light.glsl")).isEqualTo(expected).doesNotContain("#include");
  }

  @Test
  void partsOfPartsAreThereToo() throws IOException {
    assertThat(texts.of("shape.frag.glsl"))
        .contains(raw("environment.glsl"))
        .doesNotContain("\n#include ");
  }

  @Test
  void whatIncludesNothingIsTakenAsItIs() throws IOException {
    assertThat(texts.of("fog.glsl")).isEqualTo(raw("fog.glsl"));
  }

  @Test
  void eachIsReadOnce() {
    assertThat(texts.of("shape.vert.glsl")).isSameAs(texts.of("shape.vert.glsl"));
  }

  @Test
  void aMissingPartIsNamed() {
    assertThatThrownBy(() -> texts.of("nothing.glsl")).hasMessageContaining("nothing.glsl");
  }

  private static String raw(String resource) throws IOException {
    try (InputStream in =
        Objects.requireNonNull(
            ShaderSourceLoaderTest.class.getResourceAsStream(
                "/org/selectiverenderer/render/" + resource))) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
