package org.selectiverenderer.base.files;

import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.Optional;
import java.util.stream.Stream;

/** Finds the program's installation folder and the files installed with it. */
public final class ProgramLocation {
  /** Number of parent folders searched for installed files; target/classes needs two. */
  private static final int LEVELS = 4;

  private ProgramLocation() {}

  /** Returns the jar or class folder from which a class was loaded; empty if it is not a file. */
  public static Optional<Path> of(Class<?> type) {
    CodeSource source = type.getProtectionDomain().getCodeSource();
    try {
      return source == null
          ? Optional.empty()
          : Optional.of(Path.of(source.getLocation().toURI()).toAbsolutePath());
    } catch (URISyntaxException | IllegalArgumentException e) {
      return Optional.empty(); // the class loader does not load from files
    }
  }

  /**
   * Finds a file that is installed with the program, beside the jar or relative to a folder above
   * it, independent of the working directory.
   *
   * @param name with slashes, such as {@code scenes/apartment.x3d}
   */
  public static Optional<Path> file(Class<?> type, String name) {
    return of(type).stream()
        .flatMap(place -> Stream.iterate(place.getParent(), up -> up != null, Path::getParent))
        .limit(LEVELS)
        .map(folder -> folder.resolve(name))
        .filter(Files::isRegularFile)
        .findFirst();
  }
}
