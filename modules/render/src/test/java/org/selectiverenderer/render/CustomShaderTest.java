package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.display.OffscreenView;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** Shapes that programs of authors draw, beside others, and what the shaders are told. */
@RequiresDisplay
class CustomShaderTest {
  private static final int GREEN = 0x00ff00;
  private static final int BLUE = 0x0000ff;

  private static final String PROGRAM =
      """
      <ShaderPart type='VERTEX'>void main() { gl_Position = ftransform(); }</ShaderPart>
      <ShaderPart DEF='P' type='FRAGMENT'>
      %s</ShaderPart>
      """;

  private static String paint(String color) {
    return PROGRAM.formatted("void main() { gl_FragColor = vec4(" + color + "); }");
  }

  private static String shape(String appearance, String geometry) {
    return "<Shape><Appearance>%s</Appearance>%s</Shape>".formatted(appearance, geometry);
  }

  private static String at(double x, String shape) {
    return "<Transform translation='%s 0 0'>%s</Transform>".formatted(x, shape);
  }

  private static final String BOX = "<Box size='1.5 1.5 1'/>";

  private static final String BLUE_MATERIAL = "<UnlitMaterial emissiveColor='0 0 1'/>";

  @Test
  void othersAreDrawnAsBefore() {
    String program =
        BLUE_MATERIAL
            + "<ComposedShader language='GLSL'>"
            + paint("0, 1, 0, 1").replace("DEF='P' ", "")
            + "</ComposedShader>";
    String image = "<PixelTexture image='1 1 3 0x00ff00'/>";
    String points = "<PointSet><Coordinate point='0 0 0'/></PointSet>";
    String cut = "<ClipPlane plane='-1 0 0 0'/>" + shape(BLUE_MATERIAL, BOX);
    try (TestImageRenderer studio = new TestImageRenderer()) {
      Screenshot shot =
          studio.shoot(
              TestScene.of(
                  at(-3, shape(program, BOX))
                      + at(-1, shape(BLUE_MATERIAL, BOX))
                      + at(1, shape(image, BOX))
                      + at(3, "<Group>" + cut + "</Group>")
                      + at(-2, shape(program, points))));
      assertThat(shot.rgb(8, 32)).isEqualTo(GREEN);
      assertThat(shot.rgb(24, 32)).isEqualTo(BLUE);
      assertThat(shot.rgb(40, 32)).isEqualTo(GREEN);
      assertThat(shot.rgb(53, 32)).isEqualTo(BLUE);
      assertThat(shot.rgb(59, 32)).isEqualTo(0);
      assertThat(shot.rgb(16, 32)).isEqualTo(GREEN);
    }
  }

  /**
   * One program for all shaders with its text: what one of them sets is not seen by another that
   * leaves it.
   */
  @Test
  void whatAShaderDoesNotSetIsTheProgramsOwnBesideOneThatDoes() {
    String text =
        """
        uniform vec3 tint = vec3(0.0, 1.0, 0.0);
        uniform int more[2];
        void main() { gl_FragColor = vec4(tint + vec3(0.0, 0.0, float(more[1])), 1.0); }
        """;
    String parts = PROGRAM.formatted(text).replace("type='VERTEX'", "DEF='V' type='VERTEX'");
    String used = "<ShaderPart USE='V'/><ShaderPart USE='P'/>";
    String program = BLUE_MATERIAL + "<ComposedShader language='GLSL'>%s%s</ComposedShader>";
    String field = "<field name='%s' type='%s' accessType='inputOutput' value='%s'/>";
    String both =
        field.formatted("tint", "SFVec3f", "1 0 0") + field.formatted("more", "MFInt32", "0 1");
    String part = field.formatted("more", "MFInt32", "0");
    try (TestImageRenderer studio = new TestImageRenderer()) {
      Screenshot shot =
          studio.shoot(
              TestScene.of(
                  at(-3, shape(program.formatted(both, parts), BOX))
                      + at(-1, shape(program.formatted("", used), BOX))
                      + at(1, shape(program.formatted(both, used), BOX))
                      + at(3, shape(program.formatted(part, used), BOX))));
      assertThat(shot.rgb(8, 32)).isEqualTo(0xff00ff);
      assertThat(shot.rgb(24, 32)).isEqualTo(GREEN);
      assertThat(shot.rgb(40, 32)).isEqualTo(0xff00ff);
      assertThat(shot.rgb(56, 32)).isEqualTo(GREEN);
    }
  }

  /** What has become of a scene in a picture of 64 x 64 and a frame after it. */
  private record Seen(int middle, List<String> told, List<String> sent) {}

