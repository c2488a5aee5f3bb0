package org.selectiverenderer.polygon;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.formats.image.PictureSize;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Reads how large the pictures of textures are: the beginnings of files that the scene may read,
 * none from the web. Thread-safe.
 */
public final class TexturePictureReader {
  private final UrlResolver urls;
  private final Map<String, Optional<PictureSize>> known = new ConcurrentHashMap<>();

  /** Makes a reader of the pictures of one scene. */
  public TexturePictureReader(UrlResolver urls) {
    this.urls = urls;
  }

  /**
   * Returns the picture of a texture.
   *
   * @param texture an ImageTexture or PixelTexture
   * @param wanted the urls of an ImageTexture, which may be others than the node has
   * @param file the base of the file of the node
   * @return empty if no picture is there, or none of a known kind
   */
  public Optional<TexturePicture> picture(ParsedNode texture, List<String> wanted, BaseUrl file) {
    if (texture.type().name().equals("PixelTexture")) {
      return pixels(texture);
    }
    for (String url : wanted) {
      Optional<UrlContent> content = content(url, texture.base(file));
      if (content.isPresent()) {
        String key = content.get().key();
        return known
            .computeIfAbsent(key, unread -> size(content.get()))
            .map(size -> new TexturePicture(key, size.textureBytes()));
      }
    }
    return Optional.empty();
  }

  private static Optional<TexturePicture> pixels(ParsedNode texture) {
    @Nullable Object value =
        texture.type().field("image").map(field -> texture.value(field.index())).orElse(null);
    return value instanceof int[] image
            && image.length > 2
            && image[0] > 0
            && image[1] > 0
            && (long) image[0] * image[1] <= image.length - 3 // a damaged one is not drawn
        ? Optional.of(
            new TexturePicture(texture, new PictureSize(image[0], image[1]).textureBytes()))
        : Optional.empty();
  }

  private Optional<UrlContent> content(String url, BaseUrl base) {
    try {
      Optional<UrlContent> inside = UrlContent.inside(url, base);
      if (inside.isPresent()) {
        return inside;
      }
    } catch (IOException e) {
      return Optional.empty(); // a damaged data url, which the validator reports
    }
    if (UrlResolver.onNetwork(url, base)) {
      return Optional.empty();
    }
    return urls.resolve(url, base) instanceof UrlResolver.Target.Found found
        ? Optional.of(found.content()).filter(content -> content.file().isPresent())
        : Optional.empty();
  }

  private static Optional<PictureSize> size(UrlContent content) {
    try (InputStream in = new BufferedInputStream(content.open())) {
      return PictureSize.read(in);
    } catch (IOException e) {
      return Optional.empty(); // the validator and the browser report it
    }
  }
}
