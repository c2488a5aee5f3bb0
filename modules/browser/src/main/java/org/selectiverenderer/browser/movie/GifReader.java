package org.selectiverenderer.browser.movie;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.imageio.IIOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/** Reads the frame positions and durations of an animated GIF. */
final class GifReader {
  private static final String FORM = "javax_imageio_gif_image_1.0";
  private static final String STREAM_FORM = "javax_imageio_gif_stream_1.0";

  /** Largest number of frames; the rest is left out. */
  private static final int MOST = 20_000;

  /**
   * Largest delay, in hundredths of a second, that web browsers replace by a tenth of a second, as
   * authors do not mean it.
   */
  private static final int UNMEANT = 1;

  private static final int TENTH = 10;

  private GifReader() {}

  static boolean is(byte[] file) {
    return file.length > 6 && file[0] == 'G' && file[1] == 'I' && file[2] == 'F' && file[3] == '8';
  }

  static ImageReader reader() {
    return ImageIO.getImageReadersByFormatName("gif").next();
  }

  /**
   * Reads a GIF without decoding its frames.
   *
   * @return the movie; empty for a GIF of one frame
   * @throws IOException with a clause as message that follows the file's name
   */
  static Optional<Movie> read(byte[] file) throws IOException {
    ImageReader reader = reader();
    try (MemoryCacheImageInputStream in =
        new MemoryCacheImageInputStream(new ByteArrayInputStream(file))) {
      reader.setInput(in, false, false);
      int count = Math.min(MOST, reader.getNumImages(true));
      if (count < 2) {
        return Optional.empty();
      }
      Node screen =
          child(reader.getStreamMetadata().getAsTree(STREAM_FORM), "LogicalScreenDescriptor");
      int width = number(screen, "logicalScreenWidth");
      int height = number(screen, "logicalScreenHeight");
      MovieReader.check(width, height);
      List<GifMovie.Part> parts = new ArrayList<>(count);
      boolean translucent = false;
      for (int i = 0; i < count; i++) {
        Node root = tree(reader.getImageMetadata(i));
        Node place = child(root, "ImageDescriptor");
        Node control = child(root, "GraphicControlExtension");
        GifMovie.Part part =
            new GifMovie.Part(
                Math.min(width, number(place, "imageLeftPosition")),
                Math.min(height, number(place, "imageTopPosition")),
                seconds(number(control, "delayTime")),
                disposal(word(control, "disposalMethod")));
        int across = number(place, "imageWidth");
        int down = number(place, "imageHeight");
        // A frame may be larger than the logical screen.
        MovieReader.check(Math.max(1, across), Math.max(1, down));
        boolean whole = across >= width && down >= height;
        boolean clear = word(control, "transparentColorFlag").equalsIgnoreCase("true");
        translucent |= part.disposal() == GifMovie.Disposal.CLEARED || i == 0 && (clear || !whole);
        parts.add(part);
      }
      return Optional.of(new GifMovie(file, width, height, translucent, parts));
    } catch (IIOException
        | EOFException
        | RuntimeException e) { // ImageIO throws various exceptions for damaged files.
      throw new IOException("is a damaged GIF", e);
    } finally {
      reader.dispose();
    }
  }

  private static double seconds(int hundredths) {
    return (hundredths <= UNMEANT ? TENTH : hundredths) / 100.0;
  }

  private static GifMovie.Disposal disposal(String method) {
    return switch (method) {
      case "restoreToBackgroundColor" -> GifMovie.Disposal.CLEARED;
      case "restoreToPrevious" -> GifMovie.Disposal.AS_BEFORE;
      default -> GifMovie.Disposal.STAYS;
    };
  }

  private static Node tree(IIOMetadata metadata) {
    return metadata.getAsTree(FORM);
  }

  private static Node child(Node root, String name) {
    for (Node child = root.getFirstChild(); child != null; child = child.getNextSibling()) {
      if (child.getNodeName().equals(name)) {
        return child;
      }
    }
    return root; // A node without the attributes sought.
  }

  private static String word(Node node, String attribute) {
    return node instanceof Element element ? element.getAttribute(attribute) : "";
  }

  private static int number(Node node, String attribute) {
    String word = word(node, attribute);
    return word.isEmpty() ? 0 : Integer.parseInt(word);
  }
}
