package org.selectiverenderer.walkthrough.transition;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector4d;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.collision.MeshBvhCache;
import org.selectiverenderer.browser.collision.RayCaster;

/**
 * The view of one eye on an object. First come rays through the part of the picture that the
 * version's boxes cover: the share that meets the object, times the part's pixels, is its pixels.
 * Where hardly any ray meets it, as with a thin or small object, rays go to points on its surface.
 */
final class ObjectView {
  /** The number of rays through a part of the picture that has only a few pixels. */
  private static final int FEWEST = 12;

  /** The number of hits that suffice to count the pixels. */
  private static final int ENOUGH = 4;

  /**
   * The number of hits by which a count may be too small: where none of n rays hits, the share that
   * would be hit is at most 3 / n with 95 % confidence (rule of three; Hanley and Lippman-Hand
   * 1983).
   */
  private static final int UNSEEN = 3;

  /** The part of a ray, before its end, that counts as the end. */
  private static final double END = 1e-3;

  private final Camera eye;
  private final ShownObject object;
  private final SightRays rays;
  private final MeshBvhCache hierarchies;
  private final Matrix4d toClip;
  private final Matrix4d fromClip;
  private final Vector4d clip = new Vector4d();

  ObjectView(Camera eye, ShownObject object, SightRays rays, MeshBvhCache hierarchies) {
    this.eye = eye;
    this.object = object;
    this.rays = rays;
    this.hierarchies = hierarchies;
    toClip = eye.projection().mul(eye.view(), new Matrix4d());
    fromClip = toClip.invert(new Matrix4d());
  }

  private Optional<PictureArea> area(VersionSurface version) {
    return PictureArea.of(version.boxes(), toClip);
  }

  /** Returns whether the boxes of a version meet the view. */
  boolean enters() {
    return object.versions().stream().anyMatch(version -> area(version).isPresent());
  }

  /**
   * Returns what the eye sees of the object.
   *
   * @param most the number of rays through the part of the picture
   * @param exactly whether the pixels are asked for; otherwise the first ray that meets the object
   *     ends the search
   */
  VisibilityEstimator.Estimate look(int most, boolean exactly) {
    Optional<PictureArea> area = area(object.counted());
    double all = area.map(part -> part.pixels(eye)).orElse(0.0);
    int count = area.isEmpty() ? 0 : (int) Math.max(FEWEST, Math.min(most, all));
    int hits = 0;
    for (int n = 0; n < count; n++) {
      hits += meets(area.get(), n) ? 1 : 0;
      if (hits > 0 && !exactly) {
        return new VisibilityEstimator.Estimate(true, 0);
      }
    }
    if (hits >= ENOUGH) {
      return new VisibilityEstimator.Estimate(true, all * hits / count);
    }
    VisibilityEstimator.Estimate points = points(exactly && hits > 0, exactly);
    double limit = count == 0 ? 0 : all * Math.min(1, (hits + UNSEEN) / (double) count);
    double pixels = points.pixels() > 0 || count == 0 ? points.pixels() : all * hits / count;
    return new VisibilityEstimator.Estimate(hits > 0 || points.visible(), Math.min(limit, pixels));
  }

  /** Returns whether a ray through the n-th point of a part of the picture meets the object. */
  private boolean meets(PictureArea area, int n) {
    double across = area.left() + (area.right() - area.left()) * PlaneSequence.first(n);
    double up = area.bottom() + (area.top() - area.bottom()) * PlaneSequence.second(n);
    Vector3d from = fromClip.transformProject(new Vector3d(across, up, -1));
    Vector3d ray = fromClip.transformProject(new Vector3d(across, up, 0)).sub(from);
    Optional<RayCaster.Hit> hit = rays.first(from, ray, Double.POSITIVE_INFINITY, object);
    if (!object.shown().isEmpty()) {
      return hit.isPresent() && object.has(hit.get().shape());
    }
    double hidden = hit.map(first -> first.point().distance(from)).orElse(Double.MAX_VALUE);
    return object.other().distance(from, ray, hierarchies) * ray.length() < hidden;
  }

  /**
   * Looks for points on the surfaces of the versions.
   *
   * @param seen whether some of the object is known to be seen, so that only the version that
   *     counts is of interest
   */
  private VisibilityEstimator.Estimate points(boolean seen, boolean exactly) {
    boolean visible = seen;
    double pixels = 0;
    for (VersionSurface version : object.versions()) {
      boolean counts = version == object.counted();
      if (visible && !counts) {
        continue;
      }
      for (SurfaceSamples.Sample sample : version.samples()) {
        Vector3d at = sample.world();
        if (!inside(at)) {
          continue;
        }
        Optional<RayCaster.Hit> hit = before(at);
        pixels += hit.isEmpty() && counts ? pixels(sample, at) : 0;
        visible |= hit.isEmpty() || object.has(hit.get().shape());
        if (visible && !exactly) {
          return new VisibilityEstimator.Estimate(true, 0);
        }
      }
    }
    return new VisibilityEstimator.Estimate(visible, pixels);
  }

  private boolean inside(Vector3dc at) {
    clip.set(at, 1).mul(toClip);
    return clip.w > 0 && Math.abs(clip.x) <= clip.w && Math.abs(clip.y) <= clip.w;
  }

  /** Returns what is met before a point; empty if nothing hides it. */
  private Optional<RayCaster.Hit> before(Vector3dc at) {
    Vector3d from = eye.parallel() ? onEyePlane(at) : new Vector3d(eye.eye());
    Vector3d ray = at.sub(from, new Vector3d());
    double distance = ray.length();
    return distance == 0 ? Optional.empty() : rays.first(from, ray, distance * (1 - END), object);
  }

  private Vector3d onEyePlane(Vector3dc at) {
    Vector3d seen = eye.view().transformPosition(at, new Vector3d());
    seen.z = Math.max(0, seen.z);
    return eye.view().invertAffine(new Matrix4d()).transformPosition(seen);
  }

  /**
   * Returns the pixels of the part A of the surface for which a point stands: A cos(t) / d^2, its
   * solid angle (d: distance, t: angle between normal and ray), times the pixels per steradian
   * there, which are f^2 / cos^3(a) of a plane picture (f: pixels per unit of the tangent, a: angle
   * from the axis).
   */
  private double pixels(SurfaceSamples.Sample sample, Vector3dc at) {
    Vector3d area = sample.area();
    Vector3d seen = eye.view().transformPosition(at, new Vector3d());
    eye.view().transformDirection(area);
    double perUnit =
        eye.projection().m00() * eye.width() / 2 * eye.projection().m11() * eye.height() / 2;
    if (eye.parallel()) {
      return facing(sample, -area.z) * perUnit;
    }
    // Of A cos(t) / d^2 and f^2 / cos^3(a) = f^2 d^3 / z^3 remains f^2 A cos(t) d / z^3.
    return facing(sample, area.dot(seen)) * perUnit / Math.pow(-seen.z, 3);
  }

  /** Returns the area that is seen; the back of a solid is not drawn. */
  private double facing(SurfaceSamples.Sample sample, double along) {
    return sample.mesh().solid() ? Math.max(0, -along) : Math.abs(along);
  }
}
