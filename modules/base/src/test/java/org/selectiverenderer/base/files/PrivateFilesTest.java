package org.selectiverenderer.base.files;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@DisabledOnOs(value = OS.WINDOWS, disabledReason = "its files have no modes")
class PrivateFilesTest {
  @TempDir Path folder;

  private static String mode(Path path) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(path));
  }

  @Test
  void onlyTheOwnerReadsWhatIsCreated() throws IOException {
    Path made = folder.resolve("a/b");
    PrivateFiles.createFolders(made);
    Path log = made.resolve("log.csv");
    PrivateFiles.open(log, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE).close();
    FileTransaction writing = new FileTransaction(FileOperations.PRIVATE);
    writing.add(made.resolve("c/table.csv"), "1".getBytes(UTF_8));
    writing.commit();
    AtomicFileWriter.writeOnce(made.resolve("once.json"), "{}", FileOperations.PRIVATE_UNLINKED);

    assertThat(mode(folder.resolve("a"))).isEqualTo("rwx------");
    assertThat(mode(made)).isEqualTo("rwx------");
    assertThat(mode(log)).isEqualTo("rw-------");
    assertThat(mode(made.resolve("c"))).isEqualTo("rwx------");
    assertThat(mode(made.resolve("c/table.csv"))).isEqualTo("rw-------");
    assertThat(mode(made.resolve("once.json"))).isEqualTo("rw-------");
  }

  @Test
  void whatExistsKeepsItsPermissions() throws IOException {
    Path shared = Files.writeString(folder.resolve("table.csv"), "0");
    Files.setPosixFilePermissions(shared, PosixFilePermissions.fromString("rw-rw-r--"));
    AtomicFileWriter.replace(shared, "1".getBytes(UTF_8), FileOperations.PRIVATE);

    assertThat(mode(shared)).isEqualTo("rw-rw-r--");
  }

  @Test
  void linksTakeNothingElsewhere() throws IOException {
    Path elsewhere = Files.createDirectory(folder.resolve("elsewhere"));
    Path study = Files.createDirectory(folder.resolve("study"));
    Path link = Files.createSymbolicLink(study.resolve("sub-002"), elsewhere);
    Path file = Files.createSymbolicLink(study.resolve("a.json"), elsewhere.resolve("b.json"));

    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> PrivateFiles.createFoldersIn(study, Path.of("sub-002/ses-01")))
        .withMessageStartingWith(link + " is a link to " + elsewhere);
    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(
            () -> AtomicFileWriter.replace(file, new byte[1], FileOperations.PRIVATE_UNLINKED))
        .withMessageContaining("it is a link to");
    assertThat(elsewhere).isEmptyDirectory();
  }
}
