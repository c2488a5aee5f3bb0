package org.selectiverenderer.base.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class InputFileReaderTest {
  @TempDir Path folder;

  private static void assertRefused(Path path, String reason) {
    assertThatExceptionOfType(FileSystemException.class)
        .isThrownBy(
            () ->
                assertTimeoutPreemptively(
                    Duration.ofSeconds(20), () -> InputFileReader.bytes(path)))
        .withMessageContaining(path.toString())
        .withMessageContaining(reason);
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "its folders hold no devices and pipes")
  void devicesAndPipesAreRefused() throws IOException, InterruptedException {
    Path pipe = folder.resolve("pipe.csv");
    new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor();
    Path link = Files.createSymbolicLink(folder.resolve("zero.csv"), Path.of("/dev/zero"));

    assertRefused(Path.of("/dev/zero"), "is a device or a pipe");
    assertRefused(link, "is a device or a pipe");
    assertRefused(pipe, "is a device or a pipe");
    assertRefused(folder, "is a folder");
  }

  @Test
  void longFilesAreRefused() throws IOException {
    Path file = Files.write(folder.resolve("a.csv"), new byte[11]);

    assertThat(InputFileReader.bytes(file, 11)).hasSize(11);
    assertThatExceptionOfType(FileSystemException.class)
        .isThrownBy(() -> InputFileReader.bytes(file, 10))
        .withMessageContaining("is longer than 1 MB");
  }

  @Test
  void textIsUtf8() throws IOException {
    Path file = folder.resolve("a.txt");
    Files.writeString(file, "Tür");
    assertThat(InputFileReader.text(file)).isEqualTo("Tür");
    Files.write(file, new byte[] {(byte) 0xff});
    assertThatExceptionOfType(MalformedInputException.class)
        .isThrownBy(() -> InputFileReader.text(file));
    assertThatExceptionOfType(NoSuchFileException.class)
        .isThrownBy(() -> InputFileReader.text(folder.resolve("none")));
  }
}
