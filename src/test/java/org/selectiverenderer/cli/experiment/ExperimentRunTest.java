package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.testing.ShowsWindows;

/** What experiment run refuses before anybody is assigned, and what it flags. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class ExperimentRunTest extends CommandTestCase {
  @TempDir Path folder;
  private Path study = Path.of("");

  @BeforeEach
  void oneRoom() throws IOException {
    Files.writeString(
        folder.resolve("white.x3d"),
        """
        <X3D version='4.0' profile='Immersive'><Scene>
        <Viewpoint DEF='Here'/><Shape><Sphere radius='0.1'/></Shape>
        </Scene></X3D>
        """);
    Files.writeString(
        folder.resolve("items.csv"),
        "area,object,consistency,present,en\nhall,coat,consistent,yes,Coat\n");
    study = folder.resolve("study.json");
    study("\"tracker\": \"none\"");
  }

  private void study(String keys) throws IOException {
    Files.writeString(
        study,
        """
        {"name": "White", "conditions": ["high"], "participants": 4, "scene": "white.x3d",
         "areas": [{"name": "hall", "viewpoint": "Here", "seconds": 1}], "fade": 0, %s,
         "questionnaires": [{"kind": "recognition", "items": "items.csv"}]}
        """
            .formatted(keys));
  }

  private int run(String... more) {
    List<String> command =
        new ArrayList<>(List.of("experiment", "run", study.toString(), "--unattended", "--trust"));
    command.addAll(List.of(more));
    return execute(command.toArray(String[]::new));
  }

  private Session held(String id) throws IOException {
    return Session.begin(
        LoadedStudy.read(study, new ProblemCollector()).orElseThrow(),
        id,
        1,
        new SessionOptions(Optional.empty(), OptionalDouble.empty(), true, "another window"),
        new ProblemCollector());
  }

  @Test
  void aSessionThatAnotherProgramRunsIsRefusedWithWhoItIs() throws IOException {
    try (Session session = held("001")) {
      for (String[] options : new String[][] {{"--resume"}, {}}) {
        List<String> command = new ArrayList<>(List.of("--participant", "001"));
        command.addAll(List.of(options));
        assertThat(run(command.toArray(String[]::new))).isEqualTo(2);
        assertThat(messages())
            .contains(
                session.folder().path() + " is being run by another window (process ",
                "; wait until that has ended, or end it")
            .hasLineCount(1);
      }
    }
    assertThat(run("--participant", "001", "--resume")).as(messages()).isZero();
  }

  @Test
  void anIdThatLooksLikeAnotherIsAskedAboutOrRefused() throws IOException {
    held("P01").close();
    assertThat(run("--participant", "1")).isEqualTo(2);
    assertThat(messages())
        .contains(
            "the ID 1 resembles P01 of the same study; use --participant P01 for the same"
                + " person, or add --new-participant for a new one");
    assertThat(run("--participant", "p01", "--new-participant")).isEqualTo(2);
    assertThat(messages()).contains("the IDs p01 and P01 differ only in capitals");
    assertThat(run("--participant", "01", "--resume")).isEqualTo(2);
    assertThat(messages())
        .contains("--resume: the study has no participant 01; did you mean --participant P01?");
    assertThat(run("--new-participant")).isEqualTo(2);
    assertThat(messages()).contains("--new-participant needs --participant");
    assertThat(folder.resolve("sub-1")).doesNotExist();
    assertThat(run("--participant", "1", "--new-participant")).as(messages()).isZero();
    assertThat(folder.resolve("sub-1/ses-01/responses.csv")).exists();
  }

  @Test
  void aSilentTrackerIsSaidBeforeAnybodyIsAssignedAndMayBeDoneWithout() throws IOException {
    int port;
    try (DatagramSocket free = new DatagramSocket()) {
      port = free.getLocalPort();
    }
    study("\"tracker\": \"opentrack:" + port + "\"");
    assertThat(run()).isEqualTo(2);
    assertThat(messages())
        .contains(
            "the tracker opentrack:" + port + " sent no record within 2 s; no step was begun.",
            "--without-tracker runs the session without it")
        .hasLineCount(1);
    assertThat(folder.resolve("participants.tsv")).doesNotExist();
    assertThat(folder.resolve("sub-001")).doesNotExist();
    assertThat(run("--without-tracker")).as(messages()).isZero();
    assertThat(flags()).containsExactly("simulated", "tracker-absent");
  }

  @Test
  void whatWasNotAsTheStudyAsksIsFlaggedAndExcluded() throws IOException, InterruptedException {
    Thread device;
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      device = new Thread(() -> sayOnce(server), "device");
      device.start();
      study(
          """
          "tracker": "tcp:127.0.0.1:%d", "display": {"mode": "dual", "hmd": "proview50"},
          "quality": {"min_fps": 1000, "max_tracker_silence": 0.2, "exclude": ["tracker-lost"]}
          """
              .formatted(server.getLocalPort()));
      assertThat(run()).as(messages()).isZero();
      assertThat(messages())
          .contains(
              "exposure-hall: the tracker was silent for ",
              "; the session is flagged tracker-lost",
              "; the session is flagged low-frame-rate",
              "; the session is flagged display-fallback");
    }
    device.join();
    assertThat(flags()).contains("simulated", "display-fallback", "low-frame-rate", "tracker-lost");
    assertThat(execute("experiment", "collect", folder.toString())).isOne();
    assertThat(messages())
        .contains(
            "1 answer of session 1 of the participant 001 is left out, because the study excludes"
                + " sessions flagged tracker-lost (exposure-hall)",
            "collected: 0 answers of 0 participants");
  }

  private static void sayOnce(ServerSocket server) {
    try (Socket socket = server.accept()) {
      socket.getOutputStream().write("0 0 0\n".getBytes(StandardCharsets.US_ASCII));
      socket.getOutputStream().flush();
      // Silent from now on, until the program closes its end.
      assertThat(socket.getInputStream().read()).isEqualTo(-1);
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  private List<String> flags() throws IOException {
    assertThat(execute("experiment", "status", folder.toString(), "--format", "json")).isZero();
    JsonNode row = new ObjectMapper().readTree(printed()).path("sessions").path(0);
    return row.path("flags").findValuesAsText("flag");
  }
}
