package org.selectiverenderer.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.browser.viewer.PathMotion;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

class GrowthSeriesTest {
  @TempDir Path dir;

  @ParameterizedTest
  @EnumSource(GrowthSeries.class)
  void sizesGrowAndTheSmallestIsTheSameEveryTime(GrowthSeries series) throws IOException {
    assertThat(series.sizes()).isSorted().doesNotHaveDuplicates();
    int least = series.sizes().get(0);

    BenchScene first = series.write(dir.resolve("a"), least);
    BenchScene second = series.write(dir.resolve("b"), least);

    assertThat(first.scene()).hasSameBinaryContentAs(second.scene());
    assertThat(first.bytes()).isEqualTo(second.bytes()).isPositive();
  }

  @ParameterizedTest
  @EnumSource(
      value = GrowthSeries.class,
      names = {"OBJECTS", "INLINES"})
  void objectsShareTheSameTrianglesHoweverManyThereAre(GrowthSeries series) throws IOException {
    assertThat(series.write(dir.resolve("some"), 100).triangles())
        .isEqualTo(GrowthSceneGenerator.TRIANGLES)
        .isEqualTo(series.write(dir.resolve("more"), 1_000).triangles());
  }

  @Test
  void trianglesAreAsManyAsAskedWithinAHundredth() throws IOException {
    assertThat(GrowthSeries.TRIANGLES.write(dir, 100_000).triangles()).isBetween(99_000L, 101_000L);
    try (var files = Files.list(dir.resolve("objects"))) {
      assertThat(files).hasSize(10);
    }
  }

  @ParameterizedTest
  @EnumSource(
      value = GrowthSeries.class,
      names = {"SENSORS", "SWITCHES", "INLINES"})
  void theWalkEntersAnAreaAndSwitches(GrowthSeries series) throws IOException {
    BenchScene scene = series.write(dir, 100);
    CameraPath path = CameraPathReader.read(scene.path(), new ProblemCollector()).orElseThrow();
    List<String> problems = new ArrayList<>();
    List<ControlEvent> events = new ArrayList<>();
    try (Walkthrough walk =
        Walkthrough.open(
            scene.scene(),
            SelectiveController.Settings.SELECTIVE,
            problem -> problems.add(problem.toString()),
            event -> events.add(((TimelineEvent.ControllerEvent) event).event()),
            text -> {})) {
      for (double time = 0; time <= path.end(); time += 1.0 / 30) {
        walk.step(time, new PathMotion(path, 0));
      }
    }

    assertThat(events).hasAtLeastOneElementOfType(ControlEvent.Enter.class);
    assertThat(events).hasAtLeastOneElementOfType(ControlEvent.SwitchChange.class);
    assertThat(problems).noneMatch(problem -> problem.contains("ProximitySensor"));
  }
}
