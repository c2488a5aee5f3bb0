package org.selectiverenderer.authoring.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.files.FileOperations;

class DocumentFileTest {
  private static final String SCENE = "<X3D><Scene/></X3D>\n";

  @TempDir Path folder;
  private Path path = Path.of("");

  @BeforeEach
  void writeTheScene() throws IOException {
    path = Files.writeString(folder.resolve("a.x3d"), SCENE);
  }

  private long files() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.count();
    }
  }

  @Test
  void savingKeepsTheFileAsItWasBeside() throws IOException {
    DocumentFile file = DocumentFile.open(path);
    file.document().type(0, 0, "<!-- 1 -->");
    assertThat(file.document().modified()).isTrue();
    file.save();
    assertThat(file.document().modified()).isFalse();
    assertThat(path).hasContent("<!-- 1 -->" + SCENE);
    assertThat(file.backup()).hasContent(SCENE);
    assertThat(file.guard().state()).isEqualTo(FileState.SAME);
    assertThat(files()).isEqualTo(2);
    file.document().history().undo();
    assertThat(file.document().modified()).isTrue();
    file.document().history().redo();
    assertThat(file.document().modified()).isFalse();
  }

  @Test
  void whatAnotherProgramWroteIsNotOverwritten() throws IOException {
    DocumentFile file = DocumentFile.open(path);
    file.document().type(0, 0, " ");
    Files.writeString(path, "<X3D/>");
    assertThat(file.guard().state()).isEqualTo(FileState.CHANGED);
    assertThatThrownBy(file::save)
        .isInstanceOf(FileChangedException.class)
        .hasMessage(
            path
                + ": another program has changed the file since it was opened; it is not"
                + " overwritten");
    assertThat(path).hasContent("<X3D/>");
    SaveOperation over = file.writing().over();
    over.write();
    file.written(over);
    assertThat(path).hasContent(" " + SCENE);
    assertThat(file.backup()).hasContent("<X3D/>");
  }

  @Test
  void aTouchedFileIsTheSame() throws IOException {
    DocumentFile file = DocumentFile.open(path);
    Files.writeString(path, SCENE);
    Files.setLastModifiedTime(path, FileTime.fromMillis(1));
    assertThat(file.guard().state()).isEqualTo(FileState.SAME);
  }

  @Test
  void aFileThatIsGoneIsWrittenAgain() throws IOException {
    DocumentFile file = DocumentFile.open(path);
    Files.delete(path);
    assertThat(file.guard().state()).isEqualTo(FileState.GONE);
    file.save();
    assertThat(path).hasContent(SCENE);
  }

  @Test
  void aFullDiskChangesNothing() throws IOException {
    FileOperations full = new FullDisk();
    DocumentFile file = DocumentFile.open(path, full);
    file.document().type(0, 0, " ");
    assertThatThrownBy(file::save)
        .isInstanceOf(IOException.class)
        .hasMessage(
            path
                + ": cannot be saved (no backup can be kept as a.x3d.bak: No space left on device);"
                + " file and document are as they were. Save it under another name");
    assertThat(path).hasContent(SCENE);
    assertThat(files()).isEqualTo(1);
    assertThat(file.document().modified()).isTrue();
    assertThat(file.document().text().toString()).isEqualTo(" " + SCENE);
  }

  /** Takes half of what is written. */
  private static final class FullDisk implements FileOperations {
    @Override
    public void write(Path file, byte[] content) throws IOException {
      Files.write(file, Arrays.copyOf(content, content.length / 2));
      throw new FileSystemException(file.toString(), null, "No space left on device");
    }
  }

  @Test
  void aMissingFileIsToldInOneLine() {
    assertThatThrownBy(() -> DocumentFile.open(folder.resolve("b.x3d")))
        .hasMessage(folder.resolve("b.x3d") + ": the file does not exist");
  }

  @Test
  void unsavedWorkIsFoundAgainAndCanBeUndone() throws IOException {
    CrashRecovery recovery = new CrashRecovery(folder.resolve("settings/recovery"));
    DocumentFile file = DocumentFile.open(path);
    int at = SCENE.indexOf("</X3D>");
    file.document().type(at, at, "<!-- \u00fcber -->");
    recovery.keep(path, file.document().snapshot());
    assertThat(recovery.found()).as("this session still has it").isEmpty();
    CrashRecovery later = new CrashRecovery(folder.resolve("settings/recovery"));
    assertThat(later.found()).hasSize(1);
    DocumentFile again = later.open(later.found().get(0));
    assertThat(again.path()).isEqualTo(path.toAbsolutePath());
    assertThat(again.document().text().toString()).contains("<!-- \u00fcber -->");
    assertThat(again.document().history().undoName()).contains("Recover unsaved changes");
    again.document().history().undo();
    assertThat(again.document().text().toString()).isEqualTo(SCENE);
    Files.delete(path);
    CrashRecovery latest = new CrashRecovery(folder.resolve("settings/recovery"));
    DocumentFile alone = latest.open(latest.found().get(0));
    assertThat(alone.document().modified()).isTrue();
    latest.forget(path);
    assertThat(new CrashRecovery(folder.resolve("settings/recovery")).found()).isEmpty();
  }

  @Test
  void whatAnEarlierSessionLeftIsNotOverwritten() throws IOException {
    Path kept = folder.resolve("recovery");
    DocumentFile file = DocumentFile.open(path);
    file.document().type(0, 0, "<!-- first -->");
    new CrashRecovery(kept).keep(path, file.document().snapshot());
    CrashRecovery second = new CrashRecovery(kept);
    second.keep(path, DocumentFile.open(path).document().snapshot());
    second.forget(path);
    List<CrashRecovery.RecoveryCopy> found = new CrashRecovery(kept).found();
    assertThat(found).hasSize(1);
    assertThat(found.get(0).content()).hasContent("<!-- first -->" + SCENE);
    second.forget(found.get(0));
    assertThat(new CrashRecovery(kept).found()).isEmpty();
  }

  @Test
  void whatIsTypedWhileTheFileIsWrittenIsUnsaved() throws IOException {
    DocumentFile file = DocumentFile.open(path);
    file.document().type(0, 0, "<!-- 1 -->");
    SaveOperation writing = file.writing();
    file.document().type(0, 0, "<!-- 2 -->");
    writing.write();
    file.written(writing);
    assertThat(path).hasContent("<!-- 1 -->" + SCENE);
    assertThat(file.document().modified()).isTrue();
    file.save();
    assertThat(path).hasContent("<!-- 2 --><!-- 1 -->" + SCENE);
  }

  @Test
  void aDeviceIsWrittenIntoAndNotReplaced() throws IOException {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.isWritable(full));
    DocumentFile file = DocumentFile.open(path);
    assertThatThrownBy(() -> file.saveAs(full)).hasMessageContaining("No space left on device");
    assertThat(Files.isRegularFile(full)).isFalse();
    assertThat(file.path()).isEqualTo(path);
  }
}
