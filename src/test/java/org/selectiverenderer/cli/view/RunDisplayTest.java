package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.testing.ShowsWindows;

/** {@code run} with two eyes, a head log and replays. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class RunDisplayTest extends CommandTestCase {
  @TempDir private Path folder;

  private int run(String... arguments) {
    List<String> all = new ArrayList<>(List.of("run", "scenes/trashcan.x3d"));
    all.addAll(List.of(arguments));
    return execute(all.toArray(String[]::new));
  }

  private String file(String name) {
    return folder.resolve(name).toString();
  }

  @Test
  void sideBySideIsAsLargeAsBothPicturesOfTheDisplayAndIsExplained() throws IOException {
    assertThat(run("--offscreen", "--display", "side-by-side", "--screenshot", file("both.png")))
        .isZero();
    var picture = ImageIO.read(folder.resolve("both.png").toFile());
    assertThat(picture.getWidth()).isEqualTo(1280);
    assertThat(picture.getHeight()).isEqualTo(480);
    assertThat(messages())
        .contains("ProView 50: two pictures of 640x480, side by side", "40.9 x 31.3 degrees");
  }

  @Test
  void oneViewIsAsLargeAsEver() throws IOException {
    assertThat(run("--offscreen", "--samples", "0", "--screenshot", file("one.png"))).isZero();
    var picture = ImageIO.read(folder.resolve("one.png").toFile());
    assertThat(picture.getWidth()).isEqualTo(1024);
    assertThat(picture.getHeight()).isEqualTo(768);
    assertThat(messages()).isEmpty();
  }

  @Test
  void aPlainSizeSaysWhatThePictureIs() {
    assertThat(run("--offscreen", "--display", "side-by-side", "--size", "1024x768")).isZero();
    assertThat(messages()).contains("two pictures of 512x384 (the display has 640x480)");
  }

  @Test
  void aDisplayOfOnesOwnAndItsFaults() throws IOException {
    Path own = folder.resolve("own.json");
    Files.writeString(
        own,
        "{\"name\": \"ours\", \"width\": 400, \"height\": 300, \"field_of_view\": {\"diagonal\":"
            + " 60}}");
    assertThat(
            run("--offscreen", "--display", "side-by-side", "--hmd", own.toString(), "--ipd", "60"))
        .isZero();
    assertThat(messages()).contains("ours: two pictures of 400x300", "eyes 60.0 mm apart");
    Files.writeString(own, "{\"width\": 400}");
    assertThat(run("--offscreen", "--display", "side-by-side", "--hmd", own.toString()))
        .isEqualTo(1);
    assertThat(messages()).contains("own.json", "a display profile needs \"height\"");
  }

  @Test
  void optionsThatMakeNoSenseAreRefused() {
    assertThat(run("--ipd", "63")).isEqualTo(2);
    assertThat(messages()).contains("--hmd and --ipd need a display for two eyes");
    assertThat(run("--display", "dual", "--ipd", "630")).isEqualTo(2);
    assertThat(messages()).contains("from 0 to 100");
    assertThat(run("--display", "mirror")).isEqualTo(2);
    assertThat(messages()).contains("window, side-by-side, dual, quad, anaglyph or openxr");
    assertThat(run("--display", "dual", "--hmd", "proview40")).isEqualTo(2);
    assertThat(messages()).contains("neither a file nor one of proview50, proview30 and desk");
    assertThat(run("--tracker", "intertrax:/dev/ttyUSB0")).isEqualTo(2);
    assertThat(run("--head-log", file("log.txt"))).isEqualTo(2);
    assertThat(run("--tracker", "replay:" + file("no-such.csv"))).isEqualTo(2);
    assertThat(messages()).contains("no-such.csv").doesNotContain("Exception");
  }

  @Test
  void optionsThatWouldDoNothingAreRefused() {
    assertThat(run("--offscreen", "--operator-screenshot", file("o.png"))).isEqualTo(2);
    assertThat(messages()).contains("--operator-screenshot", "cannot be combined with --offscreen");
    assertThat(run("--operator-screenshot", file("o.png"))).isEqualTo(2);
    assertThat(messages()).contains("--operator-screenshot needs --operator");
    assertThat(run("--offscreen", "--operator")).isEqualTo(2);
    assertThat(run("--offscreen", "--tracker-lost", "mouse")).isEqualTo(2);
    assertThat(messages()).contains("--tracker-lost needs --tracker");
    assertThat(run("--offscreen", "--invert", "yaw")).isEqualTo(2);
    assertThat(messages()).contains("need --tracker");
    assertThat(run("--offscreen", "--cone", "5")).isEqualTo(2);
    assertThat(messages()).contains("--cone needs --head-log");
    assertThat(run("--offscreen", "--force")).isEqualTo(2);
  }

  @Test
  void aHeadLogIsReplacedOnlyWhenAskedToAndNeverItsOwnSource() throws IOException {
    Path log = Files.writeString(folder.resolve("p01.csv"), "a participant's");
    // A port that is not there: the tracker is not opened before.
    String tracker = "intertrax2:" + file("ttyUSB7");
    assertThat(run("--offscreen", "--tracker", tracker, "--head-log", log.toString())).isEqualTo(2);
    assertThat(messages()).contains("p01.csv exists already (--force replaces it)");
    assertThat(log).hasContent("a participant's");
    Files.move(log, folder.resolve("p01.json"));
    assertThat(run("--offscreen", "--head-log", log.toString())).isEqualTo(2);
    assertThat(messages()).contains("p01.json exists already");
    assertThat(run("--offscreen", "--head-log", log.toString(), "--force")).isZero();
    assertThat(log).content().startsWith("t,x,y,z");
    String before = Files.readString(log);
    assertThat(
            run(
                "--offscreen",
                "--tracker",
                "replay:" + log,
                "--head-log",
                log.toString(),
                "--force"))
        .isEqualTo(2);
    assertThat(messages()).contains("would overwrite --tracker");
    assertThat(log).hasContent(before);
    assertThat(run("--offscreen", "--head-log", file("p02.csv"), "--stats", file("p02.json")))
        .isEqualTo(2);
    assertThat(messages()).contains("p02.json: is written by --stats");
    assertThat(run("--offscreen", "--head-log", "/proc/p03.csv")).isEqualTo(2);
    assertThat(messages()).contains(Path.of("/proc/p03.csv").toString()).doesNotContain("json");
  }

  @Test
  void theHeadLogOfAWindowHasEveryFrameToTheLast() throws IOException {
    assertThat(
            run(
                "--duration",
                "0.4",
                "--size",
                "200x150",
                "--head-log",
                file("log.csv"),
                "--timeline",
                file("log.jsonl")))
        .isZero();
    List<String> log = Files.readAllLines(folder.resolve("log.csv"));
    List<String> timeline = Files.readAllLines(folder.resolve("log.jsonl"));
    JsonNode end = new ObjectMapper().readTree(timeline.get(timeline.size() - 1));
    assertThat(log).hasSize(1 + end.get("frames").asInt());
    assertThat(Double.parseDouble(log.get(log.size() - 1).split(",")[0]))
        .isEqualTo(end.get("t").asDouble());
  }

  @Test
  void aSerialPortThatIsNotThereEndsTheRunInASentence() {
    assertThat(run("--offscreen", "--tracker", "intertrax2:" + file("ttyUSB7"))).isEqualTo(2);
    assertThat(messages()).contains("ttyUSB7").doesNotContain("Exception");
  }

  @Test
  void theCheckPatternIsShownInsteadOfTheScene() throws IOException {
    assertThat(run("--offscreen", "--hmd-check", "--screenshot", file("check.png"))).isZero();
    var picture = ImageIO.read(folder.resolve("check.png").toFile());
    assertThat(picture.getWidth()).isEqualTo(1280);
    // White frames about both pictures, the middle lines crossing where each eye looks.
    assertThat(picture.getRGB(0, 240) & 0xffffff).isEqualTo(0xffffff);
    assertThat(picture.getRGB(639, 200) & 0xffffff).isEqualTo(0xffffff);
    assertThat(picture.getRGB(1279, 200) & 0xffffff).isEqualTo(0xffffff);
    assertThat(picture.getRGB(320, 40) & 0xffffff).isEqualTo(0x55c878);
    assertThat(picture.getRGB(960, 40) & 0xffffff).isEqualTo(0x55c878);
  }

  @Test
  void theCheckPatternsLinesAreWhereTheyMeasureAndAsThickAsMeant() throws IOException {
    assertThat(
            run("--offscreen", "--samples", "0", "--hmd-check", "--screenshot", file("check.png")))
        .isZero();
    var picture = ImageIO.read(folder.resolve("check.png").toFile());
    // The frame is the outermost pixel on all sides of both pictures.
    for (int left : new int[] {0, 640}) {
      for (int[] at : new int[][] {{0, 50}, {639, 50}, {200, 0}, {200, 479}}) {
        assertThat(picture.getRGB(left + at[0], at[1]) & 0xffffff).isEqualTo(0xffffff);
      }
      for (int[] at : new int[][] {{1, 50}, {638, 50}, {200, 1}, {200, 478}}) {
        assertThat(picture.getRGB(left + at[0], at[1]) & 0xffffff).isNotEqualTo(0xffffff);
      }
      // 50 degrees from corner to corner: half the width is 800/640 of tan 25 degrees.
      double half = Math.tan(Math.toRadians(25)) * 640 / 800;
      for (int degrees : new int[] {-15, -10, -5, 0, 5, 10, 15}) {
        double at = 320 + 320 * Math.tan(Math.toRadians(degrees)) / half;
        int wide = degrees % 10 == 0 ? 2 : 1;
        for (int x = (int) at - 4; x <= (int) at + 4; x++) {
          boolean on = x + 0.5 > at - wide / 2.0 && x + 0.5 <= at + wide / 2.0;
          int color = picture.getRGB(left + x, 30) & 0xffffff;
          assertThat(color == (wide == 2 ? 0x55c878 : 0x2f6f3f))
              .as(degrees + ": " + x)
              .isEqualTo(on);
        }
      }
    }
  }

  @Test
  void aReplayedHeadLogShowsTheSameFramesAgain() throws IOException {
    Path path = folder.resolve("path.csv");
    Files.writeString(
        path,
        "t,x,y,z,yaw,pitch,roll\n"
            + "0,3.6,-0.246,-2.3,-150,-10,0\n0.5,5.2,-0.246,-0.2,-170,-25,8\n");
    String[] picture = {"--offscreen", "--display", "side-by-side", "--samples", "0"};
    assertThat(
            run(
                with(
                    picture,
                    "--path",
                    path.toString(),
                    "--head-log",
                    file("first.csv"),
                    "--timeline",
                    file("first.jsonl"),
                    "--screenshot",
                    file("first.png"))))
        .isZero();
    assertThat(
            run(
                with(
                    picture,
                    "--tracker",
                    "replay:" + file("first.csv"),
                    "--head-log",
                    file("again.csv"),
                    "--timeline",
                    file("again.jsonl"),
                    "--screenshot",
                    file("again.png"))))
        .isZero();
    List<String> first = withoutFrameTimes("first.csv");
    assertThat(first).hasSize(32).anyMatch(line -> line.contains("DeskSchema"));
    assertThat(withoutFrameTimes("again.csv")).isEqualTo(first);
    assertThat(folder.resolve("again.jsonl"))
        .hasSameTextualContentAs(folder.resolve("first.jsonl"));
    assertThat(folder.resolve("again.png")).hasSameBinaryContentAs(folder.resolve("first.png"));
  }

  private static String[] with(String[] some, String... more) {
    List<String> all = new ArrayList<>(List.of(some));
    all.addAll(List.of(more));
    return all.toArray(String[]::new);
  }

  /**
   * Without the machine's clocks, and poses to a millionth: a replayed angle may differ in its last
   * digit.
   */
  private List<String> withoutFrameTimes(String name) throws IOException {
    List<String> lines = new ArrayList<>();
    for (String line : Files.readAllLines(folder.resolve(name))) {
      // frame_ms, wall and mono are the machine's; visible, between them, is the log's.
      String[] cells = line.replaceAll(",[^,]*(,[^,]*),[^,]*,[^,]*$", "$1").split(",", -1);
      for (int i = 0; i < 7; i++) {
        if (!lines.isEmpty()) {
          cells[i] =
              String.format(java.util.Locale.ROOT, "%.6f", Double.parseDouble(cells[i]) + 0.0);
        }
      }
      lines.add(String.join(",", cells));
    }
    return lines;
  }

  @Test
  void missingMonitorsAndBuffersAreToldAndBothEyesShownInAWindow() throws IOException {
    assertThat(
            run(
                "--display",
                "dual",
                "--hmd",
                farMonitor(),
                "--duration",
                "0.3",
                "--screenshot",
                file("dual.png"),
                "--operator",
                "--operator-screenshot",
                file("operator.png")))
        .isZero();
    assertThat(messages())
        .contains(
            "--display dual needs monitors 14 and 15",
            "shown side by side in a window",
            "two pictures of 400x300, side by side")
        .doesNotContain("on monitor 14");
    var picture = ImageIO.read(folder.resolve("dual.png").toFile());
    assertThat(picture.getWidth()).isEqualTo(800);
    assertThat(ImageIO.read(folder.resolve("operator.png").toFile()).getWidth()).isPositive();
  }

  private String farMonitor() throws IOException {
    Path own = folder.resolve("far.json");
    Files.writeString(
        own,
        "{\"width\": 400, \"height\": 300, \"field_of_view\": {\"diagonal\": 50},"
            + " \"screens\": {\"left\": 14, \"right\": 15}}");
    return own.toString();
  }

  @Test
  void quadBuffersThatTheDriverHasNotAreTold() throws IOException {
    if (org.selectiverenderer.render.window.QuadBufferSupport.available()) {
      return;
    }
    assertThat(
            run(
                "--display",
                "quad",
                "--duration",
                "0.3",
                "--size",
                "600x300",
                "--screenshot",
                file("quad.png"),
                "--head-log",
                file("quad.csv")))
        .isZero();
    assertThat(messages())
        .contains(
            "this one has none",
            "side by side in a window",
            "two pictures of 300x225 (the display has 640x480), side by side")
        .doesNotContain("buffers,");
    assertThat(ImageIO.read(folder.resolve("quad.png").toFile()).getWidth()).isEqualTo(600);
    assertThat(
            new ObjectMapper()
                .readTree(folder.resolve("quad.json").toFile())
                .get("display")
                .asText())
        .contains("300x225", "side by side");
  }

  @Test
  void aSavedPictureHasSmoothEdgesAlsoWhereFramesHaveNone() throws IOException {
    assertThat(colours("--offscreen", "--duration", "0.1")).isGreaterThan(2);
    assertThat(colours("--duration", "0.1")).isGreaterThan(2);
    assertThat(colours("--offscreen", "--duration", "0.1", "--samples", "0")).isEqualTo(2);
    assertThat(colours("--duration", "0.1", "--samples", "0")).isEqualTo(2);
  }

  /** Returns the number of colours of the picture of a white square, turned, before black. */
  private long colours(String... options) throws IOException {
    Path scene = folder.resolve("square.x3d");
    Files.writeString(
        scene,
        """
        <X3D version='4.0' profile='Full'><Scene>
        <Transform rotation='0 0 1 0.3'><Shape>
        <Appearance><Material diffuseColor='0 0 0' emissiveColor='1 1 1'/></Appearance>
        <Rectangle2D/></Shape></Transform></Scene></X3D>
        """);
    String[] run = {"run", scene.toString(), "--size", "160x120", "--headlight", "off"};
    String[] all = with(with(run, options), "--screenshot", file("square.png"));
    assertThat(execute(all)).as(messages()).isZero();
    var picture = ImageIO.read(folder.resolve("square.png").toFile());
    int[] pixels = picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, 160);
    return Arrays.stream(pixels).distinct().count();
  }
}
