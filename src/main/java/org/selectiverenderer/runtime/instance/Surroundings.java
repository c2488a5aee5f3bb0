package org.selectiverenderer.runtime.instance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3dc;
import org.joml.Vector4d;

/**
 * What a shape is seen with because of where it stands: the LocalFog, ClipPlane and
 * EnvironmentLight nodes whose scope it is in, on or off.
 *
 * @param fogs the innermost first, which hides the others
 * @param planes the outermost first
 * @param environments the innermost first, which hides the others
 * @param everywhere all of the scene: those that are global light what no other does
 */
public record Surroundings(
    List<EffectInstance> fogs,
    List<EffectInstance> planes,
    List<EffectInstance> environments,
    List<EffectInstance> everywhere) {
  public static final Surroundings NONE =
      new Surroundings(List.of(), List.of(), List.of(), List.of());

  /** What all of a scene with these EnvironmentLights is seen with. */
  static Surroundings of(List<EffectInstance> environments) {
    return environments.isEmpty()
        ? NONE
        : new Surroundings(List.of(), List.of(), List.of(), List.copyOf(environments));
  }

  /** These and what stands in a group; the same object when there is nothing. */
  Surroundings within(List<Instance> children) {
    List<EffectInstance> moreFogs = null;
    List<EffectInstance> morePlanes = null;
    List<EffectInstance> moreLights = null;
    for (Instance child : children) {
      if (child instanceof EffectInstance effect && effect.fog()) {
        moreFogs = moreFogs == null ? new ArrayList<>() : moreFogs;
        moreFogs.add(effect);
      } else if (child instanceof EffectInstance effect && effect.environment()) {
        moreLights = moreLights == null ? new ArrayList<>() : moreLights;
        moreLights.add(effect);
      } else if (child instanceof EffectInstance effect) {
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
    return new Surroundings(
        moreFogs == null ? fogs : List.copyOf(moreFogs),
        morePlanes == null ? planes : List.copyOf(morePlanes),
        moreLights == null ? environments : List.copyOf(moreLights),
        everywhere);
  }

  /** The fog of the innermost LocalFog that is enabled; empty when there is none. */
  public Optional<Fog> fog() {
    for (EffectInstance effect : fogs) {
      Optional<Fog> now = effect.fogNow();
      if (now.isPresent()) {
        return now;
      }
    }
    return Optional.empty();
  }

  /** The light of the innermost EnvironmentLight that is on, else of a global one. */
  public Optional<Environment> environment() {
    for (EffectInstance effect : environments) {
      Optional<Environment> now = effect.environmentNow();
      if (now.isPresent()) {
        return now;
      }
    }
    for (EffectInstance effect : everywhere) {
      Optional<Environment> now = effect.everywhere() ? effect.environmentNow() : Optional.empty();
      if (now.isPresent()) {
        return now;
      }
    }
    return Optional.empty();
  }

  /** Whether a place in the world is cut off. */
  public boolean cutOff(Vector3dc at) {
    for (EffectInstance effect : planes) {
      Optional<Vector4d> plane = effect.planeNow();
      if (plane.isPresent() && plane.get().dot(at.x(), at.y(), at.z(), 1) < 0) {
        return true;
      }
    }
    return false;
  }
}
