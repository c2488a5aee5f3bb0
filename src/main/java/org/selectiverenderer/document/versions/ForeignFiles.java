package org.selectiverenderer.document.versions;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.write.XmlAttribute;

/** Finds files in the way: those that are not known to hold a version of this very object. */
final class ForeignFiles {
  private final VersionsEdit.Request request;
  private final ObjectElement site;
  private final boolean original;

  /**
   * @param elsewhere whether the changed scene goes to another folder
   */
  ForeignFiles(VersionsEdit.Request request, ObjectElement site, boolean elsewhere) {
    this.request = request;
    this.site = site;
    this.original = site instanceof ObjectElement.Whole || elsewhere;
  }

  /** The beginning of what a reduced version says of itself, by which it is known. */
  static String madeAs(ObjectElement site, int number) {
    return "%s, version %d: reduced to ".formatted(site.name(), number);
  }

  /**
   * The first file in the way.
   *
   * @param planned the versions that are to be written, in order
   */
  Optional<PlannedFile> in(List<PlannedFile> planned) throws IOException {
    int had = site instanceof ObjectElement.Versioned versioned ? versioned.inlines().size() : 0;
    for (int i = 0; i < planned.size(); i++) {
      PlannedFile file = planned.get(i);
      int number = original ? i + 1 : i + 2;
      boolean scenes = same(file, request.output()) || same(file, request.scene());
      boolean known = number > 1 && (number <= had || reduced(file, number));
      if (scenes || VersionFiles.taken(file) && !known) {
        return Optional.of(file);
      }
    }
    return Optional.empty();
  }

  private static boolean same(PlannedFile file, Path other) {
    return file.file().equals(other.toAbsolutePath().normalize());
  }

  private boolean reduced(PlannedFile file, int number) throws IOException {
    return Files.isRegularFile(file.file())
        && new String(Files.readAllBytes(file.file()), StandardCharsets.UTF_8)
            .contains("content='" + XmlAttribute.escaped(madeAs(site, number), '\''));
  }
}
