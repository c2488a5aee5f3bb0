package org.selectiverenderer.authoring.versions;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.write.XmlAttributeEscaper;

/**
 * Finds other scenes that show a generated file, which must then stay as it is. The scenes are
 * those in the folders of the scene that is read, of the one that is written, and of the file.
 *
 * <p>A scene counts that has the file's relative URL anywhere in its text, as does one that cannot
 * be read: with another name of a file nothing is lost, with another content a study may be. Hidden
 * files do not count: the enricher runs a changed scene from a copy whose name begins with a point.
 */
public final class ReferencingScenes {
  private static final List<String> ENDINGS =
      List.of(".x3d", ".x3dz", ".x3dv", ".x3dvz", ".wrl", ".wrz", ".json", ".html", ".xhtml");

  /** URLs that are spelled in one way, but for their slashes. */
  private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_./-]+");

  /**
   * Bytes of scenes' texts that are kept until the search ends, as several files are looked for.
   */
  private static final long MOST_KEPT = 64L << 20;

  private final Path scene;
  private final Path output;
  private final Map<Path, String> texts = new HashMap<>();
  private long kept;

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
    return !name.startsWith(".")
        && ENDINGS.stream().anyMatch(name::endsWith)
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

  private boolean mentions(Path other, Path file) {
    try {
      if (Files.size(other) > ReadLimits.standard().maxBytes()) {
        return true; // nobody can read it
      }
      String text = text(other);
      return spellings(VersionFileNames.folder(other), file).stream()
          .map(url -> url.getBytes(StandardCharsets.UTF_8))
          .anyMatch(url -> text.contains(new String(url, StandardCharsets.ISO_8859_1)));
    } catch (IOException e) {
      return true; // nobody knows
    }
  }

  /** Returns the bytes of a scene as characters of one byte each. */
  private String text(Path other) throws IOException {
    String known = texts.get(other);
    if (known == null) {
      byte[] content = Files.readAllBytes(other);
      byte[] plain = Gzip.compressed(content) ? Gzip.unpacked(content) : content;
      known = new String(plain, StandardCharsets.ISO_8859_1);
      if (kept + known.length() <= MOST_KEPT) {
        kept += known.length();
        texts.put(other, known);
      }
    }
    return known;
  }

  /**
   * Returns the spellings of a file's relative URL in scenes. Of one with other characters than
   * plain ones only the file's name is looked for: raw, percent-encoded, or escaped as in XML.
   */
  private static Set<String> spellings(Path folder, Path file) {
    String url = UrlRelativizer.between(folder, file);
    if (PLAIN.matcher(url).matches()) {
      // Backslashes are read as slashes, and JSON may escape these.
      return new LinkedHashSet<>(List.of(url, url.replace("/", "\\"), url.replace("/", "\\/")));
    }
    Path own = VersionFileNames.folder(file);
    String encoded = file.toAbsolutePath().normalize().toUri().getRawPath();
    Set<String> names = new LinkedHashSet<>();
    names.add(String.valueOf(file.getFileName()));
    names.add(UrlRelativizer.between(own, file));
    names.add(encoded.replaceFirst("/$", "").replaceFirst(".*/", ""));
    for (String name : List.copyOf(names)) {
      names.add(XmlAttributeEscaper.escaped(name, '"'));
      names.add(XmlAttributeEscaper.escaped(name, '\''));
    }
    return names;
  }
}
