package org.selectiverenderer.app.session;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.selectiverenderer.browser.camera.ArgbImage;
import org.selectiverenderer.study.questionnaire.PictureFile;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;

/** Reads the pictures of a questionnaire's pages and options for a panel. */
final class PanelImageLoader {
  /** The largest width and height in pixels; a panel in a headset cannot show more. */
  private static final int MOST = 1024;

  /** The largest width and height in pixels of an option, of which there are several in a row. */
  private static final int MOST_OF_OPTION = 384;

  private PanelImageLoader() {}

  /**
   * Reads the pictures of all pages and options, keyed by their files.
   *
   * @throws IOException with a one-line message if one is not a picture
   */
  static Map<Path, ArgbImage> of(Questionnaire questionnaire) throws IOException {
    Map<Path, ArgbImage> pictures = new HashMap<>();
    for (QuestionnairePage page : questionnaire.pages()) {
      Optional<Path> file = page.picture();
      if (file.isPresent() && !pictures.containsKey(file.get())) {
        pictures.put(file.get(), read(file.get(), MOST));
      }
    }
    for (Question question : questionnaire.questions()) {
      for (Path file : question.kind().pictures()) {
        if (!pictures.containsKey(file)) {
          pictures.put(file, read(file, MOST_OF_OPTION));
        }
      }
    }
    return pictures;
  }

  private static ArgbImage read(Path file, int most) throws IOException {
    PictureFile.requireSound(file);
    BufferedImage read = ImageIO.read(file.toFile());
    if (read == null) {
      throw new IOException(file + " cannot be read as a picture; use PNG or JPEG");
    }
    double scale = Math.min(1, most / (double) Math.max(read.getWidth(), read.getHeight()));
    int width = Math.max(1, (int) Math.round(scale * read.getWidth()));
    int height = Math.max(1, (int) Math.round(scale * read.getHeight()));
    BufferedImage small = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
    Graphics2D drawing = small.createGraphics();
    drawing.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
    drawing.drawImage(read, 0, 0, width, height, null);
    drawing.dispose();
    return new ArgbImage(width, height, small.getRGB(0, 0, width, height, null, 0, width));
  }
}
