package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

/** The last line of a walk tells how long fields had which levels. */
class WalkQualitiesTest extends CommandTestCase {
  @TempDir Path folder;

  /** Four seconds towards the jug; the cellar begins after three of them. */
  private String simulate(String... more) throws IOException {
    return simulate(Path.of("docs/examples/qualities/jug.x3d"), more);
  }

  private String simulate(Path scene, String... more) throws IOException {
    Path path =
        Files.writeString(
            folder.resolve("walk.csv"),
            "t,x,y,z,yaw,pitch,roll\n0,0,0.4,4.5,0,0,0\n4,0,0.4,0.5,0,0,0\n");
    List<String> command = new ArrayList<>(List.of("simulate", scene.toString(), "--path"));
    command.addAll(List.of(path.toString(), "--rate", "50"));
    command.addAll(List.of(more));
    assertThat(execute(command.toArray(String[]::new))).as(messages()).isZero();
    return printed().lines().reduce((first, second) -> second).orElseThrow();
  }

  @Test
  void asText() throws IOException {
    assertThat(simulate())
        .contains(
            "; textures of 1 field: level 0 for 75 % of the time (0 fields at the end), level 1"
                + " for 25 % (1 field); shading of 1 field: level 0 for 75 %");
  }

  @Test
  void asJson() throws IOException {
    assertThat(simulate("--format", "json"))
        .contains(
            "\"qualities\":{\"textures\":{\"fields\":1,\"levels\":[{\"level\":0,\"seconds\":3.0")
        .contains("\"level\":1,\"seconds\":1.0,\"end\":1}]}");
  }

  @Test
  void aLevelThatNothingChangesLastsTheWholeWalk() throws IOException {
    assertThat(simulate("--quality", "textures=low"))
        .contains("textures of 1 field: level 1 for 100 % of the time (1 field at the end)");
  }

  @Test
  void aLevelThatWaitsUntilTheEndIsTold() throws IOException {
    assertThat(simulate("--switch", "unseen"))
        .contains("; not shown, as it would have been seen: Jug_Texture.url");
  }

  @Test
  void scenesWithoutFieldsSayNothingOfThem() throws IOException {
    Path scene =
        Files.writeString(folder.resolve("empty.x3d"), "<X3D><Scene><Viewpoint/></Scene></X3D>");
    assertThat(simulate(scene, "--format", "json")).contains("\"end\"").doesNotContain("qualities");
  }
}
