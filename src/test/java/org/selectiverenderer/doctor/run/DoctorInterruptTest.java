package org.selectiverenderer.doctor.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.doctor.Probe;
import org.selectiverenderer.testing.Eventually;

/** Whatever ends the doctor ends the processes that ask for it; all of them are real. */
class DoctorInterruptTest {
  private static final Duration AMPLE = Duration.ofSeconds(60);

  @TempDir Path folder;

  /** A process that examines the machine as the command does, by one child that hangs. */
  private Process examining(Path ready) throws IOException {
    ProcessBuilder builder =
        new ProcessBuilder(DoctorTest.child("examines", List.of())).inheritIO();
    builder.environment().put(FaultyProbeProcess.READY, ready.toString());
    return builder.start();
  }

  private static ProcessHandle childOf(Process parent, Path ready) throws Exception {
    Eventually.await("the child", () -> Files.exists(ready) || !parent.isAlive());
    return parent.children().findFirst().orElseThrow();
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void childrenEndWithTheProcessThatBeganThem(boolean killed) throws Exception {
    Path ready = folder.resolve("ready");
    Process parent = examining(ready);
    ProcessHandle child = childOf(parent, ready);

    if (killed) {
      parent.destroyForcibly();
    } else {
      parent.destroy();
    }

    assertThat(child.onExit().get(AMPLE.toSeconds(), TimeUnit.SECONDS).isAlive()).isFalse();
    assertThat(parent.waitFor(AMPLE.toSeconds(), TimeUnit.SECONDS)).isTrue();
  }

  @Test
  void whoeverIsInterruptedWhileItWaitsLeavesNoProcess() throws Exception {
    Doctor doctor = new Doctor(new ProbeProcess(DoctorTest::child), "/home/ada");
    for (Probe.Place place : List.of(Probe.Place.APART, Probe.Place.ALONE)) {
      List<ProcessHandle> before = ProcessHandle.current().children().toList();
      Thread waiting = Thread.currentThread();
      Thread impatient =
          new Thread(
              () -> {
                Eventually.await(
                    "a child",
                    () -> !ProcessHandle.current().children().allMatch(before::contains));
                waiting.interrupt();
              },
              "impatient");
      impatient.start();
      Probe hangs = new Probe("hangs", "hangs", true, place, AMPLE, found -> {});
      assertThatThrownBy(() -> doctor.examine(List.of(hangs)))
          .isInstanceOf(InterruptedException.class);
      impatient.join();
      assertThat(ProcessHandle.current().children().filter(one -> !before.contains(one)))
          .allSatisfy(one -> one.onExit().get(AMPLE.toSeconds(), TimeUnit.SECONDS));
    }
  }
}
