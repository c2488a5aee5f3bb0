package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PolygonCommandsTest {
  private static final String BALL =
      "<X3D version='3.3'><Scene>\n  <Shape DEF='Ball'><Sphere/></Shape>\n</Scene></X3D>\n";

  @TempDir Path folder;

  private Path scene = Path.of("");
  private String out = "";
  private String err = "";

  @BeforeEach
  void writeTheScene() throws IOException {
    scene = Files.writeString(folder.resolve("ball.x3d"), BALL);
  }

  private int run(String... args) {
    ByteArrayOutputStream data = new ByteArrayOutputStream();
    ByteArrayOutputStream messages = new ByteArrayOutputStream();
    int status =
        Main.execute(
            args,
            new PrintStream(data, true, StandardCharsets.UTF_8),
            new PrintStream(messages, true, StandardCharsets.UTF_8));
    out = data.toString(StandardCharsets.UTF_8);
    err = messages.toString(StandardCharsets.UTF_8);
    return status;
  }

  @Test
  void simplifyReportsJson() throws IOException {
    Path output = folder.resolve("out/ball_v2.x3d");

    int status =
        run(
            "simplify",
            scene.toString(),
            "--polygons",
            "200",
            "--output",
            output.toString(),
            "--format",
            "json");

    assertThat(err).isEmpty();
    assertThat(status).isZero();
    JsonNode report = new ObjectMapper().readTree(out);
    assertThat(report.fieldNames()).toIterable().containsExactly("input", "output", "error", "ms");
    assertThat(report.at("/input/vertices").asInt()).isEqualTo(482);
    assertThat(report.at("/input/polygons").asInt()).isEqualTo(960);
    assertThat(report.at("/output/polygons").asInt()).isCloseTo(200, within(2));
    assertThat(report.at("/output/vertices").asInt()).isCloseTo(102, within(2));
    assertThat(report.at("/error").asDouble()).isBetween(0.001, 0.05);
    assertThat(output).content().contains("<IndexedFaceSet");
  }

  @Test
  void simplifyPrintsTheThesisParametersAsText() {
    int status =
        run(
            "simplify",
            scene.toString(),
            "--vert-percent",
            "10",
            "--output",
            folder.resolve("o.x3d").toString());

    assertThat(status).isZero();
    assertThat(out).contains("Max Vertex", "482", "Vert Count", "Vert Percent", "largest error");
  }

  @Test
  void withoutOutputTheModelIsTheData() {
    int status = run("simplify", scene.toString(), "--vert-count", "50");

    assertThat(status).isZero();
    assertThat(out).startsWith("<?xml").endsWith("</X3D>\n");
    assertThat(err).contains("Vert Count");
  }

  @ParameterizedTest
  @CsvSource({
    "--polygons,0",
    "--polygons,-3",
    "--vert-count,0",
    "--vert-percent,0",
    "--vert-percent,101",
    "--vert-percent,NaN",
    "--max-error,-1",
    "--polygons,961",
    "--vert-count,483"
  })
  void aTargetThatIsNoneIsWrongUsage(String option, String value) {
    int status = run("simplify", scene.toString(), option + "=" + value);

    assertThat(status).isEqualTo(2);
    assertThat(out).isEmpty();
    assertThat(err).startsWith("selective-renderer simplify: ").doesNotContain("\tat ");
  }

  @Test
  void oneWayToSayHowFarIsNeeded() {
    assertThat(run("simplify", scene.toString())).isEqualTo(2);
    assertThat(run("simplify", scene.toString(), "--polygons", "9", "--max-error", "0.1"))
        .isEqualTo(2);
  }

  @Test
  void aModelWithoutFacesIsAProblemOfTheInput() throws IOException {
    Path empty = Files.writeString(folder.resolve("empty.x3d"), "<X3D><Scene/></X3D>");

    assertThat(run("simplify", empty.toString(), "--polygons", "9")).isEqualTo(1);
    assertThat(err).contains("empty.x3d").contains("no faces");
  }

  @Test
  void aModelThatIsNotThereIsAFailure() {
    String gone = folder.resolve("gone.glb").toString();

    assertThat(run("simplify", gone, "--polygons", "9")).isEqualTo(2);
    assertThat(err).contains("gone.glb");
  }

  @Test
  void aFolderThatIsAFileCannotTakeTheOutput() {
    String output = scene.resolve("o.x3d").toString();

    assertThat(run("simplify", scene.toString(), "--polygons", "9", "--output", output))
        .isEqualTo(2);
    assertThat(err).contains("ball.x3d").contains("nothing has been changed");
  }

  @Test
  void versionsChangesTheScene() {
    int status = run("versions", scene.toString(), "--object", "Ball", "--vert-percent", "50,10");

    assertThat(err).isEmpty();
    assertThat(status).isZero();
    assertThat(out)
        .contains("Ball_v1       482 vertices       960 polygons")
        .contains("Ball_v3", "new  ", "changed  ");
    assertThat(scene).content().contains("Switch_Ball").contains("Ball_v3.x3d");
    assertThat(folder.resolve("inlineNodes/Ball_v3.x3d")).exists();
  }

  @Test
  void aDryRunShowsWhatWouldChange() {
    int status =
        run("versions", scene.toString(), "--object", "Ball", "--polygons", "100", "--dry-run");

    assertThat(status).isZero();
    assertThat(out)
        .contains("would be new  ", "would change  ")
        .contains("ball.x3d:2:")
        .contains("-   <Shape DEF='Ball'><Sphere/></Shape>")
        .contains("+   <Switch DEF='Switch_Ball' whichChoice='0'>");
    assertThat(scene).hasContent(BALL);
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
  }

  @Test
  void anObjectThatIsNotThereIsAProblemOfTheInput() {
    assertThat(run("versions", scene.toString(), "--object", "Bell", "--polygons", "9"))
        .isEqualTo(1);
    assertThat(err).contains("ball.x3d").contains("Bell");
    assertThat(scene).hasContent(BALL);
  }
}
