package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3dc;
import org.joml.Vector4d;
import org.jspecify.annotations.Nullable;

/**
 * The effects that apply to a shape because of its place in the scene graph: the LocalFog,
 * ClipPlane and EnvironmentLight nodes whose scope contains it, on or off.
 *
 * @param fogs the LocalFogs, the innermost first, which overrides the others
 * @param planes the ClipPlanes, the outermost first
 * @param environments the EnvironmentLights, the innermost first, which overrides the others
 * @param everywhere all EnvironmentLights of the scene; global ones light the shapes that no other
 *     one lights
 */
public record ScopedEffects(
    List<ScopedEffectInstance> fogs,
    List<ScopedEffectInstance> planes,
    List<ScopedEffectInstance> environments,
    List<ScopedEffectInstance> everywhere) {
  public static final ScopedEffects NONE =
      new ScopedEffects(List.of(), List.of(), List.of(), List.of());

  /** Returns the effects that apply to the whole of a scene with these EnvironmentLights. */
  static ScopedEffects of(List<ScopedEffectInstance> environments) {
    return environments.isEmpty()
        ? NONE
        : new ScopedEffects(List.of(), List.of(), List.of(), List.copyOf(environments));
  }

  /**
   * Returns these effects and those of a group's children; the same object if the group has none.
   */
  ScopedEffects within(List<Instance> children) {
    List<ScopedEffectInstance> moreFogs = null;
    List<ScopedEffectInstance> morePlanes = null;
    List<ScopedEffectInstance> moreLights = null;
    for (Instance child : children) {
      if (child instanceof ScopedEffectInstance effect && effect.fog()) {
        moreFogs = moreFogs == null ? new ArrayList<>() : moreFogs;
        moreFogs.add(effect);
      } else if (child instanceof ScopedEffectInstance effect && effect.environment()) {
        moreLights = moreLights == null ? new ArrayList<>() : moreLights;
        moreLights.add(effect);
      } else if (child instanceof ScopedEffectInstance effect) {
        morePlanes = morePlanes == null ? new ArrayList<>(planes) : morePlanes;
        morePlanes.add(effect);
      }
    }
    if (moreFogs == null && morePlanes == null && moreLights == null) {
      return this;
    }
    if (moreFogs != null) {
      moreFogs.addAll(fogs);
    }
    if (moreLights != null) {
      moreLights.addAll(environments);
    }
    return new ScopedEffects(
        moreFogs == null ? fogs : List.copyOf(moreFogs),
        morePlanes == null ? planes : List.copyOf(morePlanes),
        moreLights == null ? environments : List.copyOf(moreLights),
        everywhere);
  }

  /** Returns the fog of the innermost enabled LocalFog; empty if there is none. */
  public Optional<Fog> fog() {
    for (ScopedEffectInstance effect : fogs) {
      Optional<Fog> now = effect.fogNow();
      if (now.isPresent()) {
        return now;
      }
    }
    return Optional.empty();
  }

  /** Returns the lighting of the innermost EnvironmentLight that is on, else of a global one. */
  public Optional<EnvironmentLight> environment() {
    for (ScopedEffectInstance effect : environments) {
      Optional<EnvironmentLight> now = effect.environmentNow();
      if (now.isPresent()) {
        return now;
      }
    }
    for (ScopedEffectInstance effect : everywhere) {
      Optional<EnvironmentLight> now =
          effect.everywhere() ? effect.environmentNow() : Optional.empty();
      if (now.isPresent()) {
        return now;
      }
    }
    return Optional.empty();
  }

  /** Returns whether a ClipPlane cuts off a point of the world. */
  public boolean cutOff(Vector3dc at) {
    for (ScopedEffectInstance effect : planes) {
      Optional<Vector4d> plane = effect.planeNow();
      if (plane.isPresent() && plane.get().dot(at.x(), at.y(), at.z(), 1) < 0) {
        return true;
      }
    }
    return false;
  }

  // Written out, as records link theirs when first called: the first frame would wait for it.
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof ScopedEffects one
        && fogs.equals(one.fogs)
        && planes.equals(one.planes)
        && environments.equals(one.environments)
        && everywhere.equals(one.everywhere);
  }

  @Override
  public int hashCode() {
    int shapes = 31 * fogs.hashCode() + planes.hashCode();
    return 31 * (31 * shapes + environments.hashCode()) + everywhere.hashCode();
  }
}
