package org.selectiverenderer.doctor.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.doctor.Probe;

/** Whatever a probe does, the others are told of; children are real processes. */
class DoctorTest {
  private static final Duration AMPLE = Duration.ofSeconds(60);

  private final Doctor doctor = new Doctor(new ProbeProcess(DoctorTest::child), "/home/ada");

  static List<String> child(String name, List<String> flags) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(flags);
    command.addAll(List.of("-cp", System.getProperty("java.class.path")));
    command.addAll(List.of(FaultyProbeProcess.class.getName(), name));
    return command;
  }

  private static Probe here(String name, Duration limit, Probe.Search search) {
    return new Probe(name, name, true, Probe.Place.HERE, limit, search);
  }

  private static Probe apart(String name, Duration limit) {
    return new Probe(
        name,
        name,
        true,
        Probe.Place.APART,
        limit,
        found -> {
          throw new IllegalStateException("made in the wrong process");
        });
  }

  @Test
  void linesComeInTheOrderOfTheProbes() throws InterruptedException {
    Probe measures =
        new Probe(
            "answers",
            "alone",
            true,
            Probe.Place.ALONE,
            AMPLE,
            found -> found.accept(Diagnosis.ok("never", "never")));
    Probe quick = here("quick", AMPLE, found -> found.accept(Diagnosis.ok("quick", "/home/ada/x")));
    assertThat(doctor.examine(List.of(measures, quick)))
        .containsExactly(
            Diagnosis.ok("child", "one"),
            Diagnosis.warning("child", "two", "three"),
            Diagnosis.ok("quick", "~/x"));
  }

  @Test
  @EnabledOnOs(OS.LINUX) // The JVM's words on a crash, and its status, are the system's.
  void aCrashTakesNothingAlong() throws InterruptedException, IOException {
    Probe after = here("after", AMPLE, found -> found.accept(Diagnosis.ok("after", "told")));
    List<Diagnosis> lines = doctor.examine(List.of(apart("crashes", AMPLE), after));
    assertThat(lines).hasSize(3);
    assertThat(lines.get(0)).isEqualTo(Diagnosis.ok("child", "before the crash"));
    assertThat(lines.get(1).fatal()).isTrue();
    assertThat(lines.get(1).found())
        .matches("the process of this check ended with status [0-9]+: crashed in .+");
    assertThat(lines.get(2).found()).isEqualTo("told");
    Matcher log = Pattern.compile("attach (\\S+\\.log)").matcher(lines.get(1).todo());
    assertThat(log.find()).isTrue();
    Path file = Path.of(log.group(1));
    assertThat(Files.readString(file)).contains("SIGSEGV");
    Files.delete(file);
    assertThat(new File("core")).doesNotExist();
  }

  @Test
  void whatHangsIsGivenUp() throws InterruptedException {
    Probe hangs = here("hangs", Duration.ofMillis(50), found -> new CountDownLatch(1).await());
    List<Diagnosis> lines =
        doctor.examine(
            List.of(apart("hangs", Duration.ofSeconds(2)), hangs, apart("answers", AMPLE)));
    assertThat(lines.get(lines.size() - 1).found()).isEqualTo("two");
    assertThat(lines)
        .filteredOn(line -> line.subject().equals("hangs"))
        .hasSize(2)
        .allSatisfy(line -> assertThat(line.found()).startsWith("no answer in "))
        .allMatch(Diagnosis::fatal);
  }

  @Test
  void aChildThatSaysNothingIsToldOfByItsLastWords() throws InterruptedException {
    assertThat(doctor.examine(List.of(apart("mutters", AMPLE))))
        .singleElement()
        .extracting(Diagnosis::found)
        .isEqualTo("no answer: libGL error: no driver");
  }

  @Test
  void aFailureBecomesALine() throws InterruptedException {
    Probe fails =
        here(
            "fails",
            AMPLE,
            found -> {
              found.accept(Diagnosis.ok("first", "told"));
              throw new UnsatisfiedLinkError("no\n  lib");
            });
    assertThat(doctor.examine(List.of(fails)))
        .containsExactly(Diagnosis.ok("first", "told"), Diagnosis.lacking("fails", "no lib", ""));
  }

  @Test
  void aProgramThatIsNotThereBecomesALine() throws InterruptedException {
    Doctor lost =
        new Doctor(new ProbeProcess((name, flags) -> List.of("/nowhere/at/all")), "/home/ada");
    assertThat(lost.examine(List.of(apart("any", AMPLE))))
        .singleElement()
        .satisfies(line -> assertThat(line.found()).startsWith("no process can be started: "));
  }
}
