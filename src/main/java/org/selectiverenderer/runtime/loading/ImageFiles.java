package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.instance.CubeTexture;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.Failure;
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
      case "PixelTexture", "PixelTexture3D" -> pixels(texture, problems);
      case "ImageTexture", "ImageCubeMapTexture", "ImageTexture3D", "MovieTexture" -> {
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

  /** Whether a texture's image comes from a file that it names. */
  static boolean named(NodeType texture) {
    return texture.is("X3DTextureNode") && texture.field("url").isPresent();
  }

  /** The image in a PixelTexture or PixelTexture3D; of other textures none. */
  static Optional<Texture.Image> pixels(NodeView texture, Problems problems) {
    String type = texture.type().name();
    if (type.startsWith("PixelTexture")
        && Arrays.stream(texture.ints("image")).allMatch(i -> i == 0)) {
      return Optional.empty(); // The default, which many a script fills later.
    }
    try {
      return switch (type) {
        case "PixelTexture" -> Optional.of(ImageDecoder.pixels(texture.ints("image")));
        case "PixelTexture3D" -> Optional.of(ImageDecoder.volume(texture.ints("image")));
        default -> Optional.empty();
      };
    } catch (IOException e) {
      problems.error(
          texture.location(),
          "the image of the %s %s; %s".formatted(type, e.getMessage(), CONSEQUENCE));
      return Optional.empty();
    }
  }

  private Optional<Texture.Image> file(NodeView texture, Content file, Problems problems) {
    Decoded decoded = files.computeIfAbsent(file.key(), key -> decode(file));
    if (!decoded.fault.isEmpty()) {
      problems.error(
          texture.location(), "%s %s; %s".formatted(file.name(), decoded.fault, CONSEQUENCE));
    } else if (texture.type().name().equals("MovieTexture")) {
      problems.info(
          texture.location(), file.name() + " is shown as a still picture: movies do not run");
    } else if (isNoCube(texture, decoded.image)) {
      problems.error(
          texture.location(),
          "%s holds no cube: an ImageCubeMapTexture takes a DDS image with six faces; %s"
              .formatted(file.name(), CONSEQUENCE));
    }
    return decoded.image;
  }

  private static boolean isNoCube(NodeView texture, Optional<Texture.Image> image) {
    return texture.type().name().equals("ImageCubeMapTexture")
        && image.filter(found -> found.layers() == CubeTexture.FACES).isEmpty();
  }

  private Decoded decode(Content file) {
    try {
      return new Decoded(Optional.of(ImageDecoder.read(file, budget)), "");
    } catch (IOException e) {
      return new Decoded(Optional.empty(), Failure.clause(e));
    }
  }
}
