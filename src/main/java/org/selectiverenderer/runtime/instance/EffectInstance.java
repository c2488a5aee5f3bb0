package org.selectiverenderer.runtime.instance;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;

/**
 * A LocalFog, ClipPlane or EnvironmentLight in one place: what the other children of its group, and
 * all below them, are seen with (X3D 4.0, 24.4.4 and 11.4.1). {@link #world()} takes its fields to
 * the world.
 */
public final class EffectInstance extends Instance {
  private final @Nullable EnvironmentReader environment;

  EffectInstance(Node node, @Nullable GroupInstance parent, Assets assets) {
    super(node, parent);
    environment = isEnvironment(node) ? new EnvironmentReader(node, assets) : null;
  }

  static boolean isEffect(Node node) {
    return isFog(node) || isEnvironment(node) || node.type().name().equals("ClipPlane");
  }

  private static boolean isEnvironment(Node node) {
    return node.type().name().equals("EnvironmentLight");
  }

  private static boolean isFog(Node node) {
    return node.type().name().equals("LocalFog");
  }

  boolean fog() {
    return isFog(node());
  }

  boolean environment() {
    return environment != null;
  }

  /** Whether it lights all of the scene, not only its group. */
  boolean everywhere() {
    return environment() && node().bool("global");
  }

  private boolean on() {
    return shown && node().bool(environment() ? "on" : "enabled");
  }

  /** The fog in force here, else empty. */
  Optional<Fog> fogNow() {
    return fog() && on() ? Optional.of(Fog.read(node(), world())) : Optional.empty();
  }

  /** The light from all around that it gives now; empty when it gives none. */
  Optional<Environment> environmentNow() {
    return environment != null && on() ? environment.read(world()) : Optional.empty();
  }

  /**
   * The plane in the world, a, b, c, d: what has {@code a * x + b * y + c * z + d} below 0 is cut
   * off. Empty when it cuts nothing now.
   */
  public Optional<Vector4d> planeNow() {
    if (fog() || environment() || !on()) {
      return Optional.empty();
    }
    float[] plane = node().floats("plane");
    Vector4d local = new Vector4d(plane[0], plane[1], plane[2], plane[3]);
    // A plane moves with the transposed inverse of what moves points.
    Vector4d placed = world().invert(new Matrix4d()).transpose().transform(local, new Vector4d());
    return placed.isFinite() ? Optional.of(placed) : Optional.empty();
  }

  @Override
  void show(boolean show, InstanceTree tree) {
    shown = show;
  }

  @Override
  void moved(InstanceTree tree) {
    // Its world() is its parent's: nothing is kept here.
  }
}
