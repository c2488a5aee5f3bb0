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
import org.selectiverenderer.runtime.movie.Movie;
import org.selectiverenderer.runtime.movie.MovieReader;
import org.selectiverenderer.runtime.movie.ProjectionRoom;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.Failure;
import org.selectiverenderer.x3d.files.UrlChoice;

/**
 * The images of texture nodes, for one load. A file that several nodes name is read once. All
 * images together take no more than a quarter of the heap, and the files of films an eighth.
 * Thread-safe.
 */
final class ImageFiles {
  private static final String CONSEQUENCE = "the texture is left out";

  /** Bytes per pixel of a film: five pictures of four, and those that it is decoded in. */
  private static final int FILM_BYTES = 36;

  private static final int PICTURE_BYTES = 4;

  private final ContentRoot root;
  private final Map<String, Decoded> files = new ConcurrentHashMap<>();
  private final AtomicLong budget = new AtomicLong(Runtime.getRuntime().maxMemory() / 4);
  private final AtomicLong movieBudget = new AtomicLong(Runtime.getRuntime().maxMemory() / 8);
  private final Map<String, Decoded> movies = new ConcurrentHashMap<>();
  private final ProjectionRoom room;

  /**
   * @param image empty when the file could not be read
   * @param fault why, else empty
   */
  private record Decoded(Optional<Texture.Image> image, String fault, String flaw) {
    Decoded(Optional<Texture.Image> image, String fault) {
      this(image, fault, "");
    }
  }

  /**
   * @param room where films are decoded
   */
  ImageFiles(ContentRoot root, ProjectionRoom room) {
    this.root = root;
    this.room = room;
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

  /** Whether the file that a node names is to be read. */
  static boolean wanted(NodeView node) {
    return node.type().field("load").isEmpty() || node.bool("load");
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
    boolean movie = texture.type().name().equals("MovieTexture");
    Decoded decoded =
        movie
            ? movies.computeIfAbsent(file.key(), key -> movie(file))
            : files.computeIfAbsent(file.key(), key -> decode(file));
    if (!decoded.fault.isEmpty()) {
      problems.error(
          texture.location(), "%s %s; %s".formatted(file.name(), decoded.fault, CONSEQUENCE));
    } else if (isNoCube(texture, decoded.image)) {
      problems.error(
          texture.location(),
          "%s holds no cube: an ImageCubeMapTexture takes a DDS image with six faces; %s"
              .formatted(file.name(), CONSEQUENCE));
    }
    if (!decoded.flaw.isEmpty()) {
      problems.warning(
          texture.location(),
          "%s %s; it is shown up to there".formatted(file.name(), decoded.flaw));
    }
    return movie ? shown(texture, decoded.image, file, problems) : decoded.image;
  }

  /** A film, if there is memory for it: each node that shows one has pictures of its own. */
  private Optional<Texture.Image> shown(
      NodeView texture, Optional<Texture.Image> image, Content file, Problems problems) {
    if (image.map(Texture.Image::film).isPresent()) {
      try {
        long pixels = (long) image.get().width() * image.get().height();
        ImageDecoder.spend(pixels, FILM_BYTES, budget);
      } catch (IOException e) {
        problems.error(
            texture.location(), "%s %s; %s".formatted(file.name(), Failure.clause(e), CONSEQUENCE));
        return Optional.empty();
      }
    }
    return image;
  }

  private static boolean isNoCube(NodeView texture, Optional<Texture.Image> image) {
    return texture.type().name().equals("ImageCubeMapTexture")
        && image.filter(found -> found.layers() == CubeTexture.FACES).isEmpty();
  }

  /** A film, or a picture where the file is one that does not move. */
  private Decoded movie(Content file) {
    try {
      Optional<Movie> read = MovieReader.read(file, movieBudget);
      if (read.isEmpty()) {
        return still(file);
      }
      Movie movie = read.get();
      // The first picture stays in memory also where there is none for the others.
      ImageDecoder.spend((long) movie.width() * movie.height(), PICTURE_BYTES, budget);
      byte[] first = movie.open().picture(0);
      return new Decoded(
          Optional.of(
              new Texture.Image(
                  movie.width(),
                  movie.height(),
                  1,
                  movie.translucent() ? 4 : 3,
                  first,
                  room.film(movie, first))),
          "",
          movie.flaw());
    } catch (IOException e) {
      return new Decoded(Optional.empty(), Failure.clause(e));
    }
  }

  private Decoded still(Content file) throws IOException {
    if (!ImageDecoder.knows(file)) {
      throw new IOException(
          "is no film that can be shown (MPEG-1 video, animated GIF); `ffmpeg -i FILE -r 25"
              + " FILE.mpg` makes one of it");
    }
    return decode(file);
  }

  private Decoded decode(Content file) {
    try {
      return new Decoded(Optional.of(ImageDecoder.read(file, budget)), "");
    } catch (IOException e) {
      return new Decoded(Optional.empty(), Failure.clause(e));
    }
  }
}
