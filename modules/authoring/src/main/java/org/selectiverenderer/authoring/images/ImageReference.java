package org.selectiverenderer.authoring.images;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A place where a scene names an image.
 *
 * @param field the name of the field: {@code url}, or {@code frontUrl} of a Background
 * @param urls its urls, of which browsers take the first that they can read; at least one
 */
public record ImageReference(DocumentElement element, String field, List<String> urls) {
  private static final Set<String> TEXTURES =
      Set.of("ImageTexture", "ImageCubeMapTexture", "ImageTexture3D");

  private static final List<String> SIDES =
      List.of("frontUrl", "backUrl", "leftUrl", "rightUrl", "topUrl", "bottomUrl");

  /** Copies the list. */
  public ImageReference {
    urls = List.copyOf(urls);
  }

  /** Returns the references of a document, in document order; none while it is not well-formed. */
  public static List<ImageReference> in(SceneDocument document) {
    List<ImageReference> found = new ArrayList<>();
    document.tree().ifPresent(tree -> tree.root().visit(element -> found.addAll(of(element))));
    return List.copyOf(found);
  }

  /** Returns the references of one element. */
  public static List<ImageReference> of(DocumentElement element) {
    List<String> fields =
        TEXTURES.contains(element.name())
            ? List.of("url")
            : element.name().equals("Background") ? SIDES : List.of();
    return fields.stream().flatMap(field -> of(element, field).stream()).toList();
  }

  private static Optional<ImageReference> of(DocumentElement element, String field) {
    return element
        .text(field)
        .map(MFStringParser::strings)
        .filter(urls -> !urls.isEmpty())
        .map(urls -> new ImageReference(element, field, urls));
  }

  /**
   * Returns the file name of a url, without percent encoding (RFC 3986, 2.1); empty for data and
   * for a url that names no file.
   */
  public static Optional<String> fileName(String url) {
    String path = url.strip().replace('\\', '/');
    int end = path.indexOf('#');
    path = end < 0 ? path : path.substring(0, end);
    String name = path.substring(path.lastIndexOf('/') + 1);
    return path.startsWith("data:") || name.isEmpty()
        ? Optional.empty()
        : Optional.of(decoded(name));
  }

  private static String decoded(String name) {
    try {
      return URLDecoder.decode(name.replace("+", "%2B"), StandardCharsets.UTF_8);
    } catch (IllegalArgumentException e) {
      return name; // its percent sign is one
    }
  }
}
