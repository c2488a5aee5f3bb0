package org.selectiverenderer.x3d.write;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.XmlDocument;

/** The encodings that scenes are written in, and the endings of their files' names. */
public enum SceneFormat {
  XML(XmlText::of, ".x3d", ".x3dz", ".xml"),
  CLASSIC(ClassicText::of, ".x3dv", ".x3dvz"),
  JSON(JsonSceneText::of, ".x3dj", ".x3djz", ".json");

  private static final String GZIP = ".gz";

  private final Function<List<SceneItem>, String> writer;
  private final List<String> endings;

  SceneFormat(Function<List<SceneItem>, String> writer, String... endings) {
    this.writer = writer;
    this.endings = List.of(endings);
  }

  /** The format that a file's name asks for; empty if it asks for none. */
  public static Optional<SceneFormat> of(String name) {
    String plain = plain(name);
    for (SceneFormat format : values()) {
      if (format.endings.stream().anyMatch(plain::endsWith)) {
        return Optional.of(format);
      }
    }
    return Optional.empty();
  }

  /** Whether a file's name asks for compression by gzip. */
  public static boolean packed(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.endsWith(GZIP) || lower.endsWith("z") && of(name).isPresent();
  }

  private static String plain(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.endsWith(GZIP) ? lower.substring(0, lower.length() - GZIP.length()) : lower;
  }

  /**
   * Writes a document anew, whatever it was written in: the same text each time.
   *
   * <p>Kept are nodes, values as they were written, names, prototypes, routes, scripts and
   * comments. What X3D does not know is told and left out, as a browser leaves it out.
   *
   * @param problems takes what is left out, and values that cannot be used
   */
  public String text(XmlDocument document, NodeCatalogue catalogue, Problems problems) {
    return writer.apply(SceneItems.of(document, catalogue, problems));
  }
}
