package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.UrlChoice;

/**
 * The images of texture nodes, for one load. A file that several nodes name is read once, and all
 * images together take no more than a quarter of the heap. Thread-safe.
 */
final class ImageFiles {
  private static final String CONSEQUENCE = "the texture is left out";

  private final ContentRoot root;
  private final Map<Path, Decoded> files = new ConcurrentHashMap<>();
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
   * @param folder against which its urls are resolved
   * @param problems hears why there is none
   */
  Optional<Texture.Image> read(NodeView texture, Path folder, Problems problems) {
    return switch (texture.type().name()) {
      case "PixelTexture" -> pixels(texture, problems);
      case "ImageTexture" -> {
        UrlChoice choice = UrlChoice.of(texture, root, folder, CONSEQUENCE);
        if (choice instanceof UrlChoice.File file) {
          yield file(texture, file.path(), problems);
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

  private Optional<Texture.Image> file(NodeView texture, Path file, Problems problems) {
    Decoded decoded = files.computeIfAbsent(file, this::decode);
    if (!decoded.fault.isEmpty()) {
      problems.error(
          texture.location(),
          "%s %s; %s".formatted(root.display(file), decoded.fault, CONSEQUENCE));
    }
    return decoded.image;
  }

  private Decoded decode(Path file) {
    try {
      return new Decoded(Optional.of(ImageDecoder.read(file, budget)), "");
    } catch (IOException e) {
      return new Decoded(Optional.empty(), Failure.clause(e));
    }
  }
}
