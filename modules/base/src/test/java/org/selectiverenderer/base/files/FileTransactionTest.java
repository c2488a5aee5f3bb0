package org.selectiverenderer.base.files;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.testing.RequiresSymbolicLinks;

class FileTransactionTest {
  @TempDir Path folder;

  /** A disk that is full from a certain step on, half-way through a file. */
  private static final class FullDisk implements FileOperations {
    private int left;
    private int done;

    FullDisk(int steps) {
      left = steps;
    }

    private void step() throws IOException {
      done++;
      if (left-- <= 0) {
        left = Integer.MAX_VALUE; // What undoes the rest works again.
        throw new IOException("No space left on device");
      }
    }

    @Override
    public void createFolder(Path path) throws IOException {
      step();
      FileOperations.super.createFolder(path);
    }

    @Override
    public void write(Path file, byte[] content) throws IOException {
      try {
        step();
      } catch (IOException e) {
        FileOperations.super.write(file, new byte[content.length / 2]);
        throw e;
      }
      FileOperations.super.write(file, content);
    }

    @Override
    public void keep(Path file, Path as) throws IOException {
      step();
      FileOperations.super.keep(file, as);
    }

    @Override
    public void move(Path from, Path to) throws IOException {
      step();
      FileOperations.super.move(from, to);
    }
  }

  private FileTransaction three(FileOperations actions) {
    FileTransaction writing = new FileTransaction(actions);
    writing.add(folder.resolve("new/folder/a.x3d"), "A".getBytes(UTF_8));
    writing.add(folder.resolve("b.x3d"), "B".getBytes(UTF_8));
    writing.add(folder.resolve("c.x3d"), "C".getBytes(UTF_8));
    return writing;
  }

