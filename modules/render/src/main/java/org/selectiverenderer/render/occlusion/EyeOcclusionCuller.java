package org.selectiverenderer.render.occlusion;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.camera.Camera;

/**
 * Occlusion culling for one eye. It works for perspective projections without shear only; with
 * others nothing is hidden. Depth is the distance along the view direction.
 */
final class EyeOcclusionCuller {
  /** An occluder that can cover fewer cells than this is not rasterised. */
  private static final double FEWEST_CELLS = 48;

  /**
   * The depth error of sliver triangles within a bounding box, as a share of the box's depth range.
   */
  private static final double SLIVERS = 1 / 32.0;

  private final OcclusionBuffer grid = new OcclusionBuffer();
  private final ConservativeDepthBound side = new ConservativeDepthBound();
  private final OccluderClipper clipper = new OccluderClipper();
  private final Matrix4d toEye = new Matrix4d();
  private final Matrix4d inverse = new Matrix4d();
  private final Vector3d localEye = new Vector3d();
  private Matrix4dc view = toEye;
  private Vector3dc eye = localEye;
  private boolean usable;
  private double near;
  private double perspective;
  private double focal;
  private double scaleX;
  private double scaleY;
  private double originX;
  private double originY;
  private double cellsPerPixelX;
  private double cellsPerPixelY;
  private double terms;
  private double sharpFrom;
  private double stretch;
  private double keep;
  private double lost;

  /** Begins a frame with a camera; nothing is hidden yet. */
  void look(Camera camera) {
    Matrix4dc p = camera.projection();
    view = camera.view();
    eye = camera.eye();
    usable =
        p.m23() == -1
            && p.m33() == 0
            && p.m32() < 0
            && p.m00() > 0
            && p.m11() > 0
            && Math.abs(p.m01()) + Math.abs(p.m02()) + Math.abs(p.m03()) == 0
            && Math.abs(p.m10()) + Math.abs(p.m12()) + Math.abs(p.m13()) == 0
            && Math.abs(p.m30()) + Math.abs(p.m31()) == 0;
    if (!usable) {
      return;
    }
    perspective = p.m32();
    near = perspective / (p.m22() - 1) * (1 + 1e-4);
    focal = Math.max(p.m00() * camera.width(), p.m11() * camera.height()) / 2;
    scaleX = p.m00() * OcclusionBuffer.COLUMNS / 2;
    scaleY = p.m11() * OcclusionBuffer.ROWS / 2;
    originX = (1 - p.m20()) * OcclusionBuffer.COLUMNS / 2;
    originY = (1 - p.m21()) * OcclusionBuffer.ROWS / 2;
    cellsPerPixelX = (double) OcclusionBuffer.COLUMNS / camera.width();
    cellsPerPixelY = (double) OcclusionBuffer.ROWS / camera.height();
    grid.clear(
        RasterErrorBounds.PIXELS * cellsPerPixelX, RasterErrorBounds.PIXELS * cellsPerPixelY);
  }

  /**
   * Estimates the most cells that a box can cover; infinite if the eye is in its bounding sphere.
   *
   * @param box min x, y, z, max x, y, z in the world
   */
  double cells(double[] box) {
    double x = (box[0] + box[3]) / 2 - eye.x();
    double y = (box[1] + box[4]) / 2 - eye.y();
    double z = (box[2] + box[5]) / 2 - eye.z();
    double w = box[3] - box[0];
    double h = box[4] - box[1];
    double d = box[5] - box[2];
    return usable ? cells((w * w + h * h + d * d) / 4, x * x + y * y + z * z) : 0;
  }

  /** Returns a number of cells that no box within a box can cover more of. */
  double mostCells(double[] box) {
    double radius2 = 0;
    double distance2 = 0;
    for (int axis = 0; axis < 3; axis++) {
      double side = box[axis + 3] - box[axis];
      double before =
          Math.max(0, Math.max(box[axis] - eye.get(axis), eye.get(axis) - box[axis + 3]));
      radius2 += side * side / 4;
      distance2 += before * before;
    }
    return usable ? cells(radius2, distance2) : 0;
  }

