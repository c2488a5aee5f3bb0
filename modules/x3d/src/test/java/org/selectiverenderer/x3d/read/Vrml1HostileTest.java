package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.lines;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.room;
import static org.selectiverenderer.x3d.read.Vrml1Fixture.scene;

import java.io.IOException;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.x3d.source.ReadLimits;

/** Files in VRML 1.0 that are broken, or made to take time and memory. */
class Vrml1HostileTest {
  private final ReaderFixture fixture = new ReaderFixture();

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Separator { Cube {} Sphere {          | 2:29: the file is cut off here",
        "Separator { Cube {} Sphere { radius ] | 2:37:",
        "Separator { Cube {} 3 } Sphere {}     | 2:23: the value of the field '3' is expected",
        "Separator { Cube {} AsciiText { string \"a } | 2:40: the string that begins here",
        "Separator { Cube {} Coordinate3 { point [ 1 2 | 2:41: the list that begins here",
        "Separator { Cube {} Cone { parts (SIDES | 2:34:",
        "Separator { Cube {} DEF | 2:24:",
        "Separator { Cube {} } } | 2:23:",
      })
  void aBrokenTextKeepsWhatWasBefore(String text, String problem) {
    X3dFile file = scene(fixture, text);
    assertThat(file.nodes()).isNotEmpty();
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.toString()).startsWith("test.x3d:" + problem))
        .satisfies(told -> assertThat(told.message()).endsWith("; the part before it is kept"));
  }

  @Test
  void partsOfPointsCountAsCopies() {
    String points = "Coordinate3 { point [ " + "0 0 0, ".repeat(20_000) + "] }";
    scene(fixture, "Separator { " + points + "PointSet { startIndex 1 } ".repeat(400) + "}");
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.message()).contains("these copies have more than"));
  }

  @Test
  void aFieldOfOneValueIsNotCopiedWholeForEachUse() {
    X3dFile file =
        scene(
            fixture,
            "Separator { DEF T Translation { translation 1 2 3 "
                + " ".repeat(1_000_000)
                + "} "
                + "Separator { USE T Cube { } } ".repeat(300)
                + "}");
    assertThat(file.nodes()).isNotEmpty();
    fixture.assertClean();
  }

  @Test
  void aRoomCutAtAnyByteOrChangedIsReadAsFarAsItGoes() throws IOException {
    byte[] good = room();
    for (int length = 17; length < good.length; length += 37) {
      fixture.read(Arrays.copyOf(good, length));
    }
    Random random = new Random(5);
    for (int round = 0; round < 300; round++) {
      byte[] bytes = good.clone();
      for (int i = random.nextInt(4); i >= 0; i--) {
        int at = 17 + random.nextInt(bytes.length - 17);
        bytes[at] = (byte) "{}[]()#\"|, -1xA".charAt(random.nextInt(15));
      }
      fixture.read(bytes);
      assertThat(fixture.problems.list())
          .allSatisfy(told -> assertThat(told.message()).isNotBlank());
    }
  }

  @Test
  void nestingIsLimited() {
    X3dFile file = scene(fixture, "Cube {} " + "Separator { Cube {} ".repeat(5000));
    assertThat(file.nodes()).isNotEmpty();
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.message()).contains("nested more than 100 deep"));
  }

  @Test
  @Timeout(60)
  void objectsThatUseOneAnotherAreLimited() {
    StringBuilder bomb = new StringBuilder("DEF A0 Separator { Sphere {} }\n");
    for (int i = 1; i < 60; i++) {
      bomb.append("DEF A%d Separator { USE A%d ".formatted(i, i - 1));
      bomb.append("Material { shininess 0.%d } USE A%d }\n".formatted(i, i - 1));
    }
    X3dFile file = scene(fixture, bomb.toString());
    assertThat(file.nodes()).isNotEmpty();
    assertThat(fixture.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.message()).contains("more than 10000"));
    scene(fixture, bomb.toString().replace("Sphere {}", ""));
    fixture.assertClean();
  }

  @Test
  @Timeout(60)
  void copiesOfLongListsAreLimited() {
    ReaderFixture large = new ReaderFixture(ReadLimits.standard());
    String text =
        "#VRML V1.0 ascii\nCoordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] }\nDEF Long IndexedFaceSet {"
            + " coordIndex [ "
            + "0 1 2 -1 ".repeat(20_000)
            + "] }\n"
            + "Material {} USE Long\n".repeat(2000);
    X3dFile file = large.read(text);
    assertThat(file.nodes()).isNotEmpty();
    assertThat(large.problems.list())
        .singleElement()
        .satisfies(told -> assertThat(told.message()).contains("16,777,216 characters"));
  }

  @Test
  void numbersBeyondAllMeasureStayNumbers() {
    assertThat(
            lines(
                "Separator { Scale { scaleFactor 1e38 1 1 } Scale { scaleFactor 1e38 1 1 } Texture2"
                    + " { image 1 1 1 0 } Texture2Transform { scaleFactor 1e-38 1e38 center 1e38"
                    + " 1e38 } Cube {} }"))
        .allSatisfy(line -> assertThat(line).doesNotContain("Inf").doesNotContain("NaN"))
        .contains(" Shape");
  }

  @Test
  void aLimitDoesNotHideASyntaxFault() {
    String nested = "Separator { Cube {} ".repeat(99) + "}".repeat(99) + "\n";
    scene(fixture, nested + "Sphere { radius ] }");
    assertThat(fixture.problems.list())
        .satisfiesExactly(
            limit -> assertThat(limit.toString()).startsWith("test.x3d:2:").contains("100 deep"),
            fault -> assertThat(fault.toString()).startsWith("test.x3d:3:17:"));
  }

  @Test
  void aLimitOfTheX3dElementsSaysThatTheyAreWhatIsNested() {
    scene(fixture, "Separator { Cube {} ".repeat(99) + "}".repeat(99));
    fixture.assertOnly(
        "test.x3d:2:1917: the X3D elements that show these nodes are nested more than 100 deep,"
            + " with those for lights and transformations; the part before it is kept");
  }

  @Test
  void tenThousandLightsBetweenShapesAreReadWithoutProblems() {
    ReaderFixture large = new ReaderFixture(ReadLimits.standard());
    X3dFile file = large.read("#VRML V1.0 ascii\n" + "PointLight{}Cube{}\n".repeat(10_000));
    assertThat(file.nodes()).isNotEmpty();
    large.assertClean();
  }
}
