package org.selectiverenderer.base.files;

import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.Optional;
import java.util.stream.Stream;

/** Where the program itself lies. */
public final class ProgramPlace {
  /** Folders above the program's in which its files are looked for: target/classes has two. */
  private static final int LEVELS = 4;

  private ProgramPlace() {}

  /** The jar or the folder of classes that a class comes from; empty where it is no file. */
  public static Optional<Path> of(Class<?> type) {
    CodeSource source = type.getProtectionDomain().getCodeSource();
    try {
      return source == null
          ? Optional.empty()
          : Optional.of(Path.of(source.getLocation().toURI()).toAbsolutePath());
    } catch (URISyntaxException | IllegalArgumentException e) {
      return Optional.empty(); // Of a class loader that has no files.
    }
  }

  /**
   * A file that comes with the program, wherever the user is: beside the jar, or in a folder above
   * it.
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
