package org.selectiverenderer.render.trial;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.platform.ChildProcessCommand;
import org.selectiverenderer.browser.instance.ShaderProgramSource.Stage;
import org.selectiverenderer.render.glsl.GlslTranslator;
import org.selectiverenderer.render.glsl.GlslTranslator.Given;
import org.selectiverenderer.testing.RequiresDisplay;

/** Programs that would take all time or memory of the process that compiles them. */
@RequiresDisplay
class ShaderTrialProcessTest {
  private static final String PLAIN = "void main() { gl_FragColor = vec4(1.0); }";
  private static final Duration AMPLE = Duration.ofMinutes(1);
  private static final Map<String, Integer> ATTRIBUTES = Map.of("sr_Vertex", 0);

  private static List<GlslTranslator.Unit> program(String fragment) {
    return new GlslTranslator()
        .translate(
            List.of(
                new Given(Stage.VERTEX, "void main() { gl_Position = ftransform(); }"),
                new Given(Stage.FRAGMENT, fragment)));
  }

  private static String doubled(String form, String use) {
    return IntStream.rangeClosed(1, 40)
        .mapToObj(i -> form.formatted(i, i - 1, i - 1) + "\n")
        .collect(Collectors.joining("", "", use));
  }

  private static ShaderTrialProcess brief(Duration all, String... command) {
    return new ShaderTrialProcess(
        command.length > 0
            ? List.of(command)
            : ChildProcessCommand.contained(ShaderTrialMain.class.getName(), List.of("jogl.")),
        Duration.ofSeconds(5), // More than any of the plain programs takes on a busy machine.
        all,
        1L << 30);
  }

  @Test
  void aProgramThatNeverEndsIsRefusedAndTheNextOneIsTried() {
    try (ShaderTrialProcess trial = brief(AMPLE)) {
      assertThat(trial.refusal(program(PLAIN), ATTRIBUTES)).isEmpty();
      for (String endless :
          List.of(
              doubled(
                  "#define A%s A%s + A%s",
                  "#define A0 1.0\nvoid main() { gl_FragColor = vec4(A40); }"),
              "float f0(float x) { return sin(x); }\n"
                  + doubled(
                      "float f%s(float x) { return f%s(x) + f%s(x * 1.1); }",
                      "void main() { gl_FragColor = vec4(f40(gl_FragCoord.x)); }"))) {
        assertThat(trial.refusal(program(endless), ATTRIBUTES))
            .describedAs(endless)
            .get()
            .asString()
            .startsWith("the graphics driver, which tried it in a process of its own, took more");
      }
      assertThat(trial.refusal(program("no program"), ATTRIBUTES)).isEmpty(); // It compiles fast.
      assertThat(trial.refusal(program(PLAIN), ATTRIBUTES)).isEmpty();
    }
  }

  @Test
  void aProcessThatTriesNothingRefuses() {
    Path java = Path.of(System.getProperty("java.home"), "bin", "java");
    try (ShaderTrialProcess trial = brief(AMPLE, java.toString(), "-version")) {
      assertThat(trial.refusal(program(PLAIN), ATTRIBUTES))
          .contains("the process that tries it cannot be started: it ended unexpectedly");
    }
  }

  @Test
  void aProcessThatCannotOpenADisplaySaysSo() {
    List<String> command =
        ChildProcessCommand.minimal(
            ShaderTrialMain.class.getName(), List.of("-Djogl.disable.opengldesktop=true"));
    try (ShaderTrialProcess trial = brief(AMPLE, command.toArray(String[]::new))) {
      assertThat(trial.refusal(program(PLAIN), ATTRIBUTES))
          .get()
          .asString()
          .startsWith("the process that tries it cannot be started: ")
          .contains("OpenGL");
    }
  }

  @Test
  void allProgramsTogetherHaveATimeToo() {
    List<GlslTranslator.Unit> endless =
        program(
            doubled(
                "#define A%s A%s + A%s",
                "#define A0 1.0\nvoid main() { gl_FragColor = vec4(A40); }"));
    try (ShaderTrialProcess trial = brief(Duration.ofSeconds(2))) {
      String said = "";
      for (int i = 0; i < 100 && !said.contains("together"); i++) {
        said = trial.refusal(endless, ATTRIBUTES).orElse("");
      }
      assertThat(said).isEqualTo("the scene's shaders together took more than 2 s to try");
      assertThat(trial.refusal(program(PLAIN), ATTRIBUTES)).contains(said);
    }
  }
}
