package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.UrlChoice;

/**
 * The images of texture nodes, for one load. A file that several nodes name is read once, and all
 * images together take no more than a quarter of the heap. Thread-safe.
 */
final class ImageFiles {
  private static final String CONSEQUENCE = "the texture is left out";

  private final ContentRoot root;
  private final Map<String, Decoded> files = new ConcurrentHashMap<>();
  private final AtomicLong budget = new AtomicLong(Runtime.getRuntime().maxMemory() / 4);

  /**
   * @param image empty when the file could not be read
   * @param fault why, else empty
   */
  private record Decoded(Optional<Texture.Image> image, String fault) {}

  ImageFiles(ContentRoot root) {
    this.root = root;
  }

  /**
   * The image of a texture node.
   *
   * @param base where its relative urls start
   * @param problems hears why there is none
   */
  Optional<Texture.Image> read(NodeView texture, ContentBase base, Problems problems) {
    return switch (texture.type().name()) {
      case "PixelTexture" -> pixels(texture, problems);
      case "ImageTexture" -> {
        UrlChoice choice = UrlChoice.of(texture, root, base, CONSEQUENCE);
        if (choice instanceof UrlChoice.Found found) {
          yield file(texture, found.content(), problems);
        }
        problems.add(((UrlChoice.None) choice).problem());
        yield Optional.empty();
      }
      default -> Optional.empty();
    };
  }

  /** The image in a PixelTexture. */
  static Optional<Texture.Image> pixels(NodeView texture, Problems problems) {
    try {
      return Optional.of(ImageDecoder.pixels(texture.ints("image")));
    } catch (IOException e) {
      problems.error(
          texture.location(),
          "the image of the PixelTexture %s; %s".formatted(e.getMessage(), CONSEQUENCE));
      return Optional.empty();
    }
  }

  private Optional<Texture.Image> file(NodeView texture, Content file, Problems problems) {
    Decoded decoded = files.computeIfAbsent(file.key(), key -> decode(file));
    if (!decoded.fault.isEmpty()) {
      problems.error(
          texture.location(), "%s %s; %s".formatted(file.name(), decoded.fault, CONSEQUENCE));
    }
    return decoded.image;
  }

  private Decoded decode(Content file) {
    try {
      return new Decoded(Optional.of(ImageDecoder.read(file, budget)), "");
    } catch (IOException e) {
      return new Decoded(Optional.empty(), Failure.clause(e));
    }
  }
}
