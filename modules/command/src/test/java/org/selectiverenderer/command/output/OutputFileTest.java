package org.selectiverenderer.command.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.testing.RequiresSymbolicLinks;

class OutputFileTest {
  private static final FileOperations FOREIGN_FOLDER =
      new FileOperations() {
        @Override
        public void write(Path file, byte[] content) throws IOException {
          throw new AccessDeniedException(file.toString());
        }
      };

  private static final FileOperations MOUNTED_FILE =
      new FileOperations() {
        @Override
        public void move(Path from, Path to) throws IOException {
          throw new FileSystemException(from.toString(), to.toString(), "Device or resource busy");
        }
      };

  @TempDir private Path folder;

  @Test
  void aFileWhoseNameNothingCanTakeIsWrittenInto() throws IOException {
    Path file = Files.writeString(folder.resolve("report.html"), "old and longer");
    for (FileOperations actions : new FileOperations[] {FOREIGN_FOLDER, MOUNTED_FILE}) {
      Files.writeString(file, "old and longer");
      OutputFile.write(file, "new", actions);
      assertThat(file).hasContent("new");
      assertThat(folder.toFile().list()).containsExactly("report.html");
    }
  }

  @Test
  @RequiresSymbolicLinks
  void aLinkToAFileWhoseNameNothingCanTakeStaysOne() throws IOException {
    Path file =
        Files.writeString(
            Files.createDirectory(folder.resolve("there")).resolve("report.html"), "old");
    Path link = Files.createSymbolicLink(folder.resolve("link.html"), file);

    OutputFile.write(link, "new", FOREIGN_FOLDER);

    assertThat(link).isSymbolicLink();
    assertThat(file).hasContent("new");
  }

  @Test
  void aFileThatIsNotThereIsNotMadeInAForeignFolder() {
    Path file = folder.resolve("report.html");
    assertThatThrownBy(() -> OutputFile.write(file, "new", FOREIGN_FOLDER))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith(file + ": permission denied");
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void aFullDiskLeavesTheOldContent() throws IOException {
    Path file = Files.writeString(folder.resolve("report.html"), "old");
    FileOperations full =
        new FileOperations() {
          @Override
          public void write(Path to, byte[] content) throws IOException {
            throw new IOException("No space left on device");
          }
        };
    assertThatThrownBy(() -> OutputFile.write(file, "new", full))
        .isInstanceOf(IOException.class)
        .hasMessage(file + ": No space left on device");
    assertThat(file).hasContent("old");
  }
}
