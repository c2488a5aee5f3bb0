package org.selectiverenderer.authoring.packaging;

import java.io.IOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The files and folders that a package has added to a folder, which can be removed again. */
public final class WrittenFiles {
  private final List<Path> added;

  /**
   * @param added what was created, a folder before what is in it
   */
  WrittenFiles(List<Path> added) {
    this.added = List.copyOf(added);
  }

  /**
   * Removes what was added; folders that others have put something into stay.
   *
   * @throws IOException if something cannot be removed
   */
  public void withdraw() throws IOException {
    for (int i = added.size() - 1; i >= 0; i--) {
      try {
        Files.deleteIfExists(added.get(i));
      } catch (DirectoryNotEmptyException e) {
        continue; // another program's files are in it
      }
    }
  }
}