  private double cells(double radius2, double distance2) {
    return distance2 <= radius2
        ? Double.POSITIVE_INFINITY
        : Math.PI * radius2 / (distance2 - radius2) * scaleX * scaleY;
  }

  /** Rasterises the occluders of a mesh. */
  void cover(MeshOccluders occluders, Matrix4dc world) {
    if (!usable) {
      return;
    }
    ask(world, occluders.reach());
    view.mulAffine(world, toEye);
    if (!toEye.invertAffine(inverse).isFinite()) {
      return;
    }
    inverse.getTranslation(localEye);
    for (OccluderPolygon patch : occluders.patches()) {
      cover(patch, occluders.solid());
    }
  }

  private void cover(OccluderPolygon patch, boolean solid) {
    double[] n = patch.plane();
    double before = n[0] * localEye.x + n[1] * localEye.y + n[2] * localEye.z - n[3];
    double distance = Math.abs(before);
    double[] sphere = patch.sphere();
    double x = sphere[0] - localEye.x;
    double y = sphere[1] - localEye.y;
    double z = sphere[2] - localEye.z;
    double centre2 = x * x + y * y + z * z;
    double farthest = Math.sqrt(centre2) + sphere[3];
    double nearest = Math.max(distance, Math.sqrt(centre2) - sphere[3]);
    double cells = patch.area() * distance / (nearest * nearest * nearest) * scaleX * scaleY;
    // If seen edge-on, some of the triangles may face away.
    boolean edgeOn = distance <= 2 * patch.thickness() + (2 * patch.tilt() + 1e-5) * farthest;
    if ((solid && before < 0)
        || edgeOn
        || cells < FEWEST_CELLS
        || !clipper.clip(patch, toEye, sharpFrom)) {
      return;
    }
    clipper.edges(patch, grid, scaleX, scaleY, originX, originY);
    // The linear function 1 / depth of the plane, which is moved back by its thickness.
    double k = (before > 0 ? -1 : 1) / (distance + patch.thickness());
    Matrix4d m = inverse;
    double a = k * (m.m00() * n[0] + m.m01() * n[1] + m.m02() * n[2]) / scaleX;
    double b = k * (m.m10() * n[0] + m.m11() * n[1] + m.m12() * n[2]) / scaleY;
    double c = -k * (m.m20() * n[0] + m.m21() * n[1] + m.m22() * n[2]) - a * originX - b * originY;
    double keep = 1 - RasterErrorBounds.depthLoss(perspective, terms);
    grid.fill(a * keep, b * keep, c * keep - RasterErrorBounds.depthLoss(perspective));
  }

  /** To be called after the last {@link #cover}. */
  void finish() {
    if (usable) {
      grid.finish();
    }
  }

  /**
   * Sets the mesh and place of the shape that is queried next.
   *
   * @param reach the distance from the origin as {@link RasterErrorBounds#reach} returns it for the
   *     mesh
   */
  void ask(Matrix4dc world, double reach) {
    if (usable) {
      terms = RasterErrorBounds.terms(world, reach, eye);
      sharpFrom = Math.max(near, RasterErrorBounds.sharpFrom(terms, focal));
    }
  }

  /** Sets a bound of the terms of all shapes that are in the boxes queried next. */
  void ask(double termsAtOrigin) {
    if (usable) {
      terms = RasterErrorBounds.terms(termsAtOrigin, eye);
      sharpFrom = Math.max(near, RasterErrorBounds.sharpFrom(terms, focal));
    }
  }

  /** Sets the coordinate system of the spheres that are queried next. */
  void enter(Matrix4dc world) {
    if (usable) {
      view.mulAffine(world, toEye);
      stretch = RasterErrorBounds.stretch(toEye);
    }
  }

