package org.selectiverenderer.walkthrough.transition;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.EyeCameras;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.browser.instance.ExtendedMaterial;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.browser.instance.TextureUnit;
import org.selectiverenderer.browser.scene.Node;

/**
 * Estimates whether the viewer sees an object of several versions, and how large, by rays from the
 * eyes to {@value SurfaceSamples#COUNT} points on the surface of each of the two versions
 * concerned. A point is seen if it lies in an eye's view and nothing but the object itself or
 * something transparent is before it. A surface of which hardly a point lies in the view, because
 * it is large and near, is looked for by rays through a grid over its part of the picture.
 *
 * <p>The pixels are those of the eye that sees most. Each point of the version that is shown stands
 * for an equal area A of the surface; if nothing hides it, it adds A cos(t) / d^2, its solid angle
 * (d: distance, t: angle between normal and ray), times the pixels per steradian there, which are
 * f^2 / cos^3(a) of a plane picture (f: pixels per unit of the tangent, a: angle from the axis).
 *
 * <p>The rays of a frame are limited, so that many objects at once do not hold it up.
 */
final class VisibilityEstimator {
  /** The number of rays of a frame beyond which no further object is looked at. */
  private static final int MOST_RAYS = 2048;

  /** The number of transparent surfaces that a ray passes; what is behind them counts as seen. */
  private static final int MOST_PASSED = 16;

  /** The rays in each direction over the part of the picture that an object may cover. */
  private static final int GRID = 6;

  /** The number of points in view below which the grid is used. */
  private static final int FEW = 4;

  /** The part of a ray, before its end, that counts as the end. */
  private static final double END = 1e-3;

  /**
   * What is seen of an object.
   *
   * @param pixels of the version that is shown; of the other one, if none is
   */
  record Estimate(boolean visible, double pixels) {
    static final Estimate NOTHING = new Estimate(false, 0);
  }

  private final World world;
  private final Map<Instance, List<SurfaceSamples.Sample>> known = new IdentityHashMap<>();
  private @Nullable InstanceTree tree;
  private long structure;
  private @Nullable RayCaster caster;
  private int rays;

  VisibilityEstimator(World world) {
    this.world = world;
  }

  /** Begins a frame, in which as many rays may be cast as in any other. */
  void begin() {
    rays = 0;
  }

  /**
   * Returns what is seen of an object now; empty if too many rays have been cast in this frame.
   *
   * @param shown index of the version that is shown
   * @param other index of the version that is to be shown
   * @param exactly whether the pixels are asked for; otherwise the first point that is seen ends
   *     the search
   */
  Optional<Estimate> of(Node switchNode, int shown, int other, boolean exactly) {
    Estimate all = Estimate.NOTHING;
    List<Camera> eyes = EyeCameras.of(world);
    for (Instance instance : tree().instances(switchNode)) {
      if (!(instance instanceof GroupInstance group) || !group.shown()) {
        continue;
      }
      for (Camera eye : eyes) {
        View view = new View(eye, group);
        if (!view.enters(samples(group, shown)) && !view.enters(samples(group, other))) {
          continue;
        }
        if (rays > MOST_RAYS) {
          return Optional.empty();
        }
        Estimate one = view.look(samples(group, shown), samples(group, other), exactly);
        // A point that is very near stands for more pixels than there are.
        double pixels = Math.min(one.pixels, (double) eye.width() * eye.height());
        all = new Estimate(all.visible || one.visible, Math.max(all.pixels, pixels));
        if (all.visible && !exactly) {
          return Optional.of(all);
        }
      }
    }
    return Optional.of(all);
  }

  private InstanceTree tree() {
    InstanceTree now = world.instances();
    if (now != tree) {
      tree = now;
      caster = new RayCaster(now, world.meshes());
      known.clear();
    }
    if (structure != now.structureVersion()) {
      structure = now.structureVersion();
      known.clear(); // Versions may have got other shapes, such as those of an Inline.
    }
    return now;
  }

