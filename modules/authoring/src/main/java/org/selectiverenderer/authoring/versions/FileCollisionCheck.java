package org.selectiverenderer.authoring.versions;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.write.XmlAttributeEscaper;

/**
 * Finds existing files that must not be overwritten: those not known to contain a version of this
 * object, and those that another scene shows.
 */
final class FileCollisionCheck {
  private final VersionsEdit.Request request;
  private final ObjectElements site;
  private final List<Path> own;
  private final ReferencingScenes others;

  /**
   * A file that must not be overwritten.
   *
   * @param shownBy another scene that shows the file; empty if it holds no version of this object
   */
  record Collision(PlannedFile file, Optional<Path> shownBy) {}

  /**
   * @param own the files of the object's existing versions in the output, the original first; none
   *     where the output has none yet
   */
  FileCollisionCheck(VersionsEdit.Request request, ObjectElements site, List<Path> own) {
    this.request = request;
    this.site = site;
    this.own = List.copyOf(own);
    this.others = new ReferencingScenes(request.scene(), request.output());
  }

  /** Returns the beginning of the description in a reduced version, by which it is recognised. */
  static String madeAs(ObjectElements site, int number) {
    return "%s, version %d: reduced to ".formatted(site.name(), number);
  }

  /**
   * Returns the first file that must not be overwritten.
   *
   * @param planned the versions to be written, in order
   */
  Optional<Collision> in(List<PlannedFile> planned) throws IOException {
    for (PlannedFile file : planned) {
      Matcher name = ObjectFinder.VERSION_URL.matcher(file.file().toString());
      int number = name.matches() ? Integer.parseInt(name.group(2)) : 1;
      boolean scenes = same(file, request.output()) || same(file, request.scene());
      boolean known = number > 1 && (own(file, number) || reduced(site, file.file(), number));
      boolean taken = VersionFileNames.taken(file);
      if (scenes || taken && !known) {
        return Optional.of(new Collision(file, Optional.empty()));
      }
      Optional<Path> other = taken ? others.of(file.file()) : Optional.empty();
      if (other.isPresent()) {
        return Optional.of(new Collision(file, other));
      }
    }
    return Optional.empty();
  }

  private static boolean same(PlannedFile file, Path other) {
    return file.file().equals(other.toAbsolutePath().normalize());
  }

  private boolean own(PlannedFile file, int number) {
    return number <= own.size() && own.get(number - 1).equals(file.file());
  }

  /** Returns whether a file describes itself as that reduced version. */
  static boolean reduced(ObjectElements site, Path file, int number) throws IOException {
    return Files.isRegularFile(file)
        && new String(unpacked(Files.readAllBytes(file)), StandardCharsets.UTF_8)
            .contains("content='" + XmlAttributeEscaper.escaped(madeAs(site, number), '\''));
  }

  private static byte[] unpacked(byte[] content) throws IOException {
    return Gzip.compressed(content) ? Gzip.unpacked(content) : content;
  }
}
