package org.selectiverenderer.polygon;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.app.run.RunListener;
import org.selectiverenderer.app.run.SceneRunner;
import org.selectiverenderer.app.settings.MotionSettings;
import org.selectiverenderer.app.settings.PathPlaybackSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Compares the counts of files with those of the same scenes in a running browser. */
class CountsMatchRunningBrowserTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();

  @TempDir Path folder;

  static Stream<Path> scenes() throws IOException {
    try (Stream<Path> files = Files.list(Path.of("scenes"))) {
      return files.filter(file -> file.toString().endsWith(".x3d")).sorted().toList().stream();
    }
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void scenesAsLoadedHaveThePolygonsOfTheInstanceTree(Path scene) throws IOException {
    assertThat(counted(scene)).isPositive().isEqualTo(running(scene));
  }

  @Test
  void whatIsHiddenOrInOtherGroupsCountsAsInTheInstanceTree() throws IOException {
    Path scene =
        SmallScene.write(
            folder,
            "<LOD range='1e9'>" + SmallScene.shape(3) + SmallScene.shape(5) + "</LOD>",
            "<Switch whichChoice='-1'>" + SmallScene.shape(7) + "</Switch>",
            "<Switch whichChoice='1'>" + SmallScene.shape(7) + SmallScene.shape(11) + "</Switch>",
            "<Group visible='false'>" + SmallScene.shape(13) + "</Group>",
            SmallScene.shape(17).replace("<Shape>", "<Shape visible='false'>"),
            "<Collision><Shape containerField='proxy'><Sphere/></Shape>"
                + SmallScene.shape(19)
                + "</Collision>",
            "<Billboard>" + SmallScene.shape(23) + "</Billboard>",
            "<CADFace>" + "<Shape containerField='shape'><Box/></Shape>" + "</CADFace>",
            "<Anchor><Transform DEF='T' scale='2 1 1'>"
                + SmallScene.shape(29)
                + "</Transform></Anchor>",
            "<Transform USE='T'/>",
            "<Shape><IndexedLineSet coordIndex='0 1 -1'><Coordinate point='0 0 0 1 1 1'/>"
                + "</IndexedLineSet></Shape>",
            "<CollidableShape><Shape containerField='shape'><Box/></Shape></CollidableShape>",
            "<ScreenGroup>" + SmallScene.shape(31) + "</ScreenGroup>",
            "<InstancedShape translations='0 0 0 1 0 0' scales='1 1 1 2 2 2 3 3 3'><Box/>"
                + "</InstancedShape>");

    assertThat(counted(scene))
        .isEqualTo(running(scene))
        .isEqualTo(3 + 11 + 19 + 23 + 12 + 58 + 12 + 31 + 3 * 12);
  }

  @Test
  void theSameNodeTypesAreGroups() {
    NodeFactory factory = new NodeFactory();
    for (NodeType type : CATALOGUE.all()) {
      assertThat(DrawableNodeClassifier.isGroup(type))
          .as(type.name())
          .isEqualTo(factory.make(type, null, SourceLocation.of("test")) instanceof GroupingNode);
    }
  }

  @ParameterizedTest
  @CsvSource({"trashcan, desk-visit", "overlap, overlap-visit"})
  void aWalkThroughAllAreasHasTheCountsOfTheStates(String scene, String walk)
      throws IOException, InterruptedException {
    Path file = Path.of("scenes", scene + ".x3d");
    Path path = Path.of("scenes", "paths", walk + ".csv");
    List<TimelineEvent> events = new ArrayList<>();
    CameraPath camera = CameraPathReader.read(path, new ProblemCollector()).orElseThrow();
    SceneRunner.simulated(
        new RunSettings(file, SelectiveController.Settings.SELECTIVE)
            .with(MotionSettings.following(PathPlaybackSettings.at(60, camera))),
        new RunListener() {
          @Override
          public void problem(Problem problem) {
            // The scenes are checked elsewhere.
          }

          @Override
          public void happened(TimelineEvent event) {
            events.add(event);
          }

          @Override
          public void printed(String text) {
            // Nothing prints.
          }
        });
    var polygons = ((TimelineEvent.End) events.get(events.size() - 1)).polygons();

    SceneStatistics statistics = ScenePolygonCounter.of(file, List.of(), new ProblemCollector());
    List<StateCount> states = statistics.scopes().get(0).states();
    long outside = statistics.totalHigh() - statistics.scopes().get(0).high();

    assertThat(states.get(0).polygons() + outside).isEqualTo(polygons.start());
    assertThat(states.stream().mapToLong(StateCount::polygons).max().orElseThrow() + outside)
        .isEqualTo(polygons.max());
  }

  private static long counted(Path scene) throws IOException {
    CountGraphBuilder items =
        new CountGraphBuilder(
            SceneFileLoader.read(scene, ContentAccessPolicy.none()), new ProblemCollector());
    return new PolygonCounter(Map.of()).of(items.root());
  }

  private static long running(Path scene) throws IOException {
    try (SceneLoader loader =
        new SceneLoader(
            CATALOGUE, new NodeFactory(), ReadLimits.standard(), new ProblemCollector())) {
      LoadedScene loaded = loader.load(scene);
      return new InstanceTree((GroupingNode) loaded.scene().root(), loaded.assets())
          .shownPolygons();
    }
  }
}
