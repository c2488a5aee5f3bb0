package org.selectiverenderer.x3d.files;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * The folder of the project that a scene belongs to: the nearest one above it, or its own, that
 * holds a marker. A user's home, and what is above it, is no project, whatever lies in it: one
 * scene must not open all that somebody has.
 */
final class ProjectFolder {
  /** A repository's folder (a file in a linked worktree), and an empty file for any other case. */
  static final List<String> MARKERS = List.of(".git", "x3d-project");

  private ProjectFolder() {}

  /**
   * @param folder of the scene, a real path
   * @param home of the user, a real path
   */
  static Optional<Path> of(Path folder, Path home) {
    for (Path at = folder; at != null && !wide(at, home); at = at.getParent()) {
      if (MARKERS.stream().map(at::resolve).anyMatch(Files::exists)) {
        return Optional.of(at);
      }
    }
    return Optional.empty();
  }

  /** Whether a folder holds the user's home, or all of a disk. */
  static boolean wide(Path folder, Path home) {
    return folder.getParent() == null || home.startsWith(folder);
  }
}
