package org.selectiverenderer.enricher.diff;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.file.DocumentFile;

/** What the dialog shows as the changes that are to be saved. */
class DiffDialogTest {
  @TempDir Path folder;

  private DocumentFile scene() throws IOException {
    Path file = folder.resolve("scene.x3d");
    Files.writeString(file, "<X3D>\n<Scene>\n</Scene>\n</X3D>\n");
    return DocumentFile.open(file);
  }

  @Test
  void whatAnotherProgramAddedIsNoDeletionOfTheAuthors() throws IOException {
    DocumentFile file = scene();
    Files.writeString(file.path(), "<X3D>\n<Scene>\n<Group/>\n</Scene>\n</X3D>\n");
    file.document().type(14, 14, "<Transform/>\n");
    DiffDialog.Changes changes =
        DiffDialog.Changes.of(file.path(), file.common(), file.document().snapshot());
    assertThat(changes.outside()).isTrue();
    assertThat(changes.lines().removed()).isZero();
    assertThat(changes.lines().added()).isEqualTo(1);
  }

  @Test
  void theChangesOfTheAuthorAreThoseToTheFile() throws IOException {
    DocumentFile file = scene();
    file.document().type(14, 14, "<Transform/>\n");
    DiffDialog.Changes changes =
        DiffDialog.Changes.of(file.path(), file.common(), file.document().snapshot());
    assertThat(changes.outside()).isFalse();
    assertThat(changes.lines().added()).isEqualTo(1);
  }

  @Test
  void aMissingFileCountsAsEmpty() throws IOException {
    DocumentFile file = scene();
    Files.delete(file.path());
    DiffDialog.Changes changes =
        DiffDialog.Changes.of(file.path(), file.common(), file.document().snapshot());
    assertThat(changes.outside()).isFalse();
    assertThat(changes.lines().added()).isEqualTo(4);
  }
}
