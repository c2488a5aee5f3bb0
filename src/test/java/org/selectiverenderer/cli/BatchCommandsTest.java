package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Commands that take many files: their output, order, errors and exit status. */
class BatchCommandsTest extends CommandTestCase {
  private static final int SCENES = 12;

  @TempDir Path dir;

  @BeforeEach
  void scenes() throws IOException {
    Files.createDirectories(dir.resolve("scenes"));
    for (int i = 0; i < SCENES; i++) {
      write(
          "scenes/s%02d.x3d".formatted(i),
          "<X3D version='3.3' profile='Immersive'><Scene>"
              + "<Shape><Box/></Shape>".repeat(i + 1)
              + "<ProximitySensor DEF='Prox' size='2 2 2'/></Scene></X3D>");
    }
    write("path.csv", "t,x,y,z\n0,0,0,9\n0.1,0,0,0\n");
  }

  private String write(String name, String text) throws IOException {
    return Files.writeString(dir.resolve(name), text).toString();
  }

  private String at(String name) {
    return dir.resolve(name).toString();
  }

  private String scene(int i) {
    return at("scenes/s%02d.x3d".formatted(i));
  }

  private JsonNode json() throws IOException {
    return new ObjectMapper().readTree(printed());
  }

  @Test
  void simulateNamesTheSceneInEachLineAndIsOtherwiseAsForOne() throws IOException {
    List<String> expected = new ArrayList<>();
    for (int i = 0; i < SCENES; i++) {
      assertThat(execute("simulate", scene(i), "--path", at("path.csv"), "--format", "json"))
          .isZero();
      String name = new ObjectMapper().writeValueAsString(scene(i));
      printed().lines().forEach(l -> expected.add("{\"scene\":" + name + "," + l.substring(1)));
    }
    assertThat(expected).allSatisfy(line -> new ObjectMapper().readTree(line));

    int status = execute("simulate", at("scenes"), "--path", at("path.csv"), "--format", "json");

    assertThat(status).isZero();
    assertThat(printed().lines()).containsExactlyElementsOf(expected);
  }

  @Test
  void simulateHeadsEachTimeLineOfAText() throws IOException {
    execute("simulate", scene(3), "--path", at("path.csv"));
    String third = printed();
    execute("simulate", scene(1), "--path", at("path.csv"));
    String first = printed();

    assertThat(execute("simulate", scene(3), scene(1), "--path", at("path.csv"))).isZero();

    assertThat(printed()).isEqualTo(scene(3) + "\n" + third + "\n" + scene(1) + "\n" + first);
  }

  @Test
  void aSceneThatCannotBeReadIsReportedAndTheOthersGoOn() throws IOException {
    String bad = write("scenes/bad.x3d", "<X3D version='3.3'><Scene><Shape");

    int status = execute("polygons", scene(0), bad, at("gone.x3d"), scene(1), "--format", "json");

    assertThat(status).isEqualTo(1);
    assertThat(messages()).contains(bad + ":1").contains(at("gone.x3d"));
    assertThat(json().findValuesAsText("scene")).startsWith(scene(0)).endsWith(scene(1));
    assertThat(json().get(0).get("total_high").asInt()).isEqualTo(12);
  }

  @Test
  void polygonsOfManyScenesAreOneArrayOneTableOrTextsInOrder() throws IOException {
    assertThat(execute("polygons", at("scenes"), "--format", "json")).isZero();
    assertThat(json()).hasSize(SCENES);
    for (int i = 0; i < SCENES; i++) {
      assertThat(json().get(i).get("scene").asText()).isEqualTo(scene(i));
      assertThat(json().get(i).get("total_high").asInt()).isEqualTo(12 * (i + 1));
    }

    execute("polygons", scene(1), "--format", "csv");
    List<String> alone = printed().lines().toList();
    assertThat(execute("polygons", scene(0), scene(1), "--format", "csv")).isZero();
    List<String> together = printed().lines().toList();
    assertThat(together.get(0)).isEqualTo("scene," + alone.get(0));
    assertThat(together.subList(together.size() - alone.size() + 1, together.size()))
        .containsExactlyElementsOf(
            alone.subList(1, alone.size()).stream().map(row -> scene(1) + "," + row).toList());

    execute("polygons", scene(2));
    String text = printed();
    assertThat(execute("polygons", at("scenes") + "/s0{2,2}.x3d")).isZero();
    assertThat(printed()).isEqualTo(text);
  }

  @Test
  void aChartIsOfOneScene() {
    assertThat(execute("polygons", at("scenes"), "--chart", at("c.svg"))).isEqualTo(2);
    assertThat(messages()).contains("--chart draws one scene");
    assertThat(dir.resolve("c.svg")).doesNotExist();
  }

  @Test
  void simplifyWritesEachModelIntoTheFolder() throws IOException {
    String ball =
        "<X3D version='3.3' profile='Immersive'><Scene><Shape><Sphere/></Shape></Scene></X3D>";
    Files.createDirectories(dir.resolve("models/more"));
    Files.createDirectories(dir.resolve("alone"));
    String a = write("models/a.x3d", ball);
    String b = write("models/more/b.x3d", ball);

    assertThat(
            execute(
                "simplify",
                a,
                "--vert-percent",
                "50",
                "--output",
                at("alone/a.x3d"),
                "--format",
                "json"))
        .isZero();
    int status =
        execute(
            "simplify",
            at("models"),
            "--vert-percent",
            "50",
            "--output-dir",
            at("reduced"),
            "--format",
            "json");

    assertThat(status).isZero();
    assertThat(json().findValuesAsText("model")).containsExactly(a, b);
    assertThat(dir.resolve("reduced/a.x3d")).hasSameTextualContentAs(dir.resolve("alone/a.x3d"));
    assertThat(dir.resolve("reduced/b.x3d")).exists();
  }

  @Test
  void simplifyWritesOverNoModelAndNoResultOfAnother() throws IOException {
    Files.createDirectories(dir.resolve("m/n"));
    String a = write("m/a.x3d", "<X3D><Scene/></X3D>");
    write("m/n/a.x3d", "<X3D><Scene/></X3D>");
    String b = write("m/b.x3d", "<X3D><Scene/></X3D>");

    assertThat(execute("simplify", at("m"), "--polygons", "5", "--output-dir", at("out")))
        .isEqualTo(2);
    assertThat(messages()).contains("would both be written to");
    assertThat(execute("simplify", a, b, "--polygons", "5", "--output-dir", at("m"))).isEqualTo(2);
    assertThat(messages()).contains("is one of the models");
    assertThat(execute("simplify", a, b, "--polygons", "5")).isEqualTo(2);
    assertThat(messages()).contains("--output-dir");
    assertThat(dir.resolve("out")).doesNotExist();
  }
}
