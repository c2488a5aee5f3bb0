package org.selectiverenderer.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
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

  /** The street has the apartment's files from the repository: making them takes half a minute. */
  @BeforeEach
  void copyTheApartment() throws IOException {
    for (String folder : new String[] {"a", "b"}) {
      Path scenes = Files.createDirectories(dir.resolve(folder).resolve("scenes"));
      Files.copy(Path.of("scenes", "apartment.x3d"), scenes.resolve("apartment.x3d"));
      Path models = Files.createDirectory(dir.resolve(folder).resolve("inlineNodes"));
      try (var files = Files.list(Path.of("inlineNodes"))) {
        for (Path file : files.filter(file -> file.toString().endsWith(".x3d")).toList()) {
          Files.createLink(models.resolve(file.getFileName()), file);
        }
      }
    }
  }

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

  @Test
  void aStreetReadsTheSameFilesHoweverManyApartmentsStandInIt() throws IOException {
    BenchScene one = GrowthSeries.STREET.write(dir.resolve("a"), 1);
    BenchScene many = GrowthSeries.STREET.write(dir.resolve("a"), 64);

    assertThat(one.switches()).isEqualTo(50);
    assertThat(many.switches()).isEqualTo(64 * 50);
    assertThat(many.triangles()).isEqualTo(64 * 784_271L);
    assertThat(many.bytes() - one.bytes()).isBetween(1_000L, 20_000L);
    assertThat(GrowthSeries.STREET.usualSizes()).doesNotContain(1_024).contains(256);
  }

  @Test
  void noTwoHousesHaveAFileInCommonAndAllHaveTheSameTriangles() throws IOException {
    BenchScene one = HousesSceneGenerator.write(dir.resolve("one"), 1, 0.01);
    BenchScene three = HousesSceneGenerator.write(dir.resolve("three"), 3, 0.01);

    assertThat(three.triangles()).isEqualTo(3 * one.triangles());
    Set<String> contents = new HashSet<>();
    try (var files = Files.walk(dir.resolve("three"))) {
      for (Path file : files.filter(file -> file.toString().contains("objects0")).toList()) {
        if (Files.isRegularFile(file)) {
          assertThat(contents.add(Files.readString(file))).as(file.toString()).isTrue();
        }
      }
    }
    assertThat(contents).hasSize(210);
    try (Walkthrough walk = open(three, new ArrayList<>())) {
      assertThat(walk.polygons()).isBetween(three.triangles(), three.triangles() + 500);
    }
  }

  @Test
  void selectiveRenderingLeavesASixthOfTheVersionsInEveryRoom() throws IOException {
    BenchScene scene = VersionsSceneGenerator.write(dir, 0.1);
    CameraPath path = CameraPathReader.read(scene.path(), new ProblemCollector()).orElseThrow();
    List<ControlEvent> events = new ArrayList<>();
    try (Walkthrough walk = open(scene, events)) {
      assertThat(walk.problems().any()).isFalse();
      for (double time = 0; time <= path.end(); time += 0.25) {
        walk.step(time, new PathMotion(path, 0));
        assertThat(walk.enteredAreas()).hasSize(1);
        assertThat((double) walk.polygons() / scene.triangles()).isBetween(0.155, 0.18);
      }
    }
    assertThat(events.stream().filter(ControlEvent.Enter.class::isInstance))
        .hasSizeGreaterThanOrEqualTo(3);
  }

  private static Walkthrough open(BenchScene scene, List<ControlEvent> events) throws IOException {
    return Walkthrough.open(
        scene.scene(),
        SelectiveController.Settings.SELECTIVE,
        problem -> {},
        event -> events.add(((TimelineEvent.ControllerEvent) event).event()),
        text -> {});
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