  /**
   * Returns whether a box is hidden or lies outside of the view.
   *
   * @param pixels the pixels by which its contents may reach beyond it on the screen
   */
  boolean hides(double[] box, double pixels) {
    if (!usable) {
      return false;
    }
    double minX = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    double nearest = Double.POSITIVE_INFINITY;
    double farthest = 0;
    Matrix4dc v = view;
    for (int corner = 0; corner < 8; corner++) {
      double x = box[(corner & 1) * 3];
      double y = box[(corner >> 1 & 1) * 3 + 1];
      double z = box[(corner >> 2) * 3 + 2];
      double depth = -(v.m02() * x + v.m12() * y + v.m22() * z + v.m32());
      if (!(depth > sharpFrom)) {
        return false;
      }
      double right = (v.m00() * x + v.m10() * y + v.m20() * z + v.m30()) / depth;
      double up = (v.m01() * x + v.m11() * y + v.m21() * z + v.m31()) / depth;
      minX = Math.min(minX, right);
      maxX = Math.max(maxX, right);
      minY = Math.min(minY, up);
      maxY = Math.max(maxY, up);
      nearest = Math.min(nearest, depth);
      farthest = Math.max(farthest, depth);
    }
    between(nearest, farthest);
    for (int axis = 0; axis < 3; axis++) {
      double from = box[axis] - eye.get(axis);
      double to = box[axis + 3] - eye.get(axis);
      double before = from > 0 ? from : to < 0 ? to : 0;
      if (before != 0) {
        face(v.get(axis, 0), v.get(axis, 1), v.get(axis, 2), before, pixels);
      }
    }
    return hides(minX, minY, maxX, maxY, pixels);
  }

  /** Returns whether a sphere is hidden, in the coordinates set by {@link #enter}. */
  boolean hides(float[] spheres, int at) {
    if (!usable) {
      return false;
    }
    double cx = spheres[at];
    double cy = spheres[at + 1];
    double cz = spheres[at + 2];
    double radius = spheres[at + 3] * stretch;
    double depth = -(toEye.m02() * cx + toEye.m12() * cy + toEye.m22() * cz + toEye.m32());
    double nearest = depth - radius;
    if (!(nearest > sharpFrom)) {
      return false;
    }
    double x = toEye.m00() * cx + toEye.m10() * cy + toEye.m20() * cz + toEye.m30();
    double y = toEye.m01() * cx + toEye.m11() * cy + toEye.m21() * cz + toEye.m31();
    double farthest = depth + radius;
    between(nearest, farthest);
    return hides(
        (x - radius) / (x < radius ? nearest : farthest),
        (y - radius) / (y < radius ? nearest : farthest),
        (x + radius) / (x > -radius ? nearest : farthest),
        (y + radius) / (y > -radius ? nearest : farthest),
        0);
  }

  private boolean hides(double minX, double minY, double maxX, double maxY, double pixels) {
    double marginX = (RasterErrorBounds.PIXELS + pixels) * cellsPerPixelX;
    double marginY = (RasterErrorBounds.PIXELS + pixels) * cellsPerPixelY;
    return grid.hides(
        minX * scaleX + originX - marginX,
        minY * scaleY + originY - marginY,
        maxX * scaleX + originX + marginX,
        maxY * scaleY + originY + marginY,
        side);
  }

  /** Begins the query of an object that lies between two depths. */
  private void between(double nearest, double farthest) {
    double depth = 1 / nearest;
    keep = 1 + RasterErrorBounds.depthLoss(perspective, terms);
    lost = RasterErrorBounds.depthLoss(perspective) + SLIVERS * (depth - 1 / farthest);
    side.begin(depth * keep + lost);
  }

  /**
   * Adds a face of the queried box, behind which all of the box lies.
   *
   * @param x the world axis that is normal to the face, in the eye's coordinates
   * @param before the distance along that axis from the eye to the face
   */
  private void face(double x, double y, double z, double before, double pixels) {
    // On the face, 1 / depth times that distance is the component of the view ray along the axis.
    double a = x / before / scaleX;
    double b = y / before / scaleY;
    double c = -z / before - a * originX - b * originY;
    side.face(
        a * keep,
        b * keep,
        c * keep + lost,
        (RasterErrorBounds.PIXELS + pixels) * cellsPerPixelX,
        (RasterErrorBounds.PIXELS + pixels) * cellsPerPixelY);
  }
}
