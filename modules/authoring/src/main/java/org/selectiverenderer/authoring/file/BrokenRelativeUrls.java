package org.selectiverenderer.authoring.file;

import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Finds the files that a scene cannot find any more when it is saved into another folder: relative
 * URLs are resolved against the folder of the file that contains them (X3D 4.0, 9.2.1).
 */
public final class BrokenRelativeUrls {
  /** The elements with a field {@code url}; other elements are skipped, as they may be large. */
  private static final Set<String> WITH_URL =
      Set.of(
          "Inline",
          "ImageTexture",
          "ImageTexture3D",
          "ImageCubeMapTexture",
          "MovieTexture",
          "AudioClip",
          "Script",
          "ShaderPart",
          "ShaderProgram",
          "PackagedShader",
          "ExternProtoDeclare",
          "Anchor",
          "Background");

  private BrokenRelativeUrls() {}

  /**
   * Returns the URLs of files that are found from one folder but not from another, each once, in
   * document order; none if the text is not well-formed.
   *
   * @param from the folder of the scene now
   * @param to the folder into which it will be saved
   */
  public static List<String> in(SceneDocument document, Path from, Path to) {
    List<DocumentElement> elements = new ArrayList<>();
    document.tree().ifPresent(tree -> tree.root().visit(elements::add));
    return in(elements, from, to);
  }

  /** Returns the same for the elements of a scene in any encoding. */
  public static List<String> in(List<DocumentElement> elements, Path from, Path to) {
    if (from.normalize().equals(to.normalize())) {
      return List.of();
    }
    return elements.stream()
        .filter(element -> WITH_URL.contains(element.name()))
        .flatMap(element -> element.attributes().stream())
        .filter(attribute -> attribute.name().toLowerCase(Locale.ROOT).endsWith("url"))
        .map(attribute -> MFStringParser.strings(attribute.text()))
        .distinct()
        .filter(urls -> urls.stream().noneMatch(url -> found(to, url)))
        .flatMap(urls -> urls.stream().filter(url -> found(from, url)).limit(1))
        .distinct()
        .toList();
  }

  /**
   * Returns whether a relative URL refers to an existing file; absolute URLs do not depend on
   * folders.
   */
  private static boolean found(Path folder, String url) {
    try {
      URI uri = new URI(url.strip().replace(" ", "%20"));
      String path = uri.getPath();
      return !uri.isAbsolute()
          && path != null
          && !path.isEmpty()
          && Files.isRegularFile(Path.of(folder.toUri().resolve(path(path))));
    } catch (URISyntaxException | IllegalArgumentException e) {
      return false; // No file has such a name, wherever the scene is.
    }
  }

  private static URI path(String path) throws URISyntaxException {
    return new URI(null, null, path, null);
  }
}