  private List<SurfaceSamples.Sample> samples(GroupInstance group, int version) {
    if (version < 0 || version >= group.children().size()) {
      return List.of();
    }
    Instance child = group.children().get(version);
    List<SurfaceSamples.Sample> samples = known.get(child);
    if (samples == null
        || samples.isEmpty() // Its meshes may have come meanwhile.
        || !samples.stream().allMatch(SurfaceSamples.Sample::current)) {
      samples = SurfaceSamples.of(child);
      known.put(child, samples);
    }
    return samples;
  }

  /** The view of one eye on an object. */
  private final class View {
    private final Camera eye;
    private final GroupInstance object;
    private final Matrix4d toClip;
    private final Vector4d clip = new Vector4d();

    View(Camera eye, GroupInstance object) {
      this.eye = eye;
      this.object = object;
      toClip = eye.projection().mul(eye.view(), new Matrix4d());
    }

    private boolean inside(Vector3dc at) {
      clip.set(at, 1).mul(toClip);
      return clip.w > 0 && Math.abs(clip.x) <= clip.w && Math.abs(clip.y) <= clip.w;
    }

    /** Returns whether the box of some shape of a version meets the view. */
    boolean enters(List<SurfaceSamples.Sample> samples) {
      ShapeInstance before = null;
      for (SurfaceSamples.Sample sample : samples) {
        if (sample.shape() != before) {
          before = sample.shape();
          if (part(List.of(before.bounds())).isPresent()) {
            return true;
          }
        }
      }
      return false;
    }

    Estimate look(
        List<SurfaceSamples.Sample> shown, List<SurfaceSamples.Sample> other, boolean exactly) {
      int inView = 0;
      boolean visible = false;
      double pixels = 0;
      for (List<SurfaceSamples.Sample> version : List.of(shown, other)) {
        boolean counts = version == shown || shown.isEmpty();
        for (SurfaceSamples.Sample sample : version) {
          Vector3d at = sample.world();
          if (!inside(at)) {
            continue;
          }
          inView++;
          ShapeInstance hit = before(at);
          if (hit == null && counts) {
            pixels += pixels(sample, at);
          }
          visible |= hit == null || belongs(hit);
          if (visible && !exactly) {
            return new Estimate(true, pixels);
          }
        }
      }
      // Of an object of which only points that it hides itself are in the view, rays tell the area.
      if (inView >= FEW && !(visible && exactly && pixels == 0)) {
        return new Estimate(visible, pixels);
      }
      Estimate near = near(shown);
      return new Estimate(visible || near.visible, Math.max(pixels, near.pixels));
    }

    /** Looks for the version that is shown by rays through its part of the picture. */
    private Estimate near(List<SurfaceSamples.Sample> shown) {
      Optional<double[]> found =
          part(shown.stream().map(sample -> sample.shape().bounds()).distinct().toList());
      if (found.isEmpty()) {
        return Estimate.NOTHING;
      }
      double[] part = found.get();
      Matrix4d back = toClip.invert(new Matrix4d());
      int hits = 0;
      for (int y = 0; y < GRID; y++) {
        for (int x = 0; x < GRID; x++) {
          double across = part[0] + (part[2] - part[0]) * (x + 0.5) / GRID;
          double up = part[1] + (part[3] - part[1]) * (y + 0.5) / GRID;
          Vector3d from = back.transformProject(new Vector3d(across, up, -1));
          Vector3d ray = back.transformProject(new Vector3d(across, up, 0)).sub(from);
          ShapeInstance hit = first(from, ray, Double.POSITIVE_INFINITY);
          hits += hit != null && belongs(hit) ? 1 : 0;
        }
      }
      double area = (part[2] - part[0]) / 2 * eye.width() * (part[3] - part[1]) / 2 * eye.height();
      return new Estimate(hits > 0, area * hits / (GRID * GRID));
    }

