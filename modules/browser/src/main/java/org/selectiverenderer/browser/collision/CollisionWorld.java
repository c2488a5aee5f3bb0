package org.selectiverenderer.browser.collision;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.ToLongFunction;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.nodes.group.CollisionNode;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.layout.LayoutGroupNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * The geometry that the viewer collides with and stands on (X3D 4.0, 23.2.4 and 23.4.2): every
 * visible shape, from both sides, except lines, points, children of disabled Collision nodes and
 * children that a Collision proxy replaces. It follows the updates of the instance tree. Belongs to
 * the thread that steps the world.
 */
public final class CollisionWorld {
  private final InstanceTree tree;
  private final AssetProvider assets;
  private final MeshBvhCache meshes;
  private final Map<CollisionNode, InstanceTree> proxies = new IdentityHashMap<>();
  private PlacedMeshIndex<PlacedMesh> index;
  private long structure = -1;
  private long placement;

  /**
   * @param assets provides the meshes of proxies
   */
  public CollisionWorld(InstanceTree tree, AssetProvider assets, MeshBvhCache meshes) {
    this.tree = tree;
    this.assets = assets;
    this.meshes = meshes;
    index = new PlacedMeshIndex<>(List.of(), tree, meshes);
  }

  /** Brings the index up to date with the scene and the proxies. */
  private void refresh() {
    long structureNow = tree.structureVersion();
    long placementNow = tree.placementVersion();
    for (InstanceTree proxy : proxies.values()) {
      proxy.update();
      structureNow += proxy.structureVersion();
      placementNow += proxy.placementVersion();
    }
    if (structureNow != structure) {
      List<PlacedMesh> all = new ArrayList<>();
      collect(tree.root(), List.of(), all);
      index = new PlacedMeshIndex<>(all, tree, meshes);
      // The versions of new proxies enter these sums from the next call on.
      structure = versions(InstanceTree::structureVersion);
      placement = versions(InstanceTree::placementVersion);
    } else if (placementNow != placement) {
      placement = placementNow;
      index.refresh();
    }
  }

  private long versions(ToLongFunction<InstanceTree> version) {
    return version.applyAsLong(tree) + proxies.values().stream().mapToLong(version).sum();
  }

  private void collect(Instance instance, List<CollisionNode> above, List<PlacedMesh> all) {
    if (instance instanceof ShapeInstance shape) {
      all.add(new PlacedMesh.OfShape(shape, above));
    } else if (instance instanceof GroupInstance group
        && !(group.node() instanceof LayoutGroupNode)) {
      if (group.node() instanceof CollisionNode collision) {
        List<CollisionNode> with = new ArrayList<>(above);
        with.add(collision);
        List<CollisionNode> collisions = List.copyOf(with);
        if (collision.proxy().isPresent()) {
          for (ShapeInstance part : proxy(collision, collision.proxy().get()).shapes()) {
            all.add(new PlacedMesh.OfProxy(group, part, collisions));
          }
        } else {
          group.children().forEach(child -> collect(child, collisions, all));
        }
      } else {
        group.children().forEach(child -> collect(child, above, all));
      }
    }
  }

  private InstanceTree proxy(CollisionNode collision, Node proxy) {
    return proxies.computeIfAbsent(
        collision,
        node -> {
          GroupingNode holder = new GroupingNode(node.type(), null, node.location());
          holder.init(node.type().indexOf("children"), List.of(proxy));
          return new InstanceTree(holder, assets);
        });
  }

  /**
   * Returns the distance to the first surface along a ray.
   *
   * @param direction the unit direction, in world coordinates
   */
  public OptionalDouble distance(Vector3dc origin, Vector3dc direction, double limit) {
    refresh();
    return index
        .ray(origin, direction, limit, false)
        .map(hit -> OptionalDouble.of(hit.at().distance()))
        .orElse(OptionalDouble.empty());
  }

  /**
   * Collects the triangles that touch a box.
   *
   * @param frame the rotation from the coordinates of box and triangles to the world; both have the
   *     same origin
   * @param box min x, y, z, max x, y, z
   */
  public void gather(Quaterniondc frame, double[] box, CandidateTriangles into) {
    refresh();
    into.clear();
    Matrix4d toWorld = new Matrix4d().rotation(frame);
    Matrix4d toFrame = toWorld.transpose(new Matrix4d());
    index.overlap(transform(box, toWorld), placed -> gather(placed, toFrame, box, into));
  }

  private void gather(PlacedMesh placed, Matrix4dc toFrame, double[] box, CandidateTriangles into) {
    Mesh mesh = placed.mesh().orElse(null);
    Matrix4d local = toFrame.mul(placed.world(), new Matrix4d());
    Matrix4d inverse = local.invertAffine(new Matrix4d());
    if (mesh == null || mesh.polygons() == 0 || !inverse.isFinite()) {
      return;
    }
    MeshBvh bvh = meshes.of(mesh);
    Vector3d a = new Vector3d();
    Vector3d b = new Vector3d();
    Vector3d c = new Vector3d();
    bvh.inBox(
        transform(box, inverse),
        triangle -> {
          local.transformPosition(bvh.corner(triangle, 0, a));
          local.transformPosition(bvh.corner(triangle, 1, b));
          local.transformPosition(bvh.corner(triangle, 2, c));
          into.add(a, b, c, placed);
        });
  }

  private static double[] transform(double[] box, Matrix4dc by) {
    Vector3d min = new Vector3d();
    Vector3d max = new Vector3d();
    by.transformAab(box[0], box[1], box[2], box[3], box[4], box[5], min, max);
    return new double[] {min.x, min.y, min.z, max.x, max.y, max.z};
  }
}
