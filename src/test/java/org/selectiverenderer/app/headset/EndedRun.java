package org.selectiverenderer.app.headset;

import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.app.head.SampleListener;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.run.RunStop;
import org.selectiverenderer.app.run.SceneRunner;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.cli.base.LibraryProperties;
import org.selectiverenderer.cli.output.Interruption;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.experiment.headlog.HeadLogDescription;
import org.selectiverenderer.experiment.headlog.HeadSample;
import org.selectiverenderer.hmd.HeadsetShown;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.hmd.TrackedMotion.WhenLost;
import org.selectiverenderer.openxr.FakeHeadset;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;

/**
 * A program that shows a scene in a headset without hardware until it is ended from outside. Says
 * when it shows frames, and how it ended.
 */
final class EndedRun implements RunListener, SampleListener {
  static final String SHOWN = "shows frames";
  static final String ENDED = "ended";

  private int frames;

  public static void main(String[] args) throws Exception {
    LibraryProperties.set();
    HeadsetShown shown = HeadsetShown.standing();
    RunSettings settings =
        new RunSettings(Path.of(args[0]), SelectiveController.Settings.SELECTIVE)
            .muted(true)
            .with(DisplaySettings.of(Presentation.in(shown)))
            .with(
                new TrackerSettings(
                    new TrackerSpec.Headset(), TrackerOptions.NONE, WhenLost.FREEZE),
                Optional.empty());
    FakeHeadset headset = new FakeHeadset().paced();
    headset.wear();
    RunStop stop = new RunStop();
    EndedRun run = new EndedRun();
    Interruption.stops(
        stop::stop,
        () -> {
          try {
            SceneRunner.inHeadset(settings, HeadsetLink.with(headset.search(), shown), run, stop);
            System.out.println(ENDED);
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
        });
  }

  @Override
  public void scene(HeadLogDescription description) {
    // Only the frames count.
  }

  @Override
  public void sampled(HeadSample sample, long nanos) {
    frames++;
    if (frames == 30) {
      System.out.println(SHOWN);
    }
  }

  @Override
  public void problem(Problem problem) {
    System.out.println(problem);
  }

  @Override
  public void happened(TimelineEvent event) {
    // Only the frames count.
  }

  @Override
  public Optional<SampleListener> samples() {
    return Optional.of(this);
  }

  @Override
  public void printed(String text) {
    System.out.println(text);
  }
}
