package org.selectiverenderer.cli.author;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

class PolygonsCommandTest extends CommandTestCase {
  private static final String TRASH_CAN = "scenes/trashcan.x3d";

  @TempDir Path folder;

  @Test
  void countsTheTrashCansOfTheThesis() {
    assertThat(execute("polygons", TRASH_CAN, "--format", "json")).isZero();
    assertThat(text(out).replaceAll("\\s", ""))
        .contains(
            "{\"switch\":\"Switch_TrashCan\",\"scope\":\"Office\",\"versions\":[1064,93]}",
            "\"schemas\":[\"DeskSchema\"]");
    assertThat(text(err)).isEmpty();
  }

  @Test
  void writesAChartBesideTheData() {
    Path chart = folder.resolve("chart.svg");

    assertThat(execute("polygons", TRASH_CAN, "--chart", chart.toString())).isZero();

    assertThat(chart).content().contains("TrashCan");
    assertThat(text(out)).startsWith(Path.of(TRASH_CAN) + ": ");
  }

  @Test
  void findingsInTheSceneMakeStatusOne() throws IOException {
    Path scene = folder.resolve("scene.x3d");
    Files.writeString(
        scene,
        "<X3D profile='Immersive' version='4.0'><Scene><Inline url='\"no.x3d\"'/></Scene></X3D>");

    assertThat(execute("polygons", scene.toString())).isEqualTo(1);
    assertThat(text(err)).contains("scene.x3d:1:", "no.x3d' is missing").doesNotContain("\tat ");
    assertThat(text(out))
        .contains("0 polygons; no object is enriched")
        .doesNotContain("all objects high");
  }

  @Test
  void wrongUsageIsStatusTwoAndOneSentence() {
    assertFails(
        "--scope: the scene has no group 'Offic'; did you mean Office?", "--scope", "Offic");
    assertFails("--chart needs a file that ends in .png or .svg, not x.gif", "--chart", "x.gif");
    assertFails("no does not exist", "--chart", folder.resolve("no/x.svg").toString());
  }

  @Test
  void aSceneThatIsNotThereIsStatusTwo() {
    assertThat(execute("polygons", "nowhere.x3d")).isEqualTo(2);
    assertThat(text(err)).contains("nowhere.x3d: the file does not exist").hasLineCount(1);
  }

  private void assertFails(String sentence, String... options) {
    String[] args = new String[options.length + 2];
    args[0] = "polygons";
    args[1] = TRASH_CAN;
    System.arraycopy(options, 0, args, 2, options.length);
    assertThat(execute(args)).isEqualTo(2);
    assertThat(text(err)).contains(sentence);
  }
}
