package org.selectiverenderer.cli.author;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.testing.RequiresSymbolicLinks;

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
    CommandTestCase command = new CommandTestCase();
    int status = command.execute(args);
    out = command.printed();
    err = command.messages();
    return status;
  }

  @Test
  void versionsOfAllNameTheUnnamedAndSayWhatIsSkipped() throws IOException {
    String text =
        """
        <X3D version='3.3'><Scene>
          <!-- vase -->
          <Transform><Shape><Sphere/></Shape></Transform>
          <Transform DEF='Pot'><Shape DEF='Round'><Sphere/></Shape></Transform>
          <Transform translation='3 0 0'><Shape USE='Round'/></Transform>
          <Shape><Box size='9 1 9'/></Shape>
        </Scene></X3D>
        """;
    Files.writeString(scene, text);
    assertThat(run("versions", scene.toString(), "--all", "--vert-percent", "20,5")).isZero();
    assertThat(out)
        .contains("Vase_v3")
        .contains("Pot_v3")
        .contains("skipped  Round_2")
        .contains("is drawn elsewhere too (USE)")
        .doesNotContain("Box");
    assertThat(Files.readString(scene))
        .contains("<Transform DEF='Vase'><Switch DEF='Switch_Vase' whichChoice='0'>")
        .contains("<Transform DEF='Pot'><Switch DEF='Switch_Pot' whichChoice='0'>");
    assertThat(folder.resolve("inlineNodes/Vase_v3.x3d")).exists();
    assertThat(run("versions", scene.toString(), "--all", "--vert-percent", "20")).isEqualTo(1);
    assertThat(out).contains("skipped  Vase").contains("has versions");
    assertThat(err).contains("no object gets versions");
    assertThat(run("versions", scene.toString(), "--vert-percent", "20")).isEqualTo(2);
  }

  @Test
  void simplifyReportsJson() throws IOException {
    Path output = folder.resolve("ball_v2.x3d");

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
    "--max-error,-1"
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

  /** Each of the two triangles is as good as a point beside the distance between them. */
  @ParameterizedTest
  @CsvSource({"simplify", "versions"})
  void specksThatAreFarApartAreAProblemOfTheInput(String command) throws IOException {
    String point = "0 0 0 0.0001 0 0 0 0.0001 0 900000 0 0 900000.1 0 0 900000 0.1 0";
    Path specks =
        Files.writeString(
            folder.resolve("specks.x3d"),
            "<X3D version='4.0' profile='Immersive'><Scene><Group DEF='Specks'><Shape>"
                + "<TriangleSet><Coordinate point='%s'/></TriangleSet>".formatted(point)
                + "</Shape></Group></Scene></X3D>");
    List<String> arguments =
        new ArrayList<>(List.of(command, specks.toString(), "--vert-percent", "50"));
    if (command.equals("versions")) {
      arguments.addAll(List.of("--object", "Specks"));
    }

    assertThat(run(arguments.toArray(String[]::new))).isEqualTo(1);
    assertThat(err).contains("specks.x3d").contains("no polygons larger than rounding error");
    assertThat(out).isEmpty();
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
    assertThat(err).contains("ball.x3d").contains("does not exist");
  }

  @ParameterizedTest
  @CsvSource({"simplify,--polygons,961", "simplify,--vert-count,483", "versions,--polygons,961"})
  void moreThanTheOriginalHasIsAProblemOfTheInput(String command, String option, String value) {
    String[] args = {command, scene.toString(), option, value};
    if (command.equals("versions")) {
      args = new String[] {command, scene.toString(), option, value, "--object", "Ball"};
    }

    assertThat(run(args)).isEqualTo(1);
    assertThat(out).isEmpty();
    assertThat(err).contains("ball.x3d").contains("960 polygons and 482 vertices");
  }

  @Test
  void theModelItselfIsNotReplaced() throws IOException {
    assertThat(run("simplify", scene.toString(), "--polygons", "9", "--output", scene.toString()))
        .isEqualTo(2);
    assertThat(err).contains("ball.x3d");
    assertThat(scene).hasContent(BALL);
  }

  @Test
  @RequiresSymbolicLinks
  void aLinkToTheModelIsTheModel() throws IOException {
    Path link = Files.createSymbolicLink(folder.resolve("link.x3d"), scene);

    assertThat(run("simplify", scene.toString(), "--polygons", "9", "--output", link.toString()))
        .isEqualTo(2);
    assertThat(scene).hasContent(BALL);
  }

  @ParameterizedTest
  @CsvSource({"simplify", "versions"})
  void anOutputThatIsNoX3dIsWrongUsage(String command) throws IOException {
    Path output = Files.writeString(folder.resolve("s.obj"), "mine");
    String[] args =
        command.equals("simplify")
            ? new String[] {command, scene.toString(), "--polygons", "99", "--output", "" + output}
            : new String[] {
              command,
              scene.toString(),
              "--polygons",
              "99",
              "--output",
              "" + output,
              "--object",
              "Ball"
            };

    assertThat(run(args)).isEqualTo(2);
    assertThat(err).contains("s.obj").contains(".x3d");
    assertThat(output).hasContent("mine");
  }

  @Test
  void aCompressedOutputIsCompressed() throws IOException {
    Path output = folder.resolve("o.x3dz");

    assertThat(run("simplify", scene.toString(), "--polygons", "99", "--output", output.toString()))
        .isZero();

    try (GZIPInputStream in = new GZIPInputStream(Files.newInputStream(output))) {
      assertThat(new String(in.readAllBytes(), StandardCharsets.UTF_8)).startsWith("<?xml");
    }
  }

  @ParameterizedTest
  @CsvSource({"simplify", "versions", "polygons"})
  void aFolderThatIsNotThereIsSaidBeforeTheWork(String command) {
    Path output = folder.resolve("no/o.svg");
    String[] args =
        switch (command) {
          case "polygons" -> new String[] {command, scene.toString(), "--chart", "" + output};
          case "simplify" ->
              new String[] {
                command, scene.toString(), "--polygons", "99", "--output", "" + folder + "/no/o.x3d"
              };
          default ->
              new String[] {
                command,
                scene.toString(),
                "--polygons",
                "99",
                "--object",
                "Ball",
                "--output",
                "" + folder + "/no/o.x3d"
              };
        };

    assertThat(run(args)).isEqualTo(2);
    assertThat(out).isEmpty();
    assertThat(err.lines()).hasSize(1);
    assertThat(err).contains("no does not exist");
    assertThat(folder.resolve("no")).doesNotExist();
  }

  @Test
  @EnabledOnOs({OS.LINUX, OS.MAC})
  void aPipeMayTakeTheModelWhateverItsName() throws Exception {
    Path pipe = folder.resolve("pipe");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    CompletableFuture<String> reader =
        CompletableFuture.supplyAsync(
            () -> {
              try {
                return new String(Files.readAllBytes(pipe), StandardCharsets.UTF_8);
              } catch (IOException e) {
                throw new UncheckedIOException(e);
              }
            });

    assertThat(run("simplify", scene.toString(), "--polygons", "99", "--output", pipe.toString()))
        .isZero();

    assertThat(reader.get(20, TimeUnit.SECONDS)).contains("<IndexedFaceSet");
  }

  @ParameterizedTest
  @CsvSource({
    "bad.obj,v 0 0 0;f 1 2 3",
    "points.obj,v 0 0 0",
    "empty.obj,''",
    "cut.gltf,{\"asset\":"
  })
  void aDamagedModelIsAProblemOfTheInput(String name, String content) throws IOException {
    Path model = Files.writeString(folder.resolve(name), content.replace(';', '\n'));

    assertThat(run("simplify", model.toString(), "--polygons", "9")).isEqualTo(1);
    assertThat(err).startsWith(model.toString());
    assertThat(err.lines()).hasSize(1);
  }

  @Test
  void aSceneThatIsNotWellFormedIsAProblemOfTheInput() throws IOException {
    Files.writeString(scene, BALL.replace("</Shape>", ""));

    assertThat(run("versions", scene.toString(), "--object", "Ball", "--polygons", "9"))
        .isEqualTo(1);
    assertThat(err).contains("ball.x3d:");
  }

  @Test
  void percentsAreWrittenAsPeopleDo() {
    run("simplify", scene.toString(), "--vert-percent", "0.0001");

    assertThat(err).contains("0.0001 percent of its vertices");
  }

  @Test
  void aDryRunShortensWhatIsLong() throws IOException {
    String points = "0 0 0 1 0 0 0 1 0 ".repeat(2000);
    Files.writeString(
        scene,
        "<X3D version='3.3'><Scene>\n<Shape DEF='Ball'>\n<TriangleSet>\n<Coordinate point='"
            + points
            + "'/>\n</TriangleSet></Shape>\n"
            + "</Scene></X3D>");

    run("versions", scene.toString(), "--object", "Ball", "--polygons", "2000", "--dry-run");

    assertThat(out).contains("- <Shape DEF='Ball'>", "(36,0").hasSizeLessThan(2000);
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
        .contains("would be created  ", "would change  ")
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
