package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.CubeTexture;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.movie.Movie;
import org.selectiverenderer.browser.movie.MovieDecoderPool;
import org.selectiverenderer.browser.movie.MovieReader;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.IoErrorFormatter;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Loads the images of texture nodes, for one load. A file that several nodes name is read once. All
 * images together take no more than a quarter of the heap, and movie files no more than an eighth.
 * Thread-safe.
 */
final class ImageLoader {
  private static final String CONSEQUENCE = "the texture is left out";

  /** Bytes per pixel of a movie: five RGBA frames, and the buffers of the decoder. */
  private static final int FILM_BYTES = 36;

  private static final int PICTURE_BYTES = 4;

  private final UrlResolver root;
  private final Map<String, Decoded> files = new ConcurrentHashMap<>();

  /** The cube maps made from panoramas. */
  private final Map<String, Optional<Texture.Image>> cubes = new ConcurrentHashMap<>();

  private final AtomicLong budget = new AtomicLong(Runtime.getRuntime().maxMemory() / 4);
  private final AtomicLong movieBudget = new AtomicLong(Runtime.getRuntime().maxMemory() / 8);
  private final Map<String, Decoded> movies = new ConcurrentHashMap<>();
  private final MovieDecoderPool room;

  /**
   * @param image the image; empty if the file could not be read
   * @param fault the reason why not; empty if it could
   */
  private record Decoded(Optional<Texture.Image> image, String fault, String flaw) {
    Decoded(Optional<Texture.Image> image, String fault) {
      this(image, fault, "");
    }
  }

  /**
   * @param room the threads that decode movies
   */
  ImageLoader(UrlResolver root, MovieDecoderPool room) {
    this.root = root;
    this.room = room;
  }

  /**
   * Loads the image of a texture node.
   *
   * @param base the base of its relative urls
   * @param problems receives the reason if there is no image
   */
  Optional<Texture.Image> read(NodeView texture, BaseUrl base, ProblemCollector problems) {
    return switch (texture.type().name()) {
      case "PixelTexture", "PixelTexture3D" -> pixels(texture, problems);
      case "ImageTexture", "ImageCubeMapTexture", "ImageTexture3D", "MovieTexture" -> {
        ResolvedUrlContent choice = ResolvedUrlContent.of(texture, root, base, CONSEQUENCE);
        if (choice instanceof ResolvedUrlContent.Found found) {
          yield file(texture, found.content(), problems);
        }
        problems.add(((ResolvedUrlContent.None) choice).problem());
        yield Optional.empty();
      }
      default -> Optional.empty();
    };
  }

  /** Returns whether textures of a type name their image by a url. */
  static boolean named(NodeType texture) {
    return texture.is("X3DTextureNode") && texture.field("url").isPresent();
  }

  /** Returns whether the file that a node names is to be read, by its field {@code load}. */
  static boolean wanted(NodeView node) {
    return node.type().field("load").isEmpty() || node.bool("load");
  }

  /**
   * Returns the image in the field of a PixelTexture or PixelTexture3D; empty for other textures.
   */
  static Optional<Texture.Image> pixels(NodeView texture, ProblemCollector problems) {
    String type = texture.type().name();
    if (type.startsWith("PixelTexture")
        && Arrays.stream(texture.ints("image")).allMatch(i -> i == 0)) {
      return Optional.empty(); // The default value; many scripts fill it later.
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

  private Optional<Texture.Image> file(
      NodeView texture, UrlContent file, ProblemCollector problems) {
    boolean movie = texture.type().name().equals("MovieTexture");
    Decoded decoded =
        movie
            ? movies.computeIfAbsent(file.key(), key -> movie(file))
            : files.computeIfAbsent(file.key(), key -> decode(file));
    if (!decoded.fault.isEmpty()) {
      problems.error(
          texture.location(), "%s %s; %s".formatted(file.name(), decoded.fault, CONSEQUENCE));
    } else if (isNoCube(texture, decoded.image)) {
      Optional<Texture.Image> cube = decoded.image.filter(CubeFaces::panorama);
      if (cube.isPresent()) {
        // The budget has room: the faces have fewer pixels than the panorama.
        return cubes.computeIfAbsent(file.key(), key -> cube.map(CubeFaces::ofPanorama));
      }
      problems.error(
          texture.location(),
          ("%s holds no cube map: an ImageCubeMapTexture needs a DDS or KTX2 image with six faces,"
                  + " or a panorama twice as wide as high; %s")
              .formatted(file.name(), CONSEQUENCE));
    }
    if (!decoded.flaw.isEmpty()) {
      problems.warning(
          texture.location(),
          "%s %s; the movie is shown up to there".formatted(file.name(), decoded.flaw));
    }
    return movie ? shown(texture, decoded.image, file, problems) : decoded.image;
  }

  /**
   * Returns a movie if there is memory for its frames: each node that shows one has frame buffers
   * of its own.
   */
  private Optional<Texture.Image> shown(
      NodeView texture, Optional<Texture.Image> image, UrlContent file, ProblemCollector problems) {
    if (image.map(Texture.Image::film).isPresent()) {
      try {
        long pixels = (long) image.get().width() * image.get().height();
        ImageDecoder.spend(pixels, FILM_BYTES, budget);
      } catch (IOException e) {
        problems.error(
            texture.location(),
            "%s %s; %s".formatted(file.name(), IoErrorFormatter.clause(e), CONSEQUENCE));
        return Optional.empty();
      }
    }
    return image;
  }

  private static boolean isNoCube(NodeView texture, Optional<Texture.Image> image) {
    return texture.type().name().equals("ImageCubeMapTexture")
        && image.filter(found -> found.layers() == CubeTexture.FACES).isEmpty();
  }

  /** Decodes a movie, or a still image if the file holds one. */
  private Decoded movie(UrlContent file) {
    try {
      Optional<Movie> read = MovieReader.read(file, movieBudget);
      if (read.isEmpty()) {
        return still(file);
      }
      Movie movie = read.get();
      // The first frame stays in memory even if the budget does not suffice for the others.
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
      return new Decoded(Optional.empty(), IoErrorFormatter.clause(e));
    }
  }

  private Decoded still(UrlContent file) throws IOException {
    if (!ImageDecoder.knows(file)) {
      throw new IOException(
          "is not a movie in a supported format (MPEG-1 video, animated GIF); convert it with"
              + " `ffmpeg -i FILE -r 25 FILE.mpg`");
    }
    return decode(file);
  }

  private Decoded decode(UrlContent file) {
    try {
      return new Decoded(Optional.of(ImageDecoder.read(file, budget)), "");
    } catch (IOException e) {
      return new Decoded(Optional.empty(), IoErrorFormatter.clause(e));
    }
  }
}
