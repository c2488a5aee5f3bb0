package org.selectiverenderer.browser.instance;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/**
 * An instance of a LocalFog, ClipPlane or EnvironmentLight, which affects the other children of its
 * group and all nodes below them (X3D 4.0, 24.4.4 and 11.4.1). {@link #world()} is the matrix from
 * the coordinates of its fields to the world.
 */
public final class ScopedEffectInstance extends Instance {
  private final @Nullable EnvironmentLightReader environment;

  ScopedEffectInstance(Node node, @Nullable GroupInstance parent, AssetProvider assets) {
    super(node, parent);
    environment = isEnvironment(node) ? new EnvironmentLightReader(node, assets) : null;
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

  /**
   * Returns whether this is an EnvironmentLight that lights the whole scene, not only its group.
   */
  boolean everywhere() {
    return environment() && node().bool("global");
  }

  private boolean on() {
    return shown && node().bool(environment() ? "on" : "enabled");
  }

  /** Returns the fog if this is an enabled LocalFog, else empty. */
  Optional<Fog> fogNow() {
    return fog() && on() ? Optional.of(Fog.read(node(), world())) : Optional.empty();
  }

  /** Returns the environment lighting that this node gives now; empty if it gives none. */
  Optional<EnvironmentLight> environmentNow() {
    return environment != null && on() ? environment.read(world()) : Optional.empty();
  }

  /**
   * Returns the clip plane in the world as a, b, c, d: points with {@code a * x + b * y + c * z +
   * d} below 0 are cut off. Empty if this node clips nothing now.
   */
  public Optional<Vector4d> planeNow() {
    if (fog() || environment() || !on()) {
      return Optional.empty();
    }
    float[] plane = node().floats("plane");
    Vector4d local = new Vector4d(plane[0], plane[1], plane[2], plane[3]);
    // Planes transform by the inverse transpose of the matrix that transforms points.
    Vector4d placed = world().invert(new Matrix4d()).transpose().transform(local, new Vector4d());
    return placed.isFinite() ? Optional.of(placed) : Optional.empty();
  }

  @Override
  void show(boolean show, InstanceTree tree) {
    shown = show;
  }

  @Override
  void moved(InstanceTree tree) {
    // Nothing to update: world() is the parent's matrix.
  }
}
