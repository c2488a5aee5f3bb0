package org.selectiverenderer.render.glsl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.ShaderProgramSource.Stage;
import org.selectiverenderer.render.glsl.GlslTranslator.Given;
import org.selectiverenderer.render.glsl.GlslTranslator.Unit;

/** Programs of authors become texts of OpenGL 3.3. */
class GlslTranslatorTest {
  private final GlslTranslator translator = new GlslTranslator();

  private String translated(Stage stage, String text) {
    return translator.translate(List.of(new Given(stage, text))).stream()
        .filter(unit -> unit.part() == 0)
        .findFirst()
        .orElseThrow()
        .text();
  }

  /** What stands behind the head. */
  private String body(Stage stage, String text) {
    Unit unit = translator.translate(List.of(new Given(stage, text))).get(0);
    String all = unit.text();
    for (int i = 0; i < unit.head(); i++) {
      all = all.substring(all.indexOf('\n') + 1);
    }
    return all;
  }

  @Test
  void wordsOfGlsl110BecomeThoseOfItsStage() {
    String text = "attribute vec3 a;\nvarying vec2 b;\nvoid main() { gl_Position = gl_Vertex; }";
    assertThat(body(Stage.VERTEX, text))
        .isEqualTo("in vec3 a;\nout vec2 b;\nvoid main() { gl_Position = sr_Vertex; }\n");
    assertThat(body(Stage.FRAGMENT, "varying vec2 b;")).isEqualTo("in vec2 b;\n");
  }

  @Test
  void linesStayWhereTheyAre() {
    String text = "#version 120\n\n// gl_Color\r\nvoid main() {\n  gl_FragColor = vec4(0.0);\n}";
    assertThat(body(Stage.FRAGMENT, text))
        .isEqualTo("\n\n// gl_Color\nvoid main() {\n  sr_FragColor = vec4(0.0);\n}\n");
  }

  @Test
  void directivesMayBeIndented() {
    String text = "\n    #version 120\n\t# extension GL_OES_x : enable\n  void main() {}";
    assertThat(translated(Stage.FRAGMENT, text)).containsOnlyOnce("version");
    assertThat(body(Stage.FRAGMENT, text)).isEqualTo("\n\n\n  void main() {}\n");
  }

  @Test
  void whatIsUsedIsDeclaredOnceAndNothingElse() {
    String text = translated(Stage.VERTEX, "void main() { gl_Position = ftransform(); }");
    assertThat(text).startsWith("#version 330 core\n");
    assertThat(text).containsOnlyOnce("uniform mat4 sr_ModelViewMatrix;");
    assertThat(text).containsOnlyOnce("in vec4 sr_Vertex;").doesNotContain("sr_LightSource");
    assertThat(text.indexOf("in vec4 sr_Vertex;")).isLessThan(text.indexOf("vec4 ftransform()"));
  }

  @Test
  void namesInCommentsAndOfTheAuthorsOwnAreNotDeclared() {
    String text =
        translated(
            Stage.FRAGMENT,
            "/* gl_Fog */ struct x3d_FogParameters { float f; };\n#define texture2D mine\nx3d_FogParameters f;");
    assertThat(text).doesNotContain("sr_Fog").doesNotContain("visibilityRange");
    assertThat(text).doesNotContain("texture(s, p)");
  }

  @Test
  void wordsThatCameLaterAreNamesStill() {
    assertThat(body(Stage.FRAGMENT, "#version 120\nuniform float flat;"))
        .isEqualTo("\nuniform float flat_;\n");
    assertThat(GlslTranslator.fieldName("flat_")).isEqualTo("flat");
    assertThat(GlslTranslator.fieldName("mine_")).isEqualTo("mine_");
    assertThat(body(Stage.FRAGMENT, "#version 330\nflat in int i;"))
        .isEqualTo("\nflat in int i;\n");
  }

  @Test
  void versionsAreThoseOfTheCoreProfileOrLater() {
    assertThat(translated(Stage.VERTEX, "#version 300 es\nvoid main() {}"))
        .startsWith("#version 330 core\n");
    assertThat(translated(Stage.VERTEX, "#version 100\nvoid main() {}"))
        .startsWith("#version 330 core\n");
    List<Unit> both =
        translator.translate(
            List.of(
                new Given(Stage.VERTEX, "#version 430 core\nvoid main() {}"),
                new Given(Stage.FRAGMENT, "#version 130\nvoid main() {}")));
    assertThat(both).allSatisfy(unit -> assertThat(unit.text()).startsWith("#version 430 core\n"));
  }

  @Test
  void longTextsAreNoTrouble() {
    String text = "// " + "gl_Color ".repeat(100_000) + "\n/*" + "x*".repeat(200_000);
    assertThat(body(Stage.FRAGMENT, text)).isEqualTo(text + "\n");
  }

  @Test
  void extensionsStandFirst() {
    String text =
        translated(
            Stage.FRAGMENT,
            "#extension GL_OES_standard_derivatives : enable\n#extension GL_ARB_gpu_shader5 : require\nvoid main() { gl_FragColor = vec4(0.0); }");
    assertThat(text)
        .startsWith("#version 330 core\n#extension GL_ARB_gpu_shader5 : enable\n")
        .doesNotContain("GL_OES");
  }

  @Test
  void aStageThatIsMissingDoesWhatCardsDidWithoutOne() {
    List<Unit> units =
        translator.translate(
            List.of(new Given(Stage.FRAGMENT, "void main() { gl_FragColor = gl_TexCoord[0]; }")));
    assertThat(units).hasSize(2);
    assertThat(units.get(1).stage()).isEqualTo(Stage.VERTEX);
    assertThat(units.get(1).text()).contains("out vec4 sr_TexCoord[8];");
  }

  @Test
  void whatThePixelsTakeTheVerticesPass() {
    List<Unit> units =
        translator.translate(
            List.of(
                new Given(Stage.VERTEX, "void main() { gl_Position = gl_Vertex; }"),
                new Given(Stage.FRAGMENT, "void main() { gl_FragColor = gl_Color; }")));
    assertThat(units.get(0).text()).contains("out vec4 sr_FrontColor;");
  }
}
