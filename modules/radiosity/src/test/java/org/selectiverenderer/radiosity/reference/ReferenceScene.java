package org.selectiverenderer.radiosity.reference;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.scene.RadiositySceneBuilder;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * A scene file as the light sees it, and from where it is looked at.
 *
 * @param views by what their Viewpoints are called, in the order of the file
 */
record ReferenceScene(RadiosityScene scene, List<View> views) {

  /**
   * A viewpoint.
   *
   * @param name its DEF, or its description
   * @param world from the camera's coordinates, looking along -z, to the world in metres
   * @param fieldOfView radians, of the shorter side (X3D 4.0, 23.3.5)
   */
  record View(String name, String description, Matrix4dc world, double fieldOfView) {
    Vector3d eye() {
      return world.getTranslation(new Vector3d());
    }

    /**
     * The direction in the world, of unit length.
     *
     * @param x pixels from the left
     * @param y pixels from the top
     */
    Vector3d direction(double x, double y, int width, int height) {
      double scale = 2 * StrictMath.tan(fieldOfView / 2) / Math.min(width, height);
      Vector3d out = new Vector3d((x - width / 2.0) * scale, (height / 2.0 - y) * scale, -1);
      return world.transformDirection(out).normalize();
    }
  }

  /**
   * @throws IOException if it cannot be read
   * @throws RadiosityException if there is nothing to light, or no light
   */
  static ReferenceScene read(Path file) throws IOException, RadiosityException {
    ProblemCollector problems = new ProblemCollector();
    try (SceneLoader loader =
        new SceneLoader(NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), problems)) {
      LoadedScene loaded = loader.load(file);
      InstanceTree tree = new InstanceTree((GroupingNode) loaded.scene().root(), loaded.assets());
      double unit = loaded.scene().unitLength();
      RadiosityScene scene = new RadiositySceneBuilder(true, problems).read(tree, unit);
      return new ReferenceScene(scene, views(tree, unit));
    }
  }

  private static List<View> views(InstanceTree tree, double unit) {
    List<View> views = new ArrayList<>();
    for (Node node : tree.otherNodes()) {
      if (!node.type().name().equals("Viewpoint") || tree.places(node).isEmpty()) {
        continue;
      }
      float[] p = node.floats("position");
      float[] r = node.floats("orientation");
      Matrix4d world = new Matrix4d(tree.places(node).get(0)).translate(p[0], p[1], p[2]);
      Vector3d axis = new Vector3d(r[0], r[1], r[2]);
      if (axis.length() > 0) {
        world.rotate(r[3], axis.normalize());
      }
      world.setTranslation(world.getTranslation(new Vector3d()).mul(unit));
      views.add(
          new View(
              String.valueOf(node.name()),
              node.string("description"),
              world,
              node.number("fieldOfView")));
    }
    return views;
  }

  /**
   * The viewpoint of a name or description; the first if none is named.
   *
   * @throws IllegalArgumentException with the names that there are
   */
  View view(String name) {
    return views.stream()
        .filter(
            view -> name.isEmpty() || view.name().equals(name) || view.description().equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "there is no Viewpoint '%s'; there are %s"
                        .formatted(name, views.stream().map(View::name).toList())));
  }
}
