package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.command.ProgramInvocation;
import org.selectiverenderer.tracker.emulator.EmulatedInterTrax2;
import org.selectiverenderer.tracker.emulator.InterTrax2Emulator.Settings;
import org.selectiverenderer.tracker.emulator.PseudoTerminal.Maker;

class TrackCommandTest extends CommandTestCase {
  private static final String LOG =
      """
      t,yaw,pitch,roll
      0.0,12.5,-3.0,0.0
      0.01,13.5,-3.0,0.0
      0.02,14.5,-3.0,1.0
      """;

  @TempDir Path folder;

  @Test
  void everyRecordIsAJsonLineAndTheFiguresAreTheLast() throws IOException {
    Path log = Files.writeString(folder.resolve("log.csv"), LOG);

    assertThat(track("replay:" + log, "--format", "json")).isZero();

    List<String> lines = text(out).lines().toList();
    assertThat(lines).hasSize(4);
    assertThat(lines.get(2))
        .matches("\\{\"t\":\\d\\S*,\"yaw\":14\\.5,\"pitch\":-3\\.0,\"roll\":1\\.0}");
    JsonNode figures = new ObjectMapper().readTree(lines.get(3));
    assertThat(figures.fieldNames())
        .toIterable()
        .startsWith("records", "rate_hz", "jitter_ms", "bad", "dropped");
    assertThat(figures.get("records").intValue()).isEqualTo(3);
    assertThat(figures.get("bad").intValue()).isZero();
    assertThat(text(err)).isEmpty();
  }

  @Test
  void whatIsWrittenIsReadByReplay() throws IOException {
    Path log = Files.writeString(folder.resolve("log.csv"), LOG);
    Path copy = folder.resolve("copy.csv");

    assertThat(track("replay:" + log, "--output", copy.toString(), "--invert", "yaw")).isZero();
    assertThat(Files.readAllLines(copy))
        .hasSize(4)
        .startsWith("t,yaw,pitch,roll")
        .last()
        .asString()
        .endsWith(",-14.5000,-3.0000,1.0000");
    assertThat(track("replay:" + copy, "--format", "json", "--swap", "yaw,roll")).isZero();
    assertThat(text(out)).contains("\"yaw\":1.0,\"pitch\":-3.0,\"roll\":-14.5}");
  }

  @Test
  void peopleSeeAngleRateAndFaults() throws IOException {
    assumeTrue(Stream.of(Maker.values()).anyMatch(Maker::installed), "no socat, no script");
    Path link = folder.resolve("tracker");
    Settings still = new Settings(120, (t, into) -> into.turn(90, -45, 0));
    try (EmulatedInterTrax2 device = EmulatedInterTrax2.start(link, still)) {
      assertThat(track("intertrax2:" + device.link(), "--duration", "2")).isZero();
    }
    assertThat(text(out))
        .contains("yaw   90.00  pitch  -45.00  roll    0.00", " Hz  jitter ", "  bad 0  dropped ")
        .contains(" records, ", "age of a record when a display draws it, 60 times per second");
    assertThat(text(err)).isEmpty();
  }

  @Test
  void aTrackerThatSaysNothingMakesStatusOne() throws IOException {
    Path log =
        Files.writeString(folder.resolve("log.csv"), "t,yaw,pitch,roll\n0,0,0,0\n0.8,0,0,0\n");
    assertThat(track("replay:" + log)).isEqualTo(1);
    assertThat(text(err)).contains("replay:" + log + ": no records for 0.5 s");
  }

  @Test
  void faultsOfALogMakeStatusOne() throws IOException {
    Path log = Files.writeString(folder.resolve("log.csv"), "t,yaw,pitch,roll\n0,x,0,0\n");
    assertThat(track("replay:" + log)).isEqualTo(1);
    assertThat(text(err)).contains(log + ":2:3: 'x' is not a number", "has errors");
  }

  @Test
  void wrongUsageIsStatusTwoAndOneSentence() {
    assertFails("no tracker given; name one, such as intertrax2:/dev/ttyUSB0");
    assertFails("'joystick' is not a tracker: there is no tracker of the kind", "joystick");
    assertFails("there is no serial port /dev/nonesuch", "intertrax2:/dev/nonesuch");
    assertFails("--duration must be a number of seconds above 0", "none", "--duration", "0");
    assertFails("--swap needs two angles", "none", "--swap", "yaw");
    assertFails("cannot be swapped with itself", "none", "--swap", "yaw,yaw");
    assertFails("'heading'", "none", "--invert", "heading");
    assertFails("between 0 and 100 ms", "none", "--predict", "500");
    assertFails("write smoothing as HZ or HZ,SPEED", "none", "--smooth=much");
    assertFails("--output writes .csv files", "none", "--output", "log.txt");
    assertFails("--emulate needs --link PATH", "--emulate", "intertrax2");
    assertFails("--link needs --emulate", "none", "--link", "x");
    assertFails("at most 480", "--emulate", "intertrax2", "--link", "x", "--rate", "1000");
  }

  @Test
  void noTrackerIsQuiet() {
    assertThat(track("none", "--duration", "0.3", "--format", "json")).isZero();
    assertThat(text(out)).startsWith("{\"records\":0,\"rate_hz\":0.0,").hasLineCount(1);
  }

  @Test
  void theEmulatorTellsHowToTryIt() {
    assumeTrue(Stream.of(Maker.values()).anyMatch(Maker::installed), "no socat, no script");
    Path link = folder.resolve("tracker");
    assertThat(track("--emulate", "intertrax2", "--link", link.toString(), "--duration", "0.2"))
        .isZero();
    assertThat(text(err)).contains("./selective-renderer track intertrax2:" + link);
    assertThat(link).doesNotExist();
  }

  private void assertFails(String sentence, String... arguments) {
    assertThat(track(arguments)).isEqualTo(2);
    assertThat(text(err)).contains(ProgramInvocation.in(sentence)).doesNotContain("\tat ");
  }

  private int track(String... arguments) {
    return execute(Stream.concat(Stream.of("track"), Stream.of(arguments)).toArray(String[]::new));
  }
}
