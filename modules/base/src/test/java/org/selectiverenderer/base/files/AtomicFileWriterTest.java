package org.selectiverenderer.base.files;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.testing.RequiresSymbolicLinks;

class AtomicFileWriterTest {
  @TempDir Path folder;

  @Test
  void aFileIsReplacedInOneStep() throws IOException {
    Path file = Files.writeString(folder.resolve("a.txt"), "old and longer");
    FileOperations inOneStep =
        new FileOperations() {
          @Override
          public void keep(Path kept, Path as) {
            throw new AssertionError("one file needs no way back");
          }
        };

    AtomicFileWriter.replace(file, "new".getBytes(UTF_8), inOneStep);

    assertThat(file).hasContent("new");
    assertThat(folder).isDirectoryContaining(found -> found.equals(file));
    assertThat(folder.toFile().list()).hasSize(1);
  }

  @Test
  @EnabledOnOs({OS.LINUX, OS.MAC})
  void itKeepsItsPermissions() throws IOException {
    Path file = Files.writeString(folder.resolve("a.txt"), "old");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r-----"));

    AtomicFileWriter.replace(file, "new".getBytes(UTF_8));

    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
        .isEqualTo("rw-r-----");
  }

  @Test
  void aFolderThatIsGoneIsNotMadeAnew() {
    Path file = folder.resolve("unplugged/a.txt");

    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(() -> AtomicFileWriter.replace(file, new byte[1]))
        .satisfies(failure -> assertThat(failure.reason()).isEqualTo("its folder does not exist"));
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  @RequiresSymbolicLinks
  void theFolderOfALinksTargetIsNotMadeAnew() throws IOException {
    Path link = Files.createSymbolicLink(folder.resolve("a.txt"), Path.of("unplugged/a.txt"));

    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(() -> AtomicFileWriter.replace(link, new byte[1]))
        .satisfies(failure -> assertThat(failure.reason()).isEqualTo("its folder does not exist"));
    assertThat(link).isSymbolicLink();
    assertThat(folder.toFile().list()).containsExactly("a.txt");
  }

  @Test
  @RequiresSymbolicLinks
  void aLinkToItselfIsNotWritten() throws IOException {
    Path link = Files.createSymbolicLink(folder.resolve("a.txt"), Path.of("a.txt"));

    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(() -> AtomicFileWriter.replace(link, new byte[1]))
        .satisfies(failure -> assertThat(failure.reason()).isEqualTo("it is a link to itself"));
  }

  @Test
  void whatIsWrittenOnceMakesNoFolder() {
    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(() -> AtomicFileWriter.writeOnce(folder.resolve("unplugged/study.json"), "{}"))
        .satisfies(failure -> assertThat(failure.reason()).isEqualTo("its folder does not exist"));
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void whatIsWrittenOnceStays() throws IOException {
    Path file = folder.resolve("study.json");

    AtomicFileWriter.writeOnce(file, "{}");
    AtomicFileWriter.writeOnce(file, "{}");

    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(() -> AtomicFileWriter.writeOnce(file, "[]"))
        .withMessageContaining("it exists already with other content");
    assertThat(file).hasContent("{}");
    assertThat(folder.toFile().list()).hasSize(1);
  }
}
