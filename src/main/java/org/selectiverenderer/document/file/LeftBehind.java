package org.selectiverenderer.document.file;

import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.document.XmlValues;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * What a scene would lose when it is saved into another folder: relative urls count from the folder
 * of the file that they stand in (X3D 4.0, 9.2.1).
 */
public final class LeftBehind {
  /**
   * Elements with a field url that names a file; others are not looked into, as they may be big.
   */
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
          "Anchor");

  private LeftBehind() {}

  /**
   * The files, as the scene names them, that are found from one folder and not from another; each
   * once, in document order. None of a text that is not well formed.
   *
   * @param from the folder of the scene now
   * @param to the folder that it is to be saved in
   */
  public static List<String> in(SceneDocument document, Path from, Path to) {
    List<DocumentElement> elements = new ArrayList<>();
    document.tree().ifPresent(tree -> tree.root().visit(elements::add));
    return in(elements, from, to);
  }

  /** The same of the elements of a scene in whatever encoding. */
  public static List<String> in(List<DocumentElement> elements, Path from, Path to) {
    if (from.normalize().equals(to.normalize())) {
      return List.of();
    }
    return elements.stream()
        .filter(element -> WITH_URL.contains(element.name()))
        .map(element -> XmlValues.strings(element.text("url").orElse("")))
        .distinct()
        .filter(urls -> urls.stream().noneMatch(url -> found(to, url)))
        .flatMap(urls -> urls.stream().filter(url -> found(from, url)).limit(1))
        .distinct()
        .toList();
  }

  /** Whether a relative url names a file that is there; absolute ones do not depend on folders. */
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
