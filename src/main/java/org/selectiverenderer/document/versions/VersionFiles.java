package org.selectiverenderer.document.versions;

import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.stream.IntStream;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Which files the versions of an object go to. */
final class VersionFiles {
  private final SceneSource scene;
  private final ObjectElement site;
  private final Path outputFolder;
  private final String inlineFolder;

  /**
   * @param inlineFolder for new objects, relative to the output's folder
   */
  VersionFiles(SceneSource scene, ObjectElement site, Path outputFolder, String inlineFolder) {
    this.scene = scene;
    this.site = site;
    this.outputFolder = outputFolder;
    this.inlineFolder = inlineFolder;
  }

  /**
   * The files of versions 1 to {@code count}. Those of an object with versions are where its
   * Inlines say.
   *
   * @param attempt from 1; a new object has another name for each
   */
  List<Path> of(int count, int attempt) {
    if (site instanceof ObjectElement.Versioned versioned) {
      String url = url(versioned, 0);
      String base = url.substring(0, url.lastIndexOf("_v"));
      Matcher parts = SiteFinder.VERSION_URL.matcher(url);
      return files(outputFolder, base, parts.matches() ? parts.group(3) : ".x3d", count);
    }
    String base = safe(site.name()) + (attempt == 1 ? "" : attempt);
    return files(outputFolder.resolve(inlineFolder), base, ".x3d", count);
  }

  private static List<Path> files(Path start, String base, String ending, int count) {
    return IntStream.rangeClosed(1, count)
        .mapToObj(number -> start.resolve(base + "_v" + number + ending).normalize())
        .toList();
  }

  /** What an Inline names first. */
  String url(ObjectElement.Versioned versioned, int index) {
    NodeView inline = scene.node(versioned.inlines().get(index));
    return inline == null ? "" : inline.strings("url")[0];
  }

  /** Whether something other than the planned file has its name. */
  static boolean taken(PlannedFile planned) {
    return switch (planned.state()) {
      case NEW -> Files.exists(planned.file(), LinkOption.NOFOLLOW_LINKS);
      case CHANGED -> true;
      case UNCHANGED -> false;
    };
  }

  /** A name that every file system takes. */
  private static String safe(String name) {
    StringBuilder safe = new StringBuilder();
    name.codePoints()
        .forEach(
            c ->
                safe.appendCodePoint(
                    Character.isLetterOrDigit(c) || c == '_' || c == '-' || c == '.' ? c : '_'));
    return safe.toString();
  }

  /** The folder that a file is in. */
  static Path folder(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    Path parent = absolute.getParent();
    return parent == null ? absolute : parent;
  }
}
