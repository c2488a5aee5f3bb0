package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Who may run a session; with other processes in {@link SessionProcessesTest}. */
class SessionLockTest {
  @TempDir private Path folder;

  @Test
  void aDiskWithoutLocksIsSaid() {
    assertThatThrownBy(
            () ->
                SessionLock.take(
                    folder,
                    "test",
                    channel -> {
                      throw new IOException("No locks available");
                    }))
        .isInstanceOf(IOException.class)
        .hasMessage(
            folder.resolve("session.lock")
                + " cannot be locked (No locks available), so two programs could write at the same"
                + " time; move the study to a disk that supports file locks, such as a local disk");
  }

  @Test
  void whoHoldsItIsSaidAsWellAsItIsKnown() throws IOException {
    Files.writeString(folder.resolve("running.json"), "{\"program\":\"sel");
    assertThatThrownBy(() -> SessionLock.take(folder, "test", channel -> null))
        .hasMessage(
            folder + " is being run by another program; wait until that has ended, or end it");
    Files.writeString(
        folder.resolve("running.json"),
        "{\"program\":\"selective-renderer 1\",\"pid\":7,\"host\":\"lab\",\"since\":\"noon\"}");
    assertThatThrownBy(() -> SessionLock.take(folder, "test", channel -> null))
        .hasMessage(
            folder
                + " is being run by selective-renderer 1 (process 7 on lab, since noon); wait until"
                + " that has ended, or end it");
  }

  @Test
  void theSameProgramIsRefusedWithoutLettingGoOfItsLock() throws IOException {
    SessionLock first = SessionLock.take(folder, "test");
    assertThatThrownBy(() -> SessionLock.take(folder, "test"))
        .hasMessageStartingWith(folder + " is being run by test (process ");
    first.close();
    SessionLock.take(folder, "test").close();
    assertThat(folder.resolve("running.json")).doesNotExist();
  }

  @ParameterizedTest
  @ValueSource(strings = {"session.lock", "running.json"})
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "its folders hold no pipes")
  void aPipeInTheirPlaceIsSaidAndNotWaitedFor(String name)
      throws IOException, InterruptedException {
    Path pipe = folder.resolve(name);
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    assertTimeoutPreemptively(
        Duration.ofSeconds(20),
        () ->
            assertThatThrownBy(() -> SessionLock.take(folder, "test"))
                .isInstanceOf(IOException.class)
                .hasMessageContaining(pipe + ": is a device or a pipe"));
  }
}
