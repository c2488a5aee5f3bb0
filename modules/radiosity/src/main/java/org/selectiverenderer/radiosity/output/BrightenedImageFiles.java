package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.formats.image.PngEncoder;
import org.selectiverenderer.radiosity.bake.BrightenedImage;
import org.selectiverenderer.radiosity.bake.DiffuseTexture;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * The files of brightened texture copies beside the lit files that show them, one copy of each
 * image in a folder. Their names begin with that of the lit file, so that no image of the author's
 * is overwritten.
 */
final class BrightenedImageFiles {
  private static final String BRIGHT = "-bright";

  private final Map<Path, Map<Texture.Image, Path>> known = new HashMap<>();
  private final Map<Path, Texture.Image> images = new LinkedHashMap<>();

  /** Used file names in lower case, since some file systems ignore case. */
  private final Set<String> taken = new HashSet<>();

  /**
   * Appends the texture node of a body with a brightened copy of its image and the node's other
   * fields. The DEF name stays with the original texture, which another shape of the file may show:
   * routes to that name must not change this copy.
   */
  void append(LitFileWriter into, DiffuseTexture own) {
    Texture.Image image = own.texture().image();
    Node node = own.node().orElseThrow();
    Path file =
        known
            .computeIfAbsent(into.folder(), key -> new IdentityHashMap<>())
            .computeIfAbsent(image, key -> next(into, stem(node)));
    images.put(file, image);
    X3dWriter out = into.out();
    out.open(
        "ImageTexture",
        "url",
        FieldValueFormatter.strings(UrlRelativizer.between(into.folder(), file)));
    if (!own.texture().repeatS()) {
      out.attribute("repeatS", "false");
    }
    if (!own.texture().repeatT()) {
      out.attribute("repeatT", "false");
    }
    into.nodes().nodes(node, "", into);
    out.close();
  }

  private static String stem(Node node) {
    String[] url = node.type().field("url").isEmpty() ? new String[0] : node.strings("url");
    String name = url.length == 0 ? "" : url[0].replaceFirst("[?#].*$", "");
    String last = name.substring(Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')) + 1);
    String stem = last.replaceFirst("\\.[^.]*$", "").replaceAll("[^\\w.-]", "_");
    return (stem.isEmpty() ? "image" : stem) + BRIGHT;
  }

  private Path next(LitFileWriter into, String stem) {
    String whole = into.stem() + "-" + stem;
    Path path = into.folder().resolve(whole + ".png");
    for (int number = 2; !taken.add(path.toString().toLowerCase(Locale.ROOT)); number++) {
      path = into.folder().resolve(whole + "-" + number + ".png");
    }
    return path;
  }

  Map<Path, byte[]> pictures() {
    Map<Path, byte[]> made = new LinkedHashMap<>();
    images.forEach(
        (file, image) ->
            made.put(
                file,
                PngEncoder.small(image.width(), image.height(), BrightenedImage.pixels(image))));
    return made;
  }
}