  private static Seen see(String shaders, String... then) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    String scene =
        "<X3D profile='Full' version='4.0'><Scene>\n<Shape><Appearance>\n%s%s</Appearance><Box size='8 8 1'/></Shape></Scene></X3D>"
            .formatted(BLUE_MATERIAL, shaders);
    List<String> sent = new ArrayList<>();
    try (SceneLoader loader =
            new SceneLoader(
                NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems);
        OffscreenView view = OffscreenView.open(64, 64, 0, ViewLayout.MONO, ShadingMode.AUTO)) {
      byte[] bytes = scene.getBytes(StandardCharsets.UTF_8);
      World world =
          new World(loader.load("s.x3d", new ByteArrayInputStream(bytes), Path.of("")), problems);
      for (String name : List.of("S", "T")) {
        world.scene().find(name).ifPresent(node -> listen(node, sent));
      }
      world.step(0, (viewer, time, dt) -> {});
      view.draw(world);
      world.step(1, (viewer, time, dt) -> {});
      if (then.length > 0) {
        Node part = world.scene().find("P").orElseThrow();
        world.post(() -> world.cascade().send(part, part.type().indexOf("sourceCode"), then[0]));
        int[] frame = {2};
        Eventually.await(
            "the colour " + then[1],
            () -> {
              world.step(frame[0]++, (viewer, time, dt) -> {});
              view.draw(world);
              return Integer.toHexString(view.screenshot().rgb(32, 32)).equals(then[1]);
            });
        world.step(frame[0], (viewer, time, dt) -> {});
      }
      view.draw(world);
      return new Seen(
          view.screenshot().rgb(32, 32),
          problems.list().stream().map(Problem::toString).toList(),
          sent);
    }
  }

  private static void listen(Node node, List<String> sent) {
    for (String field : List.of("isSelected", "isValid")) {
      node.addListener(
          node.type().indexOf(field),
          (from, index, value, time) -> sent.add(from.name() + "." + field + " " + value));
    }
  }

  private static String shader(String name, String parts) {
    return "<ComposedShader DEF='%s' language='GLSL'>%s</ComposedShader>".formatted(name, parts);
  }

  @Test
  void aProgramThatCompilesIsSelectedAndValid() throws IOException {
    Seen seen = see(shader("S", paint("0, 1, 0, 1")));
    assertThat(seen.middle()).isEqualTo(GREEN);
    assertThat(seen.told()).isEmpty();
    assertThat(seen.sent()).containsExactly("S.isSelected true", "S.isValid true");
  }

  @Test
  void oneThatDoesNotIsToldOnceWithItsPlace() throws IOException {
    Seen seen = see(shader("S", PROGRAM.formatted("void main() {\n  gl_FragColor = nothing;\n}")));
    assertThat(seen.middle()).isEqualTo(BLUE);
    assertThat(seen.told()).hasSize(1);
    assertThat(seen.told().get(0))
        .startsWith("s.x3d:6:")
        .contains("the FRAGMENT shader of ComposedShader S does not compile")
        .contains("nothing")
        .endsWith("the shape is drawn by its material");
    assertThat(seen.sent()).containsExactly("S.isSelected false", "S.isValid false");
  }

  @Test
  void theNextIsUsedWhenPartsDoNotFitTogether() throws IOException {
    String apart = PROGRAM.formatted("vec4 other();\nvoid main() { gl_FragColor = other(); }");
    Seen seen = see(shader("S", apart) + shader("T", paint("0, 1, 0, 1").replace("DEF='P' ", "")));
    assertThat(seen.middle()).isEqualTo(GREEN);
    assertThat(seen.told()).hasSize(1);
    assertThat(seen.told().get(0))
        .contains("the shader stages of ComposedShader S do not link")
        .endsWith("the next shader of the Appearance is used");
    assertThat(seen.sent()).contains("S.isValid false", "T.isSelected true", "T.isValid true");
  }

  @Test
  void aFieldOfAnotherKindIsTold() throws IOException {
    String program =
        PROGRAM.formatted(
            "uniform vec4 tint;\nvoid main() { gl_FragColor = tint + vec4(0, 1, 0, 1); }");
    Seen seen =
        see(
            shader(
                "S",
                "<field name='tint' type='SFVec3f' accessType='inputOutput' value='1 1 1'/>"
                    + program));
    assertThat(seen.middle()).isEqualTo(GREEN);
    assertThat(seen.told()).hasSize(1);
    assertThat(seen.told().get(0))
        .contains("the field tint of ComposedShader S (SFVec3f) has 3 components");
  }

  @Test
  void anotherTextTakesItsPlace() throws IOException {
    Seen seen =
        see(
            shader("S", paint("nothing")),
            "void main() { gl_FragColor = vec4(0, 1, 0, 1); }",
            "ff00");
    assertThat(seen.middle()).isEqualTo(GREEN);
    assertThat(seen.sent())
        .containsExactly(
            "S.isSelected false", "S.isValid false", "S.isSelected true", "S.isValid true");
  }

  @Test
  void oneThatTheDriverWouldNotSurviveIsToldAndNotUsed() throws IOException {
    String large =
        """
        void main() {
          float all[200000000];
          all[int(gl_FragCoord.x)] = 1.0;
          gl_FragColor = vec4(all[int(gl_FragCoord.y)]);
        }
        """;
    Seen seen = see(shader("S", PROGRAM.formatted(large)));
    assertThat(seen.middle()).isEqualTo(BLUE);
    assertThat(seen.told()).hasSize(1);
    assertThat(seen.told().get(0)) // Time or memory, whichever is exhausted first.
        .startsWith(
            "s.x3d:3:39: ComposedShader S is not used, since the graphics driver, which tried it in a"
                + " process of its own, took more than ")
        .endsWith("; the shape is drawn by its material");
    assertThat(seen.sent()).containsExactly("S.isSelected false", "S.isValid false");
  }
}
