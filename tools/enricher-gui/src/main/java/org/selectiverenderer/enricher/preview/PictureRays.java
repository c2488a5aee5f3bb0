package org.selectiverenderer.enricher.preview;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector4d;
import org.selectiverenderer.browser.camera.Camera;

/**
 * The lines of sight through the pixels of a picture. Pixels count from the upper left.
 *
 * @param camera of the picture, which nobody changes
 */
record PictureRays(Camera camera) {
  /** Projects a world point to pixels of the picture; empty if it is behind the viewer. */
  Optional<Vector2d> project(Vector3dc place) {
    Vector4d point = new Vector4d(place, 1);
    camera.projection().transform(camera.view().transform(point));
    return point.w > 0
        ? Optional.of(
            new Vector2d(
                (point.x / point.w + 1) / 2 * camera.width(),
                (1 - point.y / point.w) / 2 * camera.height()))
        : Optional.empty();
  }

  /** Returns the unit direction of the line of sight through a pixel, and sets its origin. */
  Vector3d sight(double px, double py, Vector3d origin) {
    Matrix4dc inverse = camera.projection().mul(camera.view(), new Matrix4d()).invert();
    double right = 2 * px / camera.width() - 1;
    double up = 1 - 2 * py / camera.height();
    Vector4d near = inverse.transform(new Vector4d(right, up, -1, 1));
    Vector4d far = inverse.transform(new Vector4d(right, up, 1, 1));
    origin.set(near.x, near.y, near.z).div(near.w);
    return new Vector3d(far.x, far.y, far.z).div(far.w).sub(origin).normalize();
  }

  /** Returns the parameter along a line at which the line of sight comes nearest to it. */
  double along(Vector3dc origin, Vector3dc direction, double px, double py) {
    Vector3d eye = new Vector3d();
    Vector3d sight = sight(px, py, eye);
    Vector3d between = eye.sub(origin, new Vector3d());
    double both = direction.dot(sight);
    double across = 1 - both * both;
    if (across < 1e-4) {
      return 0; // the line of sight is parallel to the line
    }
    return (between.dot(direction) - both * between.dot(sight)) / across;
  }

  /** Returns where the line of sight meets a plane in front of the viewer. */
  Optional<Vector3d> onPlane(Vector3dc point, Vector3dc normal, double px, double py) {
    Vector3d eye = new Vector3d();
    Vector3d sight = sight(px, py, eye);
    double towards = sight.dot(normal);
    if (Math.abs(towards) < 1e-3) {
      return Optional.empty();
    }
    double distance = point.sub(eye, new Vector3d()).dot(normal) / towards;
    return distance > 0 ? Optional.of(eye.fma(distance, sight)) : Optional.empty();
  }

  /** Returns the length in the world of a pixel at a point; 0 if it is behind the viewer. */
  double pixel(Vector3dc at) {
    Vector3d right = new Vector3d();
    camera.view().getRow(0, right);
    Optional<Vector2d> here = project(at);
    Optional<Vector2d> beside = project(right.normalize().mul(0.01).add(at));
    double pixels = here.isPresent() && beside.isPresent() ? here.get().distance(beside.get()) : 0;
    return pixels > 1e-9 ? 0.01 / pixels : 0;
  }
}
