package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.selectiverenderer.base.problem.ProblemCollector;

/** What several programs may do to a session at the same time, in processes of their own. */
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class SessionProcessesTest extends TwoRoomStudyFixture {
  private final List<Process> started = new ArrayList<>();

  @AfterEach
  void end() throws InterruptedException {
    for (Process process : started) {
      process.destroyForcibly().waitFor();
    }
  }

  private Process process(String prefix, String id, String how) throws IOException {
    List<String> java =
        List.of(
            ProcessHandle.current().info().command().orElse("java"),
            "-cp",
            System.getProperty("java.class.path"),
            SessionHoldingProcess.class.getName(),
            file.toString(),
            id,
            how);
    List<String> command = new ArrayList<>(java);
    if (!prefix.isEmpty()) {
      command.addAll(0, List.of("sh", "-c", prefix + "; exec \"$@\"", "sh"));
    }
    Process process =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
    started.add(process);
    return process;
  }

  /** What a process says first. */
  private static String said(Process process) throws IOException {
    BufferedReader lines = process.inputReader(StandardCharsets.UTF_8);
    return String.valueOf(lines.readLine());
  }

  @Test
  void aSecondProgramIsRefusedWithWhoHoldsTheSessionWhateverTheFirstHasWritten()
      throws IOException, InterruptedException {
    Session session = begin("001");
    try (session) {
      form(session);
      session.began(session.remaining().get(0), false);
      // Reading the journal must not let go of the lock.
      StudyStatus.of(material(), new ProblemCollector());
      CollectedAnswers.of(
          material(), OptionalInt.empty(), PaperAnswers.none(), new ProblemCollector());
      String events = Files.readString(session.folder().journal());
      for (String how : List.of("resume", "begin")) {
        assertThat(said(process("", "001", how)))
            .startsWith(
                session.folder().path()
                    + " is being run by test (process "
                    + ProcessHandle.current().pid()
                    + " on ")
            .endsWith("; wait until that has ended, or end it");
      }
      assertThat(session.folder().journal()).hasContent(events);
      session.journal().keep("note", Map.of("text", "still mine"));
      assertThat(session.folder().journal()).content().startsWith(events).contains("still mine");
    }
    assertThat(session.folder().path().resolve(SessionLock.HOLDER)).doesNotExist();
    assertThat(said(process("", "001", "resume"))).isEqualTo("held");
  }

  @Test
  void whatAKilledProgramLeftLocksNothing() throws IOException, InterruptedException {
    Process first = process("", "001", "begin");
    assertThat(said(first)).isEqualTo("held");
    Path folder = new SessionFolder(material().study().folder(), "001", 1).path();
    assertThatThrownBy(() -> resume("001"))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith(folder + " is being run by test (process " + first.pid() + " on ");
    first.destroyForcibly().waitFor();
    assertThat(folder.resolve(SessionLock.HOLDER)).exists();
    try (Session session = resume("001")) {
      assertThat(folder.resolve(SessionLock.HOLDER))
          .content()
          .contains("\"pid\" : " + ProcessHandle.current().pid());
      assertThat(left(session)).first().isEqualTo("form");
    }
  }

  @Test
  @DisabledOnOs(
      value = OS.WINDOWS,
      disabledReason = "no limit of a process stands for a full disk there")
  void anEventThatDoesNotFitLeavesNoHalfLine() throws IOException {
    // Files of 8 KiB at most stand for a disk that is full.
    Process filling = process("ulimit -f 16", "001", "fill");
    Path events = new SessionFolder(material().study().folder(), "001", 1).journal();
    assertThat(said(filling))
        .startsWith(events + ": an event could not be written (")
        .endsWith("--resume continues the session once the disk can be written");
    JournalContent text = JournalContent.read(events);
    assertThat(text.tail()).isZero();
    assertThat(text.damaged()).isEmpty();
    assertThat(text.events()).hasSizeGreaterThan(10);
  }
}
