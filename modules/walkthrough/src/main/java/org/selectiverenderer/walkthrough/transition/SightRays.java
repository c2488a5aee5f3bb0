package org.selectiverenderer.walkthrough.transition;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.collision.MeshBvhCache;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.browser.instance.ExtendedMaterial;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.browser.instance.TextureUnit;

/** Casts rays that pass what the viewer sees through, and counts them. */
final class SightRays {
  /** The number of transparent surfaces that a ray passes; what is behind them counts as seen. */
  private static final int MOST_PASSED = 16;

  private final MeshBvhCache hierarchies;
  private final Map<InstanceTree, RayCaster> casters = new IdentityHashMap<>();
  private int cast;

  SightRays(MeshBvhCache hierarchies) {
    this.hierarchies = hierarchies;
  }

  /** Begins to count anew, and forgets all trees but some. */
  void begin(List<InstanceTree> trees) {
    cast = 0;
    casters.keySet().removeIf(tree -> !trees.contains(tree));
  }

  /** Returns the number of rays since the count began. */
  int cast() {
    return cast;
  }

  /**
   * Returns the first shape of a tree on a ray that hides what is behind it, or that is of
   * an object; empty for none.
   *
   * @param most length of the ray in world units; may be infinite
   */
  Optional<RayCaster.Hit> first(Vector3dc from, Vector3dc ray, double most, ShownObject object) {
    RayCaster caster =
        casters.computeIfAbsent(object.tree(), tree -> new RayCaster(tree, hierarchies));
    Vector3d start = new Vector3d(from);
    double left = most;
    for (int passed = 0; passed < MOST_PASSED; passed++) {
      cast++;
      Optional<RayCaster.Hit> hit = caster.cast(start, ray, left);
      if (hit.isEmpty() || object.has(hit.get().shape()) || !transparent(hit.get().shape())) {
        return hit;
      }
      double on = hit.get().distance() * (1 + 1e-6) + 1e-9;
      start.fma(on / ray.length(), ray);
      left -= on;
      if (left <= 0) {
        return Optional.empty();
      }
    }
    return Optional.empty();
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
