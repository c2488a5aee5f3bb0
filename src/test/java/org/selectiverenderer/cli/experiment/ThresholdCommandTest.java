package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.testing.ShowsWindows;

class ThresholdCommandTest extends CommandTestCase {
  @TempDir private Path folder;
  private String pilot = "";

  @BeforeEach
  void settings() throws IOException {
    Files.writeString(
        folder.resolve("room.x3d"),
        """
        <X3D profile='Interchange' version='4.0'><Scene>
        <Transform DEF='Ball'><Shape><Appearance><Material diffuseColor='0.8 0.2 0.2'/></Appearance><Sphere/></Shape></Transform>
        <Transform DEF='Egg' scale='1 1.5 1'><Shape><Appearance><Material/></Appearance><Sphere radius='2'/></Shape></Transform>
        </Scene></X3D>
        """);
    Path file = folder.resolve("threshold.json");
    Files.writeString(
        file,
        """
        {"name": "Two", "scene": "room.x3d", "rungs": 4, "fewest": 0.05, "picture": 64,
         "reversals": 4, "objects": [{"object": "Ball"}, {"object": "Egg"}]}
        """);
    pilot = file.toString();
  }

  private int threshold(String... more) {
    return execute(
        Stream.concat(Stream.of("experiment", "threshold", pilot), Stream.of(more))
            .toArray(String[]::new));
  }

  @Test
  @ShowsWindows
  void aPilotFromItsPicturesToTheVersionsThatItAsksFor() throws IOException {
    assertThat(threshold("--participant", "001", "--unattended")).as(messages()).isZero();
    assertThat(messages()).contains("making the versions of Ball", "is finished after");
    Path pictures = folder.resolve("threshold/pictures");
    var list = JsonTree.read(pictures.resolve("pictures.json"));
    assertThat(list.path("polygons").path("Ball")).hasSize(5);
    Path fewest = pictures.resolve("01-Ball_version-01_view-1.png");
    assertThat(fewest).isNotEmptyFile();
    assertThat(Files.mismatch(fewest, pictures.resolve("01-Ball_version-05_view-1.png")))
        .as("the first byte in which the versions' pictures differ")
        .isNotNegative();

    assertThat(threshold("--participant", "002", "--unattended")).isZero();
    assertThat(messages()).doesNotContain("making the versions");
    assertThat(threshold("--participant", "002", "--unattended")).isEqualTo(2);
    assertThat(messages()).contains("sub-002 exists already");
    assertThat(threshold("--participant", "002", "--unattended", "--resume")).isEqualTo(2);
    assertThat(messages()).contains("sub-002 is complete");

    Path commands = folder.resolve("make.sh");
    assertThat(threshold("--results", "--commands", commands.toString())).isZero();
    assertThat(printed()).contains("Two: 2 participants", "Ball", "Egg");
    assertThat(commands).content().contains("--object Ball --polygons ");
    assertThat(threshold("--results", "--format", "json")).isZero();
    int polygons = JsonTree.parse(printed()).path("objects").get(0).path("polygons").asInt();
    assertThat(
            execute(
                "versions",
                folder.resolve("room.x3d").toString(),
                "--object",
                "Ball",
                "--polygons",
                Integer.toString(polygons)))
        .as(messages())
        .isZero();

    // The scene has changed, so its pictures would no longer be those of the first participants.
    assertThat(threshold("--participant", "003", "--unattended")).isZero();
    assertThat(messages()).contains("making the versions of Ball");
  }

  @Test
  void whatDoesNotGoTogetherIsWrongUsage() {
    assertThat(threshold()).isEqualTo(2);
    assertThat(messages()).contains("--participant ID or --results is needed");
    assertThat(threshold("--results", "--participant", "001")).isEqualTo(2);
    assertThat(threshold("--participant", "a b")).isEqualTo(2);
    assertThat(threshold("--participant", "001", "--commands", "x")).isEqualTo(2);
  }

  @Test
  void aFaultInTheSettingsIsAProblemWithItsPlace() throws IOException {
    Files.writeString(Path.of(pilot), Files.readString(Path.of(pilot)).replace("rungs", "rung"));
    assertThat(threshold("--results")).isEqualTo(1);
    assertThat(messages()).contains("threshold.json:1:", "did you mean \"rungs\"?");
  }

  @Test
  @ShowsWindows
  void anObjectThatTheSceneLacksIsAProblem() throws IOException {
    Files.writeString(Path.of(pilot), Files.readString(Path.of(pilot)).replace("Egg", "Jar"));
    assertThat(threshold("--participant", "001", "--unattended")).isEqualTo(1);
    assertThat(messages()).contains("there is no node with DEF 'Jar' in the scene");
    assertThat(folder.resolve("threshold/pictures/pictures.json")).doesNotExist();
  }
}