  /** All files and folders with their contents. */
  private Map<Path, String> everything() throws IOException {
    Map<Path, String> contents = new TreeMap<>();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.toList()) {
        contents.put(file, Files.isDirectory(file) ? "" : Files.readString(file));
      }
    }
    return contents;
  }

  @Test
  void allFilesAreWrittenAndNothingElseIsLeft() throws IOException {
    Files.writeString(folder.resolve("b.x3d"), "old");

    three(FileOperations.REAL).commit();

    assertThat(everything().values()).containsExactlyInAnyOrder("", "", "", "A", "B", "C");
  }

  @Test
  void whereverTheDiskIsFullNothingHasChanged() throws IOException {
    Files.writeString(folder.resolve("b.x3d"), "old b");
    Files.writeString(folder.resolve("c.x3d"), "old c");
    Map<Path, String> before = everything();
    int steps = 0;
    while (true) {
      FullDisk disk = new FullDisk(steps);
      Throwable failure = catchThrowable(() -> three(disk).commit());
      if (failure == null) {
        break;
      }
      assertThat(failure)
          .isInstanceOf(IOException.class)
          .hasMessageContaining(".x3d")
          .hasMessageContaining("No space left on device")
          .hasMessageContaining("nothing has been changed");
      assertThat(everything()).as("after %d steps", steps).isEqualTo(before);
      steps++;
    }
    assertThat(steps).as("two folders, three writes, two second names, three moves").isEqualTo(10);
  }

  @Test
  void whatCannotBeUndoneIsSaid() throws IOException {
    Files.writeString(folder.resolve("b.x3d"), "old b");
    FileOperations broken =
        new FileOperations() {
          @Override
          public void write(Path file, byte[] content) throws IOException {
            if (file.toString().contains("b.x3d")) {
              throw new IOException("broken");
            }
            FileOperations.REAL.write(file, content);
          }

          @Override
          public void move(Path from, Path to) throws IOException {
            throw new IOException("broken");
          }

          @Override
          public void delete(Path file) throws IOException {
            throw new IOException("broken");
          }
        };

    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> three(broken).commit())
        .withMessageContaining("some of the changes could not be undone");
    assertThat(folder.resolve("b.x3d")).hasContent("old b");
  }

  @ParameterizedTest
  @ValueSource(strings = {"taken", "taken/under/file.x3d"})
  void aFolderOrAFileInTheWayIsNamed(String name) throws IOException {
    if (name.equals("taken")) {
      Files.createDirectory(folder.resolve("taken"));
    } else {
      Files.writeString(folder.resolve("taken"), "a file");
    }
    Map<Path, String> before = everything();
    FileTransaction writing = new FileTransaction(FileOperations.REAL);
    writing.add(folder.resolve("first.x3d"), new byte[1]);
    writing.add(folder.resolve(name), new byte[1]);

    assertThatExceptionOfType(IOException.class)
        .isThrownBy(writing::commit)
        .withMessageContaining(name.replace('/', java.io.File.separatorChar))
        .withMessageContaining("nothing has been changed");
    assertThat(everything()).isEqualTo(before);
  }

  @Test
  @RequiresSymbolicLinks
  void aLinkStaysALink() throws IOException {
    Path real = Files.writeString(folder.resolve("real.x3d"), "old");
    Path link = folder.resolve("link.x3d");
    Files.createSymbolicLink(link, real);
    FileTransaction writing = new FileTransaction(FileOperations.REAL);
    writing.add(link, "new".getBytes(UTF_8));

    writing.commit();

    assertThat(link).isSymbolicLink();
    assertThat(real).hasContent("new");
  }

  @Test
  @RequiresSymbolicLinks
  void aLinkToAFileThatIsNotThereYetStaysALink() throws IOException {
    Path link = folder.resolve("link.x3d");
    Files.createSymbolicLink(link, Path.of("later", "real.x3d"));
    FileTransaction writing = new FileTransaction(FileOperations.REAL);
    writing.add(link, "new".getBytes(UTF_8));

    writing.commit();

    assertThat(link).isSymbolicLink();
    assertThat(folder.resolve("later/real.x3d")).hasContent("new");
  }

  @Test
  @EnabledOnOs({OS.LINUX, OS.MAC})
  void whatIsNoFileOfADiskIsWrittenToAndNotReplaced() throws Exception {
    Path pipe = folder.resolve("pipe");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    CompletableFuture<byte[]> reader =
        CompletableFuture.supplyAsync(
            () -> {
              try {
                return Files.readAllBytes(pipe);
              } catch (IOException e) {
                throw new UncheckedIOException(e);
              }
            });
    FileTransaction writing = new FileTransaction(FileOperations.REAL);
    writing.add(pipe, "through".getBytes(UTF_8));
    writing.add(folder.resolve("b.x3d"), "B".getBytes(UTF_8));

    writing.commit();

    // A pipe that is replaced by a file leaves its reader waiting.
    assertThat(Files.readAttributes(pipe, BasicFileAttributes.class).isOther()).isTrue();
    assertThat(reader.get(20, TimeUnit.SECONDS)).isEqualTo("through".getBytes(UTF_8));
    assertThat(folder.resolve("b.x3d")).hasContent("B");
  }

  /** The new files are in place then, so it would be wrong to say that nothing has changed. */
  @Test
  void anOldFileThatCannotBeDeletedIsToldAndNoFailure() throws IOException {
    Files.writeString(folder.resolve("b.x3d"), "old b");
    FileOperations keeping =
        new FileOperations() {
          @Override
          public void delete(Path file) throws IOException {
            throw new IOException("broken");
          }
        };

    List<Path> left = three(keeping).commit();

    assertThat(folder.resolve("b.x3d")).hasContent("B");
    assertThat(folder.resolve("c.x3d")).hasContent("C");
    assertThat(left).singleElement().satisfies(old -> assertThat(old).hasContent("old b"));
  }

  /** A crash in the middle must not leave a name without a file. */
  @Test
  void aFileHasItsNameAtEveryMoment() throws IOException {
    Path b = Files.writeString(folder.resolve("b.x3d"), "old b");
    Path c = Files.writeString(folder.resolve("c.x3d"), "old c");
    FileOperations watching =
        new FileOperations() {
          @Override
          public void move(Path from, Path to) throws IOException {
            assertThat(b).exists();
            assertThat(c).exists();
            FileOperations.super.move(from, to);
          }
        };

    three(watching).commit();

    assertThat(b).hasContent("B");
  }

  @Test
  void whereADiskHasNoLinksTheOldFileComesBackAllTheSame() throws IOException {
    Files.writeString(folder.resolve("b.x3d"), "old b");
    Map<Path, String> before = everything();
    FileOperations withoutLinks =
        new FileOperations() {
          @Override
          public void keep(Path file, Path as) throws IOException {
            move(file, as);
          }

          @Override
          public void move(Path from, Path to) throws IOException {
            if (to.endsWith("c.x3d")) {
              throw new IOException("broken");
            }
            FileOperations.super.move(from, to);
          }
        };

    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(() -> three(withoutLinks).commit())
        .withMessageContaining("nothing has been changed");
    assertThat(everything()).isEqualTo(before);
  }

  @Test
  void whatIsWrittenOnceIsNeverReplaced() throws IOException {
    Path b = Files.writeString(folder.resolve("b.x3d"), "answers");
    FileTransaction writing = new FileTransaction();
    writing.addNew(folder.resolve("a.x3d"), "A".getBytes(UTF_8));
    writing.addNew(b, "B".getBytes(UTF_8));

    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(writing::commit)
        .withMessage(
            b
                + " cannot be written (it exists already with other content); nothing has "
                + "been changed");
    assertThat(everything().values()).containsExactlyInAnyOrder("", "answers");
  }

  @Test
  void onlyWhatMustLastFailsWhereTheDiskDoesNotKeepNames() throws IOException {
    FileOperations networkFolder =
        new FileOperations() {
          @Override
          public void forceFolder(Path forced) throws IOException {
            throw new IOException("Invalid argument");
          }
        };
    FileTransaction tolerant = new FileTransaction(networkFolder);
    tolerant.add(folder.resolve("a.x3d"), "A".getBytes(UTF_8));
    tolerant.addNew(folder.resolve("b.x3d"), "B".getBytes(UTF_8));
    tolerant.commit();
    FileTransaction lasting = new FileTransaction(networkFolder);
    lasting.addLasting(folder.resolve("c.x3d"), "C".getBytes(UTF_8));

    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(lasting::commit)
        .withMessageContaining("Invalid argument");
    assertThat(everything().values()).containsExactlyInAnyOrder("", "A", "B");
  }

  @Test
  void whatACrashCutOffIsWrittenToItsEndLater() throws IOException {
    Files.writeString(folder.resolve("a.x3d"), "A");
    FileTransaction writing = new FileTransaction();
    writing.addNew(folder.resolve("a.x3d"), "A".getBytes(UTF_8));
    writing.addNew(folder.resolve("b.x3d"), "B".getBytes(UTF_8));

    writing.commit();

    assertThat(everything().values()).containsExactlyInAnyOrder("", "A", "B");
  }

  /** With what is added to it while it is written, such a name is longer than 255 bytes. */
  @Test
  void aNameAsLongAsFileSystemsTakeIsWritten() throws IOException {
    Path long1 = folder.resolve("a".repeat(251) + ".x3d");
    Path long2 = folder.resolve("b".repeat(251) + ".x3d");
    for (String content : List.of("A", "B")) {
      FileTransaction writing = new FileTransaction();
      writing.add(long1, content.getBytes(UTF_8));
      writing.add(long2, content.getBytes(UTF_8));
      assertTimeoutPreemptively(Duration.ofSeconds(20), writing::commit);
    }

    assertThat(everything()).hasSize(3).containsEntry(long1, "B");
  }

  @Test
  void aNameTooLongForFileSystemsIsOneLine() throws IOException {
    FileTransaction writing = new FileTransaction();
    writing.add(folder.resolve("new/" + "a".repeat(1000) + ".x3d"), "A".getBytes(UTF_8));

    assertThatExceptionOfType(FileWriteException.class)
        .isThrownBy(() -> assertTimeoutPreemptively(Duration.ofSeconds(20), writing::commit))
        .withMessageContaining("nothing has been changed");
    assertThat(everything().values()).containsExactly("");
  }
}
