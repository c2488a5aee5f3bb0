package org.selectiverenderer.authoring.versions;

import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.stream.IntStream;
import org.selectiverenderer.base.files.FileNameLength;
import org.selectiverenderer.base.files.WindowsDeviceName;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Determines the files of an object's versions. */
final class VersionFileNames {
  /** Bytes for the number of an attempt, that of a version, and the ending. */
  private static final int ROOM = 32;

  private final ElementNodeMapping scene;
  private final ObjectElements site;
  private final Path outputFolder;
  private final String inlineFolder;
  private final String name;

  /**
   * @param inlineFolder for new objects, relative to the output's folder
   * @param name name of the new files; empty for the name of the existing ones, or of the object
   */
  VersionFileNames(
      ElementNodeMapping scene,
      ObjectElements site,
      Path outputFolder,
      String inlineFolder,
      String name) {
    this.scene = scene;
    this.site = site;
    this.outputFolder = outputFolder;
    this.inlineFolder = inlineFolder;
    this.name = name.strip();
  }

  /**
   * Returns the files of versions 1 to {@code count}. Existing versions keep the files of their
   * Inlines, further ones are beside the original.
   *
   * @param attempt number of the attempt, from 1; a new object gets another file name for each
   */
  List<Path> of(int count, int attempt) {
    if (site instanceof ObjectElements.Versioned versioned) {
      String url = url(versioned, 0);
      List<Path> files = files(outputFolder, base(url), ending(url), count);
      List<Path> all = new ArrayList<>(files);
      for (int i = 0; i < Math.min(count, versioned.inlines().size()); i++) {
        all.set(i, outputFolder.resolve(url(versioned, i)).normalize());
      }
      return all;
    }
    String base = safe(name.isEmpty() ? site.name() : name, ROOM) + (attempt == 1 ? "" : attempt);
    return files(outputFolder.resolve(inlineFolder), base, ".x3d", count);
  }

  /**
   * Returns the same files, where new ones have the name chosen by the author; those of later
   * attempts have a name of their own.
   *
   * @param kept numbers of the versions that are kept
   */
  List<Path> of(int count, int attempt, Set<Integer> kept) {
    List<Path> files = new ArrayList<>(of(count, attempt));
    if (site instanceof ObjectElements.Versioned versioned && (!name.isEmpty() || attempt > 1)) {
      String url = url(versioned, 0);
      String folder = url.substring(0, url.lastIndexOf('/') + 1);
      String base = name.isEmpty() ? base(url) : folder + safe(name, ROOM);
      List<Path> named =
          files(outputFolder, base + (attempt == 1 ? "" : attempt), ending(url), count);
      for (int number = 2; number <= count; number++) {
        if (!kept.contains(number)) {
          files.set(number - 1, named.get(number - 1));
        }
      }
    }
    return files;
  }

  private static String base(String url) {
    return url.substring(0, url.lastIndexOf("_v"));
  }

  private static String ending(String url) {
    Matcher parts = ObjectFinder.VERSION_URL.matcher(url);
    return parts.matches() ? parts.group(3) : ".x3d";
  }

  private static List<Path> files(Path start, String base, String ending, int count) {
    return IntStream.rangeClosed(1, count)
        .mapToObj(number -> start.resolve(base + "_v" + number + ending).normalize())
        .toList();
  }

  /** Returns the first URL of an Inline. */
  String url(ObjectElements.Versioned versioned, int index) {
    NodeView inline = scene.node(versioned.inlines().get(index));
    return inline == null ? "" : inline.strings("url")[0];
  }

  /** Returns whether another file has the planned name. */
  static boolean taken(PlannedFile planned) {
    return switch (planned.state()) {
      case NEW -> Files.exists(planned.file(), LinkOption.NOFOLLOW_LINKS);
      case CHANGED -> true;
      case UNCHANGED -> false;
    };
  }

  /**
   * Returns a name that is valid in every file system.
   *
   * @param ending the number of bytes that are added
   */
  private static String safe(String name, int ending) {
    StringBuilder safe = new StringBuilder();
    name.codePoints()
        .forEach(
            c ->
                safe.appendCodePoint(
                    Character.isLetterOrDigit(c) || c == '_' || c == '-' || c == '.' ? c : '_'));
    if (WindowsDeviceName.matches(safe.toString())) {
      safe.insert(0, '_');
    }
    return FileNameLength.shortened(safe.toString(), ending);
  }

  /** Returns the folder of a file. */
  static Path folder(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    Path parent = absolute.getParent();
    return parent == null ? absolute : parent;
  }
}
