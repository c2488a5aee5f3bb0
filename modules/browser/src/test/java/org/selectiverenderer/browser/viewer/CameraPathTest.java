package org.selectiverenderer.browser.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;

class CameraPathTest {
  private final ProblemCollector problems = new ProblemCollector();

  private CameraPath parse(String text) {
    CameraPath path = CameraPathReader.parse("p.csv", text, problems).orElseThrow();
    assertThat(problems.list()).isEmpty();
    return path;
  }

  @Test
  void positionsAreLinearInBetweenAndStandBeforeAndAfter() {
    CameraPath path = parse("t,x,y,z\n1,0,1.6,0\n3,4,1.6,-2\n4,4,1.6,-2\n");
    assertThat(path.start()).isEqualTo(1);
    assertThat(path.end()).isEqualTo(4);
    assertThat(path.duration()).isEqualTo(3);
    assertThat(path.at(1.5).position().distance(1, 1.6, -0.5)).isLessThan(1e-12);
    assertThat(path.at(3).position()).isEqualTo(new Vector3d(4, 1.6, -2));
    assertThat(path.at(-5).position()).isEqualTo(new Vector3d(0, 1.6, 0));
    assertThat(path.at(99).position()).isEqualTo(new Vector3d(4, 1.6, -2));
    assertThat(path.at(2).orientation()).isEmpty();
  }

  @Test
  void anglesGoTheShortWayRound() {
    CameraPath path =
        parse("t,x,y,z,yaw,pitch,roll\n0,0,0,0,350,10,0\n1,0,0,0,10,20,-4\n2,0,0,0,-170,20,-4\n");
    assertLooks(path, 0.5, 0, 15, -2);
    assertLooks(path, 0.25, 355, 12.5, -1);
    assertLooks(path, 1, 10, 20, -4);
    assertLooks(path, 2, 190, 20, -4);
  }

  private static void assertLooks(
      CameraPath path, double time, double yaw, double pitch, double roll) {
    Quaterniond expected =
        Viewer.orientation(Math.toRadians(yaw), Math.toRadians(pitch), Math.toRadians(roll));
    Quaterniond actual = path.at(time).orientation().orElseThrow();
    assertThat(Math.abs(actual.dot(expected))).isGreaterThan(1 - 1e-12);
  }

  @Test
  void columnsMayStandInAnyOrderWithBlanksQuotesAndOthersBetween() {
    CameraPath path =
        parse("\uFEFFz, Y ,note,x,t\r\n-1,2,\"a, b\",3,\" 0.5 \"\r\n\r\n-1,2,,3,+1e0\r\n");
    assertThat(path.at(0).position()).isEqualTo(new Vector3d(3, 2, -1));
    assertThat(path.end()).isEqualTo(1);
  }

  @Test
  void theLocaleDoesNotMatter() {
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.forLanguageTag("tr-TR"));
      assertThat(parse("T,X,Y,Z\n0,1.5,0,0").at(0).position().x).isEqualTo(1.5);
    } finally {
      Locale.setDefault(before);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "t,x,y\\n0,1,2|p.csv:1:1: the header lacks z",
        "t,x,y,z,yaw\\n0,1,2,3,4|p.csv:1:1: the header lacks pitch, roll",
        "0,0,1.6,0\\n1,0,1.6,0|p.csv:1:1: the header lacks t, x, y, z",
        "t,x,x,y,z\\n0,1,2,3,4|p.csv:1:5: the header names the column x twice",
        "t;x;y\\n0;1;2|p.csv:1:1: the header lacks z (it must be t,x,y,z or",
        "t,x,y,z\\n0,1,abc,2|p.csv:2:5: 'abc' is not a number; the path is not played",
        "t,x,y,z\\n\\n\\n0,1,,2|p.csv:4:5: a number is missing",
        "n,t,x,y,z\\n\"a,b\",0,1,NaN,2|p.csv:2:11: 'NaN' is not a number",
        "t,x,y,z\\n0,1,0x10,2|p.csv:2:5: '0x10' is not a number",
        "t,x,y,z\\n0,1,1e999,2|p.csv:2:5: '1e999' is not a number",
        "t,x,y,z\\n0,5,1,0,1,6,0,0|p.csv:2:1: the row has 8 values, but the header "
            + "has 4 columns (write numbers with a decimal point, not a comma)",
        "t,x,y,z\\n0,\"1,500\",2,3|p.csv:2:3: '1,500' is not a number (write it with a decimal point",
        "t,x,y,z\\n0,1,2|p.csv:2:1: the row has 3 values, but the header has 4 columns; the",
        "t,x,y,z\\n0,1,2,3\\n0,1,2,3|p.csv:3:1: the time 0 is not later than the row before",
        "t,x,y,z\\n|p.csv: the path has no rows",
        "EMPTY|p.csv:1:1: the file is empty: t,x,y,z",
        "t,x,y,z\\n0,\"1,2,3|p.csv:2:3: the file is not valid CSV"
      })
  void aFaultIsNamedWithItsPlaceAndThePathIsNotPlayed(String text, String message) {
    String csv = text.equals("EMPTY") ? "" : text.replace("\\n", "\n");
    assertThat(CameraPathReader.parse("p.csv", csv, problems)).isEmpty();
    assertThat(problems.list()).hasSize(1);
    assertThat(problems.list().get(0).toString()).startsWith(message);
    assertThat(problems.list().get(0).severity()).isEqualTo(Problem.Severity.ERROR);
  }

  @Test
  void aSpreadsheetsSemicolonsAndDecimalCommasAreRead() {
    CameraPath path =
        CameraPathReader.parse("p.csv", "t;x;y;z\n0;0,5;1;2\n2;1,5;1;2\n", problems).orElseThrow();
    Viewer viewer = new Viewer();
    new PathMotion(path, 0).move(viewer, 1, 0);
    assertThat(viewer.position().x()).isEqualTo(1);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void everyFaultyRowIsNamed() {
    assertThat(CameraPathReader.parse("p.csv", "t,x,y,z\n0,a,0,0\n1,0,0,b\n2,0,0,0", problems))
        .isEmpty();
    assertThat(problems.list()).extracting(p -> p.location().line()).containsExactly(2, 3);
  }

  @Test
  void aFileIsReadAndOneThatIsNoTextIsNamed(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("p.csv");
    Files.writeString(file, "\uFEFFt,x,y,z\r\n0,1,2,3\r\n");
    assertThat(CameraPathReader.read(file, problems)).isPresent();
    Files.write(file, "t,x,y,z\n0,\u00e9,2,3".getBytes(StandardCharsets.ISO_8859_1));
    assertThat(CameraPathReader.read(file, problems)).isEmpty();
    assertThat(problems.list()).singleElement().asString().contains("not UTF-8");
    assertThatThrownBy(() -> CameraPathReader.read(folder.resolve("none.csv"), problems))
        .isInstanceOf(NoSuchFileException.class);
  }

  @Test
  void playingAPathWithoutOrientationsLeavesTheViewersAsItIs() {
    Viewer viewer = new Viewer();
    viewer.turnTo(Viewer.orientation(1, 0, 0));
    Quaterniond before = new Quaterniond(viewer.orientation());
    new PathMotion(parse("t,x,y,z\n0,0,0,0\n2,2,0,0"), 10).move(viewer, 11, 0);
    assertThat(viewer.position().x()).isEqualTo(1);
    assertThat(viewer.orientation().equals(before)).isTrue();
  }
}
