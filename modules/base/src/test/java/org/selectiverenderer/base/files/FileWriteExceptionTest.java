package org.selectiverenderer.base.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.AccessDeniedException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class FileWriteExceptionTest {
  /** Windows gives the same error for both. */
  @Test
  void onWindowsAnotherProgramMayHaveTheFileOpen() {
    Path file = Path.of("room.x3d");
    AccessDeniedException denied = new AccessDeniedException("room.x3d");
    assertThat(new FileWriteException(file, denied, "it is as it was", "Windows 11"))
        .hasMessage(
            "room.x3d cannot be written (permission denied, or another program has it open); it is"
                + " as it was");
    assertThat(new FileWriteException(file, denied, "it is as it was", "Linux").reason())
        .isEqualTo("permission denied");
  }

  @Test
  void whatTheFileSystemSaysIsExplained() {
    assertThat(
            FileWriteException.explained(
                Path.of("folder"), new java.nio.file.AccessDeniedException("folder/x.png")))
        .hasMessageStartingWith("folder/x.png: permission denied");
    assertThat(
            FileWriteException.explained(
                Path.of("folder"), new java.nio.file.FileSystemException(null, null, "disk full")))
        .hasMessage("folder: disk full");
  }
}
