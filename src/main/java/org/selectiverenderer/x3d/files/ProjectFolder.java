package org.selectiverenderer.x3d.files;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Finds the project folder of a scene: its own folder or the nearest one above it that contains a
 * marker. A user's home folder and those above it are never projects, since one scene must not have
 * access to all of a user's files.
 */
final class ProjectFolder {
  /** Names that mark a project: that of a git repository, and an empty file for other projects. */
  static final List<String> MARKERS = List.of(".git", "x3d-project");

  private ProjectFolder() {}

  /**
   * Returns the project folder, if any.
   *
   * @param folder the real path of the scene's folder
   * @param home the real path of the user's home folder
   */
  static Optional<Path> of(Path folder, Path home) {
    for (Path at = folder; at != null && !wide(at, home); at = at.getParent()) {
      if (MARKERS.stream().map(at::resolve).anyMatch(Files::exists)) {
        return Optional.of(at);
      }
    }
    return Optional.empty();
  }

  /** Returns whether a folder contains the user's home folder, or is the root of a disk. */
  static boolean wide(Path folder, Path home) {
    return folder.getParent() == null || home.startsWith(folder);
  }
}
