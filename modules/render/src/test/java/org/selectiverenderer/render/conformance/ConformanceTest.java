package org.selectiverenderer.render.conformance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.display.OffscreenView;
import org.selectiverenderer.testing.RequiresDisplay;

/** Every scene of the conformance suite meets the expectations in its head. */
class ConformanceTest {
  private static final Path FOLDER = Path.of("modules/render/src/test/resources/conformance");
  private static final int SIZE = 256;
  private static final int TOLERANCE = 8;

  @TestFactory
  Stream<DynamicTest> eventsValuesAndMessages() throws IOException {
    return scenes().map(scene -> dynamicTest(name(scene), scene.file().toUri(), () -> run(scene)));
  }

  @TestFactory
  @RequiresDisplay
  Stream<DynamicTest> pictures() throws IOException {
    return scenes()
        .filter(scene -> !scene.pixels().isEmpty())
        .map(scene -> dynamicTest(name(scene), scene.file().toUri(), () -> draw(scene)));
  }

  /** Folders named with an underscore hold files that scenes refer to, not scenes to be tested. */
  private static Stream<ConformanceScene> scenes() throws IOException {
    try (Stream<Path> files = Files.walk(FOLDER)) {
      List<Path> found =
          files
              .filter(file -> file.toString().matches(".*\\.(x3d|x3dv|wrl|x3dj)"))
              .filter(file -> !file.toString().matches(".*[/\\\\]_[^/\\\\]*[/\\\\].*"))
              .sorted()
              .toList();
      List<ConformanceScene> scenes = new ArrayList<>();
      for (Path file : found) {
        scenes.add(ConformanceScene.read(file));
      }
      return scenes.stream();
    }
  }

  private static String name(ConformanceScene scene) {
    return FOLDER.relativize(scene.file()).toString();
  }

  static void run(ConformanceScene scene) throws IOException {
    try (ConformanceSceneRunner run = new ConformanceSceneRunner(scene)) {
      compare(run, scene);
      for (String expected : scene.values()) {
        FieldEvent value = run.value(ConformanceScene.word(expected, 0));
        assertThat(value.isValue(expected)).as("%s, not %s", value, expected).isTrue();
      }
      List<Problem> told = run.told();
      assertThat(told).as("what is told").hasSameSizeAs(scene.says());
      for (int i = 0; i < told.size(); i++) {
        assertThat(told.get(i).toString()).contains(scene.says().get(i));
      }
    }
  }

  private static void compare(ConformanceSceneRunner run, ConformanceScene scene) {
    List<FieldEvent> events = run.events();
    boolean same = events.size() == scene.events().size();
    for (int i = 0; same && i < events.size(); i++) {
      same = events.get(i).is(scene.events().get(i));
    }
    assertThat(same).as("sent%n%s%nnot%n%s", lines(events), lines(scene.events())).isTrue();
  }

  private static String lines(List<?> list) {
    return String.join("\n", list.stream().map(String::valueOf).toList());
  }

  static void draw(ConformanceScene scene) throws IOException {
    try (ConformanceSceneRunner run = new ConformanceSceneRunner(scene);
        OffscreenView view = OffscreenView.open(SIZE, SIZE, 0, ViewLayout.MONO, ShadingMode.AUTO)) {
      view.draw(run.world());
      Screenshot shot = view.screenshot();
      if (Boolean.getBoolean("conformance.pictures")) {
        Path picture = Path.of("target", "conformance", name(scene) + ".png");
        Files.createDirectories(picture.toAbsolutePath().getParent());
        shot.writePng(picture);
      }
      for (String expected : scene.pixels()) {
        check(shot, expected);
      }
    }
  }

  private static void check(Screenshot shot, String expected) {
    double[] numbers = Stream.of(expected.split("\\s+")).mapToDouble(Double::parseDouble).toArray();
    double tolerance = numbers.length > 5 ? numbers[5] : TOLERANCE;
    int column = (int) Math.min(SIZE - 1, numbers[0] * SIZE);
    int row = (int) Math.min(SIZE - 1, numbers[1] * SIZE);
    int rgb = shot.rgb(column, SIZE - 1 - row); // A screenshot counts from the bottom.
    int[] seen = {rgb >> 16 & 0xff, rgb >> 8 & 0xff, rgb & 0xff};
    for (int i = 0; i < 3; i++) {
      assertThat((double) seen[i])
          .as("pixel %s, seen %s %s %s", expected, seen[0], seen[1], seen[2])
          .isBetween(numbers[2 + i] - tolerance, numbers[2 + i] + tolerance);
    }
  }
}
