package org.selectiverenderer.app.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.settings.HeadLogSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.HeadTrackedMotion.WhenLost;
import org.selectiverenderer.study.headlog.HeadLogReader;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/** The place of the head that a tracker tells moves the viewer where that is asked for. */
class TrackerPositionTest {
  private static final RunListener QUIET =
      new RunListener() {
        @Override
        public void problem(Problem problem) {
          throw new AssertionError(problem);
        }

        @Override
        public void happened(TimelineEvent event) {
          // Nothing is enriched.
        }

        @Override
        public void printed(String text) {
          throw new AssertionError(text);
        }
      };

  /** A head that goes 40 cm to the right, 10 cm up and 20 cm back within half a second. */
  private static final String PLACED =
      "t,yaw,pitch,roll,right,up,back\n0,0,0,0,1,2,3\n0.5,0,0,0,1.4,2.1,3.2\n";

  @TempDir private Path folder;

  private HeadSample last(String recording, boolean placed)
      throws IOException, InterruptedException {
    Path scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            "<X3D version='4.0' profile='Immersive'><Scene><Viewpoint position='5 1.6 7'/>"
                + "<Shape><Box/></Shape></Scene></X3D>");
    Path tracker = Files.writeString(folder.resolve("tracker.csv"), recording);
    Path log = folder.resolve(placed + ".csv");
    RunSettings settings =
        new RunSettings(scene, SelectiveController.Settings.SELECTIVE)
            .with(
                new TrackerSettings(
                    new TrackerSpec.Replay(tracker), TrackerOptions.NONE, WhenLost.FREEZE, placed),
                Optional.of(new HeadLogSettings(log)));
    SceneRunner.simulated(settings, QUIET);
    List<HeadSample> rows = HeadLogReader.read(log, new ProblemCollector()).orElseThrow().samples();
    return rows.get(rows.size() - 1);
  }

  private static void assertAt(HeadSample row, double... place) {
    assertThat(new double[] {row.x(), row.y(), row.z()}).containsExactly(place);
  }

  @Test
  void isUsedFromWhereItWasWhenTheRunBeganOrLeftAlone() throws IOException, InterruptedException {
    assertAt(last(PLACED, true), 5.4, 1.7, 7.2);
    assertAt(last(PLACED, false), 5, 1.6, 7);
  }

  @Test
  void aRecordWithoutAPlaceLeavesTheHeadOverItsBody() throws IOException, InterruptedException {
    String lost = PLACED + "0.7,0,0,0,,,\n";
    assertAt(last(lost, true), 5, 1.6, 7);
  }

  @Test
  void aRecordingWithoutPlacesIsRefusedWhereTheyAreAskedFor()
      throws IOException, InterruptedException {
    String turned = "t,yaw,pitch,roll\n0,0,0,0\n0.5,0,0,0\n";
    assertAt(last(turned, false), 5, 1.6, 7);
    assertThatThrownBy(() -> last(turned, true))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("has no columns right, up and back");
  }
}
