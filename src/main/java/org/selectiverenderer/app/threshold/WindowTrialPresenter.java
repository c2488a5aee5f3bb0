package org.selectiverenderer.app.threshold;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.selectiverenderer.app.window.MonitorBounds;
import org.selectiverenderer.app.window.ThanksWindow;
import org.selectiverenderer.app.window.TrialPage;
import org.selectiverenderer.app.window.TrialWindow;
import org.selectiverenderer.base.natives.FlatLafLibrary;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.PictureFile;
import org.selectiverenderer.study.threshold.ThresholdSession;
import org.selectiverenderer.study.threshold.ThresholdStudy;
import org.selectiverenderer.study.threshold.ThresholdTask;
import org.selectiverenderer.study.threshold.ThresholdTrial;

/** Presents the trials to a participant in a window. */
public final class WindowTrialPresenter implements TrialPresenter {
  private final ThresholdStudy study;
  private final ThresholdStimuli pictures;
  private final ParticipantMessages wording;
  private final String words;
  private final TrialWindow window;

  /**
   * Opens the window.
   *
   * @throws IOException if the pictures are too large for the screen
   */
  public WindowTrialPresenter(
      ThresholdStudy study, ThresholdStimuli pictures, ParticipantMessages wording)
      throws IOException {
    this.study = study;
    this.pictures = pictures;
    this.wording = wording;
    words = "threshold." + study.task().spelling();
    int most = TrialWindow.mostPixels(study.task() == ThresholdTask.TELL_APART ? 3 : 1);
    if (study.picture() > most) {
      throw new IOException(
          "%s: pictures of %d pixels do not fit on this screen; \"picture\" can be %d at most here"
              .formatted(study.file(), study.picture(), most));
    }
    FlatLafLibrary.use(WindowTrialPresenter.class);
    FlatLightLaf.setup();
    window = TrialWindow.open(wording, wording.of(words + ".title"));
  }

  @Override
  public boolean introduce() throws InterruptedException {
    return window.introduce(wording.of(words + ".title"), wording.of(words + ".text"));
  }

  @Override
  public Optional<Given> ask(ThresholdTrial trial, ThresholdSession session)
      throws IOException, InterruptedException {
    Optional<TrialWindow.Reply> reply = window.ask(page(trial, session));
    return reply.map(given -> new Given(response(trial, given.choice()), given.ms()));
  }

  private static String response(ThresholdTrial trial, int choice) {
    return choice == TrialPage.NONE ? ThresholdTrial.NONE : trial.choices().get(choice);
  }

  private TrialPage page(ThresholdTrial trial, ThresholdSession session) throws IOException {
    boolean naming = study.task() == ThresholdTask.RECOGNISE;
    return new TrialPage(
        wording.of(words + ".question"),
        wording.of(words + ".keys"),
        wording.filled(
            "threshold.left", trial.number(), session.pilot().left(), study.objects().size()),
        naming
            ? List.of(read(pictures.file(trial.object(), trial.rung(), trial.view())))
            : sideBySide(trial),
        naming ? "" : wording.of("threshold.original"),
        naming ? names(trial) : List.of(),
        naming ? wording.of("threshold.none") : "");
  }

  private List<BufferedImage> sideBySide(ThresholdTrial trial) throws IOException {
    BufferedImage original = read(pictures.original(trial.object(), trial.view()));
    BufferedImage other =
        read(
            trial.catches()
                ? pictures.original(trial.catching(), trial.view())
                : pictures.file(trial.object(), trial.rung(), trial.view()));
    return trial.right().equals(ThresholdTrial.LEFT)
        ? List.of(other, original, original)
        : List.of(original, original, other);
  }

  private List<String> names(ThresholdTrial trial) {
    List<String> names = new ArrayList<>();
    for (String object : trial.choices()) {
      for (ThresholdStudy.Judged judged : study.objects()) {
        if (judged.object().equals(object)) {
          names.add(judged.name());
        }
      }
    }
    return names;
  }

  private static BufferedImage read(Path file) throws IOException {
    PictureFile.requireSound(file);
    BufferedImage image = ImageIO.read(file.toFile());
    if (image == null) {
      throw new IOException(
          file + ": is not a picture; delete " + file.getParent() + ", and it is made again");
    }
    return image;
  }

  @Override
  public void thanks() {
    window.close();
    ThanksWindow.show(wording, MonitorBounds.USUAL);
  }

  @Override
  public void close() {
    window.close();
  }
}
