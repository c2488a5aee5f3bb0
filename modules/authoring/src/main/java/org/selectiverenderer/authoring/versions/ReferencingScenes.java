package org.selectiverenderer.authoring.versions;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.url.UrlRelativizer;

/**
 * Finds other scenes that show a generated file, which must then stay as it is. The scenes are
 * those in the folders of the scene that is read, of the one that is written, and of the file.
 *
 * <p>A scene counts that has the file's relative URL anywhere in its text, as does one that cannot
 * be read: with another name of a file nothing is lost, with another content a study may be.
 */
public final class ReferencingScenes {
  private static final List<String> ENDINGS =
      List.of(".x3d", ".x3dz", ".x3dv", ".x3dvz", ".wrl", ".wrz", ".json", ".html", ".xhtml");

  /** Larger scenes count as showing the file. */
  private static final long LIMIT = 1L << 28;

  private static final Pattern PLAIN = Pattern.compile("[\\p{L}\\p{N}_./-]+");

  private final Path scene;
  private final Path output;

  /**
   * Creates a search.
   *
   * @param scene the scene that is read
   * @param output the scene that is written, which may change what it shows
   */
  public ReferencingScenes(Path scene, Path output) {
    this.scene = scene.toAbsolutePath().normalize();
    this.output = output.toAbsolutePath().normalize();
  }

  /**
   * Returns a scene other than the output that shows a file.
   *
   * @throws IOException if a folder cannot be listed
   */
  public Optional<Path> of(Path file) throws IOException {
    Set<Path> folders = new LinkedHashSet<>();
    for (Path near : List.of(scene, output, file.toAbsolutePath().normalize())) {
      folders.add(VersionFileNames.folder(near));
    }
    for (Path folder : folders) {
      if (!Files.isDirectory(folder)) {
        continue;
      }
      try (Stream<Path> there = Files.list(folder)) {
        for (Path other : (Iterable<Path>) there.sorted()::iterator) {
          if (isOtherScene(other, file) && mentions(other, file)) {
            return Optional.of(other);
          }
        }
      }
    }
    return Optional.empty();
  }

  private boolean isOtherScene(Path other, Path file) {
    String name = String.valueOf(other.getFileName()).toLowerCase(Locale.ROOT);
    return ENDINGS.stream().anyMatch(name::endsWith)
        && Files.isRegularFile(other)
        && !same(other, output)
        && !same(other, file);
  }

  private static boolean same(Path one, Path other) {
    try {
      return Files.exists(other) && Files.isSameFile(one, other);
    } catch (IOException e) {
      return one.equals(other);
    }
  }

  private static boolean mentions(Path other, Path file) {
    try {
      if (Files.size(other) > LIMIT) {
        return true;
      }
      byte[] content = Files.readAllBytes(other);
      byte[] plain = Gzip.compressed(content) ? Gzip.unpacked(content) : content;
      String url = UrlRelativizer.between(VersionFileNames.folder(other), file);
      // Of a folder that scenes may spell in several ways only the file's name is looked for.
      String sought = PLAIN.matcher(url).matches() ? url : String.valueOf(file.getFileName());
      return new String(plain, StandardCharsets.ISO_8859_1)
          .contains(
              new String(sought.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1));
    } catch (IOException e) {
      return true; // nobody knows
    }
  }
}
