package org.selectiverenderer.browser.instance;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.nodes.layout.ViewParameters;
import org.selectiverenderer.browser.nodes.shader.ShaderNode;
import org.selectiverenderer.browser.nodes.shape.GeneratedCubeMapTextureNode;
import org.selectiverenderer.browser.nodes.sound.SoundSourceNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;

/** An instance of a Shape, which a renderer draws and a ray may hit. */
public final class ShapeInstance extends Instance {
  private final SharedShapeState look;

  /** The index in the tree's list of shapes. */
  int index;

  private double @Nullable [] bounds;
  private @Nullable Matrix4dc placed;
  private List<LightInstance> lights = List.of();
  private ScopedEffects surroundings = ScopedEffects.NONE;

  /** The view parameters, for a shape whose text is measured in pixels. */
  private @Nullable ViewParameters sight;

  ShapeInstance(Node node, @Nullable GroupInstance parent, SharedShapeState look) {
    super(node, parent);
    this.look = look;
  }

  /** Returns the mesh in local coordinates; the same object until the geometry changes. */
  public Optional<Mesh> mesh() {
    return look.mesh();
  }

  /** Returns the surface's material; the same object until it changes. */
  public SurfaceMaterial surface() {
    return look.surface();
  }

  /**
   * Returns the matrix from the mesh's coordinates, whose origin may be offset from the Shape's, to
   * the world.
   */
  @Override
  public Matrix4dc world() {
    Vector3dc anchor = look.anchor();
    if (anchor == null && sight == null) {
      return super.world();
    }
    Matrix4dc known = placed;
    if (known == null) {
      known =
          anchor != null
              ? super.world().translate(anchor, new Matrix4d())
              : super.world().scale(sight.pixelScale(super.world()), new Matrix4d());
      placed = known;
    }
    return known;
  }

  /** Returns the index in {@link InstanceTree#shapes()}. */
  public int index() {
    return index;
  }

  /** Returns the movie textures on the shape. */
  public List<SoundSourceNode> films() {
    return look.films();
  }

  /** Returns the generated cube maps on the shape. */
  public List<GeneratedCubeMapTextureNode> cubes() {
    return look.cubes();
  }

  /** Returns how lines, points and areas are drawn; the same object until that changes. */
  public DrawProperties stroke() {
    return look.stroke();
  }

  /**
   * Returns the shader programs that the author wrote, of which the first that compiles draws the
   * shape; mostly none.
   */
  public List<ShaderProgramSource> programs() {
    return look.programs();
  }

  /**
   * Tells a shader node whether its program compiled and is used.
   *
   * @param valid whether the program compiled and linked
   * @param selected whether shapes are drawn with it
   * @param problems the program's problems that have not been reported yet
   */
  public void judged(ShaderNode shader, boolean valid, boolean selected, List<Problem> problems) {
    look.judged(shader, valid, selected, problems);
  }

  SharedShapeState look() {
    return look;
  }

  /** Returns the lights whose scope contains the shape, on or off. */
  public List<LightInstance> lights() {
    return lights;
  }

  /** Returns the fog, clip planes and environment lights whose scope contains the shape. */
  public ScopedEffects surroundings() {
    return surroundings;
  }

  void surround(ScopedEffects with) {
    surroundings = with;
  }

  void light(List<LightInstance> reaching) {
    lights = reaching;
  }

  /**
   * Returns the axis-aligned bounding box in the world: min x, y, z, max x, y, z. Empty geometry
   * has min above max.
   */
  public double[] bounds() {
    if (bounds == null) {
      bounds =
          mesh().map(mesh -> transform(mesh.bounds(), world())).orElseGet(ShapeInstance::empty);
    }
    return bounds;
  }

  /**
   * Adapts text that is measured in pixels to the size of the picture; returns whether that changed
   * the shape's place.
   */
  boolean see(ViewParameters now) {
    ViewParameters wanted = look.onScreen() ? now : null;
    if (Objects.equals(wanted, sight)) {
      return false;
    }
    sight = wanted;
    forgetBounds();
    return true;
  }

  void forgetBounds() {
    bounds = null;
    placed = null;
  }

  private static double[] empty() {
    double inf = Double.POSITIVE_INFINITY;
    return new double[] {inf, inf, inf, -inf, -inf, -inf};
  }

  private static double[] transform(float[] box, Matrix4dc world) {
    if (box[0] > box[3]) {
      return empty();
    }
    Vector3d min = new Vector3d();
    Vector3d max = new Vector3d();
    world.transformAab(box[0], box[1], box[2], box[3], box[4], box[5], min, max);
    return new double[] {min.x, min.y, min.z, max.x, max.y, max.z};
  }

  @Override
  void show(boolean show, InstanceTree tree) {
    boolean now = show && look.visible();
    if (now != shown) {
      shown = now;
      tree.polygonsShown(now ? look.polygons() : -look.polygons());
      if (now) {
        tree.changes().add(this);
      }
    }
    wanted = show;
  }

  /** Whether a {@link VersionFades} has the shape. */
  boolean fading;

  /**
   * Returns whether the shape is part of a version that is being cross-faded, so that it is drawn
   * in some of its pixels only, shown or not.
   */
  public boolean fading() {
    return fading;
  }

  /** Whether the groups above show the shape, whatever its own {@code visible} says. */
  boolean wanted;

  @Override
  void moved(InstanceTree tree) {
    forgetBounds();
    tree.changes().add(this);
  }
}
