package org.selectiverenderer.browser.collision;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.nodes.group.CollisionNode;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.shader.ShaderSource;

/** A small scene made of meshes. */
public final class TestWorld implements AssetProvider {
  private final Map<Node, Mesh> meshes = new IdentityHashMap<>();
  private final NodeFactory factory = new NodeFactory();
  final EventCascade cascade = new EventCascade(new ProblemCollector());
  final GroupingNode root = (GroupingNode) node("Group");
  final MeshBvhCache bvhs = new MeshBvhCache();
  private InstanceTree tree;

  Node node(String type) {
    return factory.make(TestNodes.CATALOGUE.get(type), null, SourceLocation.of("test.x3d"));
  }

  Node shape(Mesh mesh) {
    Node geometry = node("Box");
    meshes.put(geometry, mesh);
    Node shape = node("Shape");
    shape.init(shape.type().indexOf("geometry"), geometry);
    return shape;
  }

  GroupingNode group(String type, Node... children) {
    GroupingNode group = (GroupingNode) node(type);
    group.init(group.type().indexOf("children"), List.of(children));
    return group;
  }

  GroupingNode moved(double x, double y, double z, Node... children) {
    GroupingNode transform = group("Transform", children);
    set(transform, "translation", new float[] {(float) x, (float) y, (float) z});
    return transform;
  }

  CollisionNode collision(Node proxy, Node... children) {
    CollisionNode collision = (CollisionNode) group("Collision", children);
    collision.init(collision.type().indexOf("proxy"), proxy);
    return collision;
  }

  /** Gives a field a value, as an event once the world runs. */
  void set(Node node, String field, Object value) {
    cascade.send(node, node.type().indexOf(field), value);
    cascade.run();
  }

  TestWorld add(Node... nodes) {
    List<Node> all = new ArrayList<>(root.children());
    all.addAll(List.of(nodes));
    set(root, "children", List.copyOf(all));
    return this;
  }

  public TestWorld add(Mesh... shapes) {
    for (Mesh mesh : shapes) {
      add(shape(mesh));
    }
    return this;
  }

  InstanceTree tree() {
    if (tree == null) {
      tree = new InstanceTree(root, this);
    }
    tree.update();
    return tree;
  }

  public CollisionWorld colliders() {
    return new CollisionWorld(tree(), this, bvhs);
  }

  RayCaster rays() {
    return new RayCaster(tree(), bvhs);
  }

  @Override
  public Optional<Mesh> mesh(Node geometry) {
    return Optional.ofNullable(meshes.get(geometry));
  }

  @Override
  public Optional<Texture.Image> image(Node texture) {
    return Optional.empty();
  }

  @Override
  public Optional<ShaderSource> shader(Node part) {
    return Optional.empty();
  }

  @Override
  public void told(Problem problem) {
    throw new AssertionError(problem);
  }

  @Override
  public boolean multiplies(Node texture) {
    return false;
  }

  @Override
  public void asOf(Node node, int changes) {
    // Meshes made by hand do not change.
  }

  @Override
  public void changed(Node node) {
    // Meshes made by hand do not change.
  }
}
