package org.selectiverenderer.browser.collision;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.nodes.group.CollisionNode;
import org.selectiverenderer.geometry.mesh.Mesh;

/** A mesh with a place in the world that a ray may hit or the viewer collide with. */
public sealed interface PlacedMesh {
  Optional<Mesh> mesh();

  /** Returns the matrix from the mesh's local coordinates to the world. */
  Matrix4dc world();

  /** Returns the world-space bounding box; the same array until the mesh moves or is replaced. */
  double[] bounds();

  /** Returns whether the mesh is present in the scene's current state. */
  boolean present();

  /**
   * Returns the Collision nodes above the mesh, which are told when the viewer collides with it.
   */
  List<CollisionNode> collisions();

  private static boolean enabled(List<CollisionNode> collisions) {
    for (CollisionNode collision : collisions) {
      if (!collision.enabled()) {
        return false;
      }
    }
    return true;
  }

  /** A drawn shape of the scene. */
  record OfShape(ShapeInstance shape, List<CollisionNode> collisions) implements PlacedMesh {
    @Override
    public Optional<Mesh> mesh() {
      return shape.mesh();
    }

    @Override
    public Matrix4dc world() {
      return shape.world();
    }

    @Override
    public double[] bounds() {
      return shape.bounds();
    }

    @Override
    public boolean present() {
      return shape.shown() && enabled(collisions);
    }
  }

  /**
   * A shape of a Collision node's proxy, which is in no instance tree of the scene and thus never
   * drawn.
   */
  final class OfProxy implements PlacedMesh {
    private final GroupInstance collision;
    private final ShapeInstance part;
    private final List<CollisionNode> collisions;
    private @Nullable Matrix4dc placedBy;
    private double[] partBounds = {};
    private double[] bounds = {};
    private final Matrix4d world = new Matrix4d();

    /**
     * @param collision the instance of the Collision node
     * @param part a shape in the instance tree made of the proxy
     */
    OfProxy(GroupInstance collision, ShapeInstance part, List<CollisionNode> collisions) {
      this.collision = collision;
      this.part = part;
      this.collisions = collisions;
    }

    @Override
    public Optional<Mesh> mesh() {
      return part.mesh();
    }

    @Override
    public Matrix4dc world() {
      return collision.content().mul(part.world(), world);
    }

    @Override
    public double[] bounds() {
      if (placedBy != collision.content() || partBounds != part.bounds()) {
        placedBy = collision.content();
        partBounds = part.bounds();
        bounds = partBounds[0] > partBounds[3] ? partBounds.clone() : placed(placedBy);
      }
      return bounds;
    }

    private double[] placed(Matrix4dc by) {
      Vector3d min = new Vector3d();
      Vector3d max = new Vector3d();
      double[] b = partBounds;
      by.transformAab(b[0], b[1], b[2], b[3], b[4], b[5], min, max);
      return new double[] {min.x, min.y, min.z, max.x, max.y, max.z};
    }

    @Override
    public boolean present() {
      return collision.shown() && part.shown() && enabled(collisions);
    }

    @Override
    public List<CollisionNode> collisions() {
      return collisions;
    }
  }
}
