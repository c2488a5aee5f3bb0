package org.selectiverenderer.app.examples;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.app.recent.RecentPaths;
import org.selectiverenderer.base.files.ProgramLocation;

/**
 * Finds an example on the disk: in the current folder, in the program's, or where the user has had
 * the examples copied to.
 */
public final class ExampleFinder {
  private final RecentPaths copies;

  /**
   * @param settings folder of the user's settings, which name the copies
   */
  public ExampleFinder(Path settings) {
    copies = RecentPaths.exampleFolders(settings);
  }

  /**
   * Returns the first file that there is.
   *
   * @param names with slashes, the best first, such as {@code scenes/apartment-lit.x3d}
   */
  public Optional<Path> find(List<String> names) {
    return names.stream().flatMap(this::places).filter(Files::isRegularFile).findFirst();
  }

  private Stream<Path> places(String name) {
    return Stream.of(
            Stream.of(Path.of(name)),
            ProgramLocation.file(ExampleFinder.class, name).stream(),
            copies.list().stream().map(folder -> folder.resolve(name)))
        .flatMap(each -> each);
  }
}
