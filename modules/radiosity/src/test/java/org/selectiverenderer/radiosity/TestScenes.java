package org.selectiverenderer.radiosity;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.scene.RadiositySceneBuilder;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** Scenes written in tests. */
public final class TestScenes {
  private TestScenes() {}

  public static String x3d(String body) {
    return "<X3D profile='Immersive' version='3.3'><Scene>" + body + "</Scene></X3D>";
  }

  public static RadiosityScene read(String body) throws IOException, RadiosityException {
    return read(body, new ProblemCollector());
  }

  public static RadiosityScene read(String body, ProblemCollector problems)
      throws IOException, RadiosityException {
    try (SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      byte[] bytes = x3d(body).getBytes(StandardCharsets.UTF_8);
      LoadedScene loaded =
          loader.load("test.x3d", new ByteArrayInputStream(bytes), Path.of("").toAbsolutePath());
      InstanceTree tree = new InstanceTree((GroupingNode) loaded.scene().root(), loaded.assets());
      return new RadiositySceneBuilder(true, problems).read(tree, 1);
    }
  }

  /** A flat shape of four points, counter-clockwise seen from its front. */
  public static String quad(String points, String material) {
    return """
    <Shape><Appearance><Material %s/></Appearance>
    <IndexedFaceSet coordIndex='0 1 2 3 -1'><Coordinate point='%s'/></IndexedFaceSet></Shape>
    """
        .formatted(material, points);
  }

  /**
   * Two-sided walls of a bin of 30 cm without lid that stands at x, z = 2: once with the outside in
   * front, once with the inside.
   */
  public static List<String> bins(String material) {
    return Stream.of(
            "0 4 5 1 -1 1 5 6 2 -1 2 6 7 3 -1 3 7 4 0 -1",
            "0 1 5 4 -1 1 2 6 5 -1 2 3 7 6 -1 3 0 4 7 -1")
        .map(
            order ->
                ("<Shape><Appearance><Material %s/></Appearance>"
                        + "<IndexedFaceSet solid='false' coordIndex='%s'><Coordinate point='"
                        + "1.85 0 1.85 2.15 0 1.85 2.15 0 2.15 1.85 0 2.15 "
                        + "1.85 0.3 1.85 2.15 0.3 1.85 2.15 0.3 2.15 1.85 0.3 2.15'/>"
                        + "</IndexedFaceSet></Shape>")
                    .formatted(material, order))
        .toList();
  }

  /** A room from the inside: six walls that face inwards. */
  public static String room(double x, double y, double z, double side, String material) {
    String p =
        "%s %s %s".formatted(x, y, z)
            + ", %s %s %s".formatted(x + side, y, z)
            + ", %s %s %s".formatted(x + side, y + side, z)
            + ", %s %s %s".formatted(x, y + side, z)
            + ", %s %s %s".formatted(x, y, z + side)
            + ", %s %s %s".formatted(x + side, y, z + side)
            + ", %s %s %s".formatted(x + side, y + side, z + side)
            + ", %s %s %s".formatted(x, y + side, z + side);
    return """
    <Shape><Appearance><Material %s/></Appearance>
    <IndexedFaceSet coordIndex='0 1 2 3 -1 5 4 7 6 -1 4 0 3 7 -1 1 5 6 2 -1 3 2 6 7 -1 4 5 1 0 -1'>
    <Coordinate point='%s'/></IndexedFaceSet></Shape>
    """
        .formatted(material, p);
  }
}
