package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.testing.RequiresDisplay;

/** {@code --switch} of run and simulate. */
class SwitchOptionTest extends CommandTestCase {
  private static final String BOX =
      "<Shape><Appearance><Material diffuseColor='%s'/></Appearance><Box size='1 1 1'/></Shape>";

  private static final String VERSION =
      "<MetadataSet><MetadataString name='consistencyType' value='\"consistent\"'/>"
          + "<MetadataString name='degreeOfConsistency' value='\"%s\"'/>"
          + "<MetadataString name='schemaBelonginess' value='\"%s\"'/></MetadataSet>";

  /** A can before the viewer and a cup that a wall hides; the area around the origin. */
  private static final String SCENE =
      "<X3D version='4.0' profile='Full'><Scene>"
          + object("Can", "0 0 -5")
          + object("Cup", "3 0 -9")
          + "<Transform translation='3 0 -7'><Shape><Appearance><Material/></Appearance>"
          + "<Box size='4 4 0.2'/></Shape></Transform>"
          + "<ProximitySensor DEF='Area' size='2 2 2'><MetadataSet containerField='metadata'>"
          + "<MetadataString name='enterTimeSchema' value='\"near\"'/>"
          + "<MetadataString name='exitTimeSchema' value='\"far\"'/></MetadataSet>"
          + "</ProximitySensor></Scene></X3D>";

  /** Enters the area after a second, looks away after three, and stays. */
  private static final String PATH =
      "t,x,y,z,yaw,pitch,roll\n0,0,0,2,0,0,0\n2,0,0,0,0,0,0\n3,0,0,0,0,0,0\n5,0,0,0,120,0,0\n";

  @TempDir Path folder;

  private static String object(String name, String place) {
    return "<Transform translation='%s'><Switch DEF='%s' whichChoice='1'>".formatted(place, name)
        + BOX.formatted("1 0 0")
        + BOX.formatted("0 0 1")
        + "<MetadataSet containerField='metadata'>"
        + VERSION.formatted("low", "near")
        + VERSION.formatted("high", "far")
        + "</MetadataSet></Switch></Transform>";
  }

  @BeforeEach
  void files() throws IOException {
    Files.writeString(folder.resolve("s.x3d"), SCENE);
    Files.writeString(folder.resolve("p.csv"), PATH);
  }

  private String file(String name) {
    return folder.resolve(name).toString();
  }

  private List<String> simulate(String how, String... options) {
    String[] all = new String[options.length + 6];
    System.arraycopy(options, 0, all, 6, options.length);
    List<String> first =
        List.of("simulate", file("s.x3d"), "--path", file("p.csv"), "--switch", how);
    System.arraycopy(first.toArray(), 0, all, 0, 6);
    assertThat(execute(all)).as(messages()).isZero();
    return printed().lines().toList();
  }

  @Test
  void whatIsSeenWaitsAndTheLinesSayHowManyPixelsAreSeen() {
    assertThat(simulate("unseen").stream().filter(line -> line.contains("switch")))
        .satisfiesExactly(
            line -> assertThat(line).contains(" 1.0", "Cup: choice 1 -> 0 (near), not seen"),
            line -> assertThat(line).contains(" 3.", "Can: choice 1 -> 0 (near), not seen"));
    assertThat(simulate("fade:300").stream().filter(line -> line.contains("switch")))
        .satisfiesExactlyInAnyOrder(
            line ->
                assertThat(line).containsPattern(" 1\\.0.*Can: .*, [0-9]{4,} pixels seen, 0 deg"),
            line -> assertThat(line).contains(" 1.0", "Cup", ", not seen"));
    assertThat(simulate("at-once", "--format", "json", "--size", "512x384"))
        .anyMatch(line -> line.matches(".*\"Can\".*\"visible\":true,\"pixels\":[0-9]{4},.*"))
        .anyMatch(line -> line.matches(".*\"Cup\".*\"visible\":false,\"pixels\":0,.*"));
  }

  @Test
  void whatWaitsAtTheEndIsTold() throws IOException {
    Files.writeString(folder.resolve("p.csv"), PATH.replaceFirst("\n5,.*\n$", "\n"));
    assertThat(simulate("unseen"))
        .last()
        .asString()
        .contains("would have been seen: Can: choice 0");
    assertThat(simulate("unseen", "--format", "json"))
        .last()
        .asString()
        .endsWith("\"waiting\":{\"Can\":0}}");
  }

  @ParameterizedTest
  @ValueSource(strings = {"at-once", "fade:200", "unseen", "unseen:20"})
  @RequiresDisplay
  void aRunDecidesAsASimulation(String how) throws IOException {
    assertThat(
            execute(
                "run",
                file("s.x3d"),
                "--path",
                file("p.csv"),
                "--offscreen",
                "--size",
                "160x120",
                "--switch",
                how,
                "--timeline",
                file("t.jsonl")))
        .as(messages())
        .isZero();
    List<String> run = Files.readAllLines(folder.resolve("t.jsonl"));
    assertThat(run).isEqualTo(simulate(how, "--format", "json", "--size", "160x120"));
    assertThat(run.stream().filter(line -> line.contains("\"switch\":"))).hasSize(2);
  }

  @Test
  @RequiresDisplay
  void anotherWayIsRefused() {
    assertThat(execute("run", file("s.x3d"), "--switch", "slowly")).isEqualTo(2);
    assertThat(messages()).contains("slowly", "at-once, fade:MS (up to 10000) or unseen");
  }
}
