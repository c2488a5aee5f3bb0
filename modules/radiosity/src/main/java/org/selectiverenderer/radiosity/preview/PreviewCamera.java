package org.selectiverenderer.radiosity.preview;

import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.scene.Node;

/**
 * The camera of a preview.
 *
 * @param world transform from camera coordinates, looking along -z, to world coordinates in metres
 * @param fieldOfView field of view along the image's shorter side, radians
 */
public record PreviewCamera(Matrix4d world, double fieldOfView) {

  /**
   * Returns the camera of a scene's first Viewpoint, or of X3D's default view (X3D 4.0, 23.4.6).
   */
  public static PreviewCamera of(InstanceTree tree, double unit) {
    for (Node node : tree.otherNodes()) {
      List<Matrix4dc> places = tree.places(node);
      if (node.type().name().equals("Viewpoint") && !places.isEmpty()) {
        float[] p = node.floats("position");
        float[] r = node.floats("orientation");
        Matrix4d world = new Matrix4d(places.get(0)).translate(p[0], p[1], p[2]);
        Vector3d axis = new Vector3d(r[0], r[1], r[2]);
        if (axis.length() > 0) {
          world.rotate(r[3], axis.normalize());
        }
        world.setTranslation(world.getTranslation(new Vector3d()).mul(unit));
        return new PreviewCamera(world, node.number("fieldOfView"));
      }
    }
    return new PreviewCamera(new Matrix4d().translation(0, 0, 10 * unit), Math.PI / 4);
  }

  /**
   * Computes the unit vector, in world coordinates, from the camera through a point of the image.
   */
  Vector3d direction(double x, double y, int width, int height, Vector3d out) {
    double scale = 2 * StrictMath.tan(fieldOfView / 2) / Math.min(width, height);
    out.set((x - width / 2.0) * scale, (height / 2.0 - y) * scale, -1);
    return world.transformDirection(out).normalize();
  }
}
