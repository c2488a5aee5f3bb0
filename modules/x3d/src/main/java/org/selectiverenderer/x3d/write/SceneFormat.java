package org.selectiverenderer.x3d.write;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.SceneEncoding;
import org.selectiverenderer.x3d.source.XmlDocument;

/** The encodings in which scenes are written, with their file name extensions. */
public enum SceneFormat {
  /** The XML encoding (ISO/IEC 19776-1). */
  XML(SceneEncoding.XML, XmlSceneWriter::of, ".x3d", ".x3dz", ".xml"),
  /** The ClassicVRML encoding (ISO/IEC 19776-2). */
  CLASSIC(SceneEncoding.CLASSIC, ClassicVrmlSceneWriter::of, ".x3dv", ".x3dvz"),
  /** X3D's JSON encoding. */
  JSON(SceneEncoding.JSON, JsonSceneWriter::of, ".x3dj", ".x3djz", ".json");

  private static final String GZIP = ".gz";

  private final SceneEncoding encoding;
  private final Function<List<SceneItem>, String> writer;
  private final List<String> endings;

  SceneFormat(SceneEncoding encoding, Function<List<SceneItem>, String> writer, String... endings) {
    this.encoding = encoding;
    this.writer = writer;
    this.endings = List.of(endings);
  }

  /** Returns the name for users. */
  String title() {
    return encoding.title();
  }

  /** Returns the format for a file name; empty if the extension is unknown. */
  public static Optional<SceneFormat> of(String name) {
    String plain = plain(name);
    for (SceneFormat format : values()) {
      if (format.endings.stream().anyMatch(plain::endsWith)) {
        return Optional.of(format);
      }
    }
    return Optional.empty();
  }

  /** Returns whether the extension of a file name implies compression by gzip. */
  public static boolean packed(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.endsWith(GZIP) || lower.endsWith("z") && of(name).isPresent();
  }

  private static String plain(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.endsWith(GZIP) ? lower.substring(0, lower.length() - GZIP.length()) : lower;
  }

  /**
   * Converts a document of any encoding to this one; the result is reproducible.
   *
   * <p>Nodes, values as they were written, names, prototypes, routes, scripts and comments are
   * kept. Content unknown to X3D, and what this encoding cannot hold, is reported and left out or
   * changed. What is written can be read again without an error of syntax.
   *
   * @param problems receives what is left out, and values that are not usable
   */
  public String text(XmlDocument document, NodeCatalogue catalogue, ProblemCollector problems) {
    return writer.apply(SceneItemBuilder.of(document, catalogue, this, problems));
  }
}
