package org.selectiverenderer.study.questionnaire;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.selectiverenderer.base.files.InputFileReader;

/**
 * Checks the pictures that a study shows by the first bytes of their files, before they are
 * decoded: a picture of a few kilobytes can announce more pixels than there is memory for.
 */
public final class PictureFile {
  /** 8192 x 8192, as many as a texture may have. */
  private static final long MAX_PIXELS = 1L << 26;

  private static final Set<String> FORMATS = Set.of("png", "jpeg");

  private PictureFile() {}

  /**
   * Returns what is wrong with a picture, as the end of a sentence that begins with its name; empty
   * if it can be shown.
   *
   * @throws IOException if the file cannot be read
   */
  public static Optional<String> fault(Path file) throws IOException {
    InputFileReader.requireRegular(file);
    try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
      if (!readers.hasNext()) {
        return Optional.of("is neither a PNG nor a JPEG, whatever its name");
      }
      ImageReader reader = readers.next();
      try {
        reader.setInput(in, true, true);
        return fault(reader);
      } catch (IOException | RuntimeException e) {
        // ImageIO's readers throw various runtime exceptions for damaged files.
        return Optional.of("is damaged");
      } finally {
        reader.dispose();
      }
    }
  }

  private static Optional<String> fault(ImageReader reader) throws IOException {
    if (!FORMATS.contains(reader.getFormatName().toLowerCase(Locale.ROOT))) {
      return Optional.of("is neither a PNG nor a JPEG, whatever its name");
    }
    long width = reader.getWidth(0);
    long height = reader.getHeight(0);
    return width * height <= MAX_PIXELS
        ? Optional.empty()
        : Optional.of(
            "has %d x %d pixels; a picture may have as many as 8192 x 8192, so make it smaller"
                .formatted(width, height));
  }

  /**
   * Requires a picture to be one that can be shown.
   *
   * @throws IOException with one line that names the file and what is wrong with it
   */
  public static void requireSound(Path file) throws IOException {
    Optional<String> fault = fault(file);
    if (fault.isPresent()) {
      throw new IOException(file + " " + fault.get());
    }
  }
}
