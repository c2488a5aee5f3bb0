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
 * object.
 */
final class FileCollisionCheck {
  private final VersionsEdit.Request request;
  private final ObjectElements site;
  private final List<Path> own;

  /**
   * @param own the files of the object's existing versions, the original first
   */
  FileCollisionCheck(VersionsEdit.Request request, ObjectElements site, List<Path> own) {
    this.request = request;
    this.site = site;
    this.own = List.copyOf(own);
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
  Optional<PlannedFile> in(List<PlannedFile> planned) throws IOException {
    for (PlannedFile file : planned) {
      Matcher name = ObjectFinder.VERSION_URL.matcher(file.file().toString());
      int number = name.matches() ? Integer.parseInt(name.group(2)) : 1;
      boolean scenes = same(file, request.output()) || same(file, request.scene());
      boolean known = number > 1 && (own(file, number) || reduced(site, file.file(), number));
      if (scenes || VersionFileNames.taken(file) && !known) {
        return Optional.of(file);
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
