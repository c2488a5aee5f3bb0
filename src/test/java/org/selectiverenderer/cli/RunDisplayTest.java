package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.testing.RequiresDisplay;

/** {@code run} with two eyes, a head log and replays. */
@RequiresDisplay
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class RunDisplayTest {
  @TempDir private Path folder;
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  private int run(String... arguments) {
    List<String> all = new ArrayList<>(List.of("run", "scenes/trashcan.x3d"));
    all.addAll(List.of(arguments));
    err.reset();
    try (PrintStream out =
            new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8);
        PrintStream messages = new PrintStream(err, true, StandardCharsets.UTF_8)) {
      return Main.execute(all.toArray(String[]::new), out, messages);
    }
  }

  private String messages() {
    return err.toString(StandardCharsets.UTF_8);
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
        "{\"name\": \"ours\", \"width\": 400, \"height\": 300, \"field_of_view\": {\"diagonal\": 60}}");
    assertThat(
            run("--offscreen", "--display", "side-by-side", "--hmd", own.toString(), "--ipd", "60"))
        .isZero();
    assertThat(messages()).contains("ours: two pictures of 400x300", "eyes 60.0 mm apart");
    Files.writeString(own, "{\"width\": 400}");
    assertThat(run("--offscreen", "--display", "side-by-side", "--hmd", own.toString()))
        .isEqualTo(1);
    assertThat(messages()).contains("own.json", "\"height\" is missing");
  }

  @Test
  void optionsThatMakeNoSenseAreRefused() {
    assertThat(run("--ipd", "63")).isEqualTo(2);
    assertThat(messages()).contains("--hmd and --ipd are for two eyes");
    assertThat(run("--display", "dual", "--ipd", "630")).isEqualTo(2);
    assertThat(messages()).contains("from 0 to 100");
    assertThat(run("--display", "mirror")).isEqualTo(2);
    assertThat(messages()).contains("window, side-by-side, dual, quad, anaglyph");
    assertThat(run("--display", "dual", "--hmd", "proview40")).isEqualTo(2);
    assertThat(messages()).contains("neither proview50, proview30, desk nor a file");
    assertThat(run("--tracker", "intertrax:/dev/ttyUSB0")).isEqualTo(2);
    assertThat(run("--head-log", file("log.txt"))).isEqualTo(2);
    assertThat(run("--tracker", "replay:" + file("no-such.csv"))).isEqualTo(2);
    assertThat(messages()).contains("no-such.csv").doesNotContain("Exception");
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

  /** Poses to a millionth: a replayed angle may differ in its last digit. */
  private List<String> withoutFrameTimes(String name) throws IOException {
    List<String> lines = new ArrayList<>();
    for (String line : Files.readAllLines(folder.resolve(name))) {
      String[] cells = line.substring(0, line.lastIndexOf(',')).split(",", -1);
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
        .contains("--display dual needs monitors 14 and 15", "shown side by side in a window");
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
  void quadBuffersThatTheDriverHasNotAreTold() {
    if (org.selectiverenderer.runtime.render.window.QuadBuffers.available()) {
      return;
    }
    assertThat(run("--display", "quad", "--duration", "0.3")).isZero();
    assertThat(messages()).contains("this one has none", "side by side in a window");
  }
}
