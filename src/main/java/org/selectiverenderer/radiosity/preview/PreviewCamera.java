package org.selectiverenderer.radiosity.preview;

import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.scene.Node;

/**
 * Where a preview is seen from.
 *
 * @param world from the camera's coordinates, looking along -z, to the world in metres
 * @param fieldOfView radians, of the shorter side
 */
public record PreviewCamera(Matrix4d world, double fieldOfView) {

  /** The first Viewpoint of a scene, or X3D's default place (X3D 4.0, 23.4.6). */
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

  /** The direction through a pixel's middle in the world, of unit length. */
  Vector3d direction(double x, double y, int width, int height, Vector3d out) {
    double scale = 2 * StrictMath.tan(fieldOfView / 2) / Math.min(width, height);
    out.set((x - width / 2.0) * scale, (height / 2.0 - y) * scale, -1);
    return world.transformDirection(out).normalize();
  }
}