    /**
     * Returns the part of the picture that boxes may cover, in -1..1: left, bottom, right, top;
     * empty if they are out of view.
     */
    private Optional<double[]> part(List<double[]> boxes) {
      double[] part = {1, 1, -1, -1};
      for (double[] box : boxes) {
        if (box[0] > box[3]) {
          continue;
        }
        boolean behind = false;
        boolean before = false;
        double[] own = {Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        int[] beyond = new int[4];
        for (int corner = 0; corner < 8; corner++) {
          clip.set(
                  box[(corner & 1) == 0 ? 0 : 3],
                  box[(corner & 2) == 0 ? 1 : 4],
                  box[(corner & 4) == 0 ? 2 : 5],
                  1)
              .mul(toClip);
          behind |= clip.w <= 0;
          before |= clip.w > 0;
          beyond[0] += clip.x < -clip.w ? 1 : 0;
          beyond[1] += clip.x > clip.w ? 1 : 0;
          beyond[2] += clip.y < -clip.w ? 1 : 0;
          beyond[3] += clip.y > clip.w ? 1 : 0;
          own[0] = Math.min(own[0], clip.x / clip.w);
          own[1] = Math.min(own[1], clip.y / clip.w);
          own[2] = Math.max(own[2], clip.x / clip.w);
          own[3] = Math.max(own[3], clip.y / clip.w);
        }
        if (!before || beyond[0] == 8 || beyond[1] == 8 || beyond[2] == 8 || beyond[3] == 8) {
          continue;
        }
        for (int i = 0; i < 2; i++) {
          part[i] = behind ? -1 : Math.min(part[i], Math.max(-1, own[i]));
          part[i + 2] = behind ? 1 : Math.max(part[i + 2], Math.min(1, own[i + 2]));
        }
      }
      return part[0] < part[2] && part[1] < part[3] ? Optional.of(part) : Optional.empty();
    }

    /** Returns what hides a point, if only other parts of the object; null if nothing does. */
    private @Nullable ShapeInstance before(Vector3dc at) {
      Vector3d from = eye.parallel() ? onEyePlane(at) : new Vector3d(eye.eye());
      Vector3d ray = at.sub(from, new Vector3d());
      double distance = ray.length();
      return distance == 0 ? null : first(from, ray, distance * (1 - END));
    }

    private Vector3d onEyePlane(Vector3dc at) {
      Vector3d seen = eye.view().transformPosition(at, new Vector3d());
      seen.z = Math.max(0, seen.z);
      return eye.view().invertAffine(new Matrix4d()).transformPosition(seen);
    }

    /** Returns the first shape on a ray that nobody sees through; null for none. */
    private @Nullable ShapeInstance first(Vector3dc from, Vector3dc ray, double most) {
      Vector3d start = new Vector3d(from);
      double left = most;
      for (int passed = 0; passed < MOST_PASSED; passed++) {
        rays++;
        Optional<RayCaster.Hit> hit = caster.cast(start, ray, left);
        if (hit.isEmpty() || !transparent(hit.get().shape())) {
          return hit.map(RayCaster.Hit::shape).orElse(null);
        }
        double on = hit.get().distance() * (1 + 1e-6) + 1e-9;
        start.fma(on / ray.length(), ray);
        left -= on;
        if (left <= 0) {
          return null;
        }
      }
      return null;
    }

    private boolean belongs(ShapeInstance shape) {
      for (Instance at = shape; at != null; at = at.parent()) {
        if (at == object) {
          return true;
        }
      }
      return false;
    }

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

  /** Returns whether something behind a shape may be seen through it. */
  private static boolean transparent(ShapeInstance shape) {
    SurfaceMaterial surface = shape.surface();
    return surface.transparency() > 0
        || shape.fading()
        || shape.stroke().hollow()
        || !shape.programs().isEmpty()
        || surface.texture() != null && surface.texture().image().translucent()
        || surface.glow() != null && surface.glow().image().translucent()
        || surface.detail() != null && transparent(surface.detail());
  }

  private static boolean transparent(ExtendedMaterial detail) {
    List<Integer> components = new ArrayList<>();
    for (TextureUnit unit : detail.units()) {
      components.add(unit.source().components());
    }
    return detail.alphaMode() == ExtendedMaterial.AlphaMode.BLEND
        || components.contains(2)
        || components.contains(4)
        || detail.back() != null && detail.back().transparency() > 0;
  }
}
