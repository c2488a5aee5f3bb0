package org.selectiverenderer.app.headset;

import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.app.head.HeadSampleListener;
import org.selectiverenderer.app.run.RunCancellation;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.run.SceneRunner;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.command.output.InterruptHandler;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.hmd.HeadsetViewSettings;
import org.selectiverenderer.openxr.FakeHeadset;
import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/**
 * A program that shows a scene in a headset without hardware until it is ended from outside. Says
 * when it shows frames, and how it ended.
 */
final class InterruptedHeadsetRun implements RunListener, HeadSampleListener {
  static final String SHOWN = "shows frames";
  static final String ENDED = "ended";

  private final int reported;
  private int frames;

  private InterruptedHeadsetRun(int reported) {
    this.reported = reported;
  }

  /**
   * @param args the scene, and the number of the frame to be reported
   */
  public static void main(String[] args) throws Exception {
    LibraryProperties.set();
    HeadsetViewSettings shown = HeadsetViewSettings.standing();
    RunSettings settings =
        new RunSettings(Path.of(args[0]), SelectiveController.Settings.SELECTIVE)
            .muted(true)
            .with(DisplaySettings.of(DisplayConfiguration.in(shown)))
            .with(
                new TrackerSettings(
                    new TrackerSpec.Headset(), TrackerOptions.NONE, WhenLost.FREEZE),
                Optional.empty());
    FakeHeadset headset = new FakeHeadset().paced();
    headset.wear();
    RunCancellation stop = new RunCancellation();
    InterruptedHeadsetRun run = new InterruptedHeadsetRun(Integer.parseInt(args[1]));
    InterruptHandler.stops(
        stop::stop,
        () -> {
          try {
            SceneRunner.inHeadset(
                settings, HeadsetConnection.with(headset.search(), shown), run, stop);
            System.out.println(ENDED);
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
        });
  }

  @Override
  public void scene(HeadLogMetadata description) {
    // Only the frames count.
  }

  @Override
  public void sampled(HeadSample sample, long nanos) {
    frames++;
    if (frames == reported) {
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
  public Optional<HeadSampleListener> samples() {
    return Optional.of(this);
  }

  @Override
  public void printed(String text) {
    System.out.println(text);
  }
}
