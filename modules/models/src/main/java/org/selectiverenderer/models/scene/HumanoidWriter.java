package org.selectiverenderer.models.scene;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes a skin with its joints as an HAnimHumanoid (X3D 4.0, 26.3.2). */
public final class HumanoidWriter {
  /** The maximum number of joints that are written; each figure has its own. */
  static final int MAX_JOINTS = 20_000;

  private final X3dWriter out;
  private final DefNames names;
  private final AnimatedNodes animated;
  private int left = MAX_JOINTS;

  /**
   * @param animated receives the joints
   */
  public HumanoidWriter(X3dWriter out, DefNames names, AnimatedNodes animated) {
    this.out = out;
    this.names = names;
    this.animated = animated;
  }

  /** The vertices that follow a joint, and by how much. */
  private static final class Influence {
    private final StringBuilder vertices = new StringBuilder();
    private final StringBuilder weights = new StringBuilder();
  }

  /**
   * Tells how much a vertex follows a joint.
   *
   * @param vertex the index of the vertex
   * @param joint the index of the joint in its skin
   * @param weight more than 0
   */
  public record Weight(int vertex, int joint, float weight) {}

  /**
   * Holds what is drawn.
   *
   * @param points x, y, z of the mesh
   * @param normals x, y, z of the mesh; empty for none
   * @param weights of all vertices
   */
  public record Surface(float[] points, float[] normals, List<Weight> weights) {}

  /** Writes the Shapes of the skin, whose Coordinate and Normal have been written before. */
  @FunctionalInterface
  public interface Shapes {
    /**
     * @param coordinate the DEF name of the Coordinate
     * @param normal that of the Normal; "" for none
     */
    void write(String coordinate, String normal);
  }

  /**
   * Writes a figure.
   *
   * @param name the name of the mesh, or ""
   * @throws IOException if all figures together have too many joints, with one sentence; nothing is
   *     written then
   */
  public void write(Skin skin, String name, Surface surface, Shapes shapes) throws IOException {
    List<Integer> used = surface.weights().stream().map(Weight::joint).distinct().sorted().toList();
    List<Integer> nodes = skin.closure(used);
    if (nodes.size() > left) {
      throw new IOException(
          "the parts of the model have more than %d joints together, which is the limit"
              .formatted(MAX_JOINTS));
    }
    left -= nodes.size();
    String def = names.unique(name, "figure");
    out.open("HAnimHumanoid", "DEF", def, "name", def, "version", "2.0");
    List<String> joints = joints(skin, nodes, surface.weights());
    joints.forEach(joint -> out.empty("HAnimJoint", "USE", joint, "containerField", "joints"));
    String coordinate = names.unique("", def + "_points");
    out.open("Coordinate", "DEF", coordinate, "containerField", "skinCoord").ownLine();
    out.numbers("point", Numbers.list(skin.atRest(surface.points(), false))).close();
    String normal = surface.normals().length == 0 ? "" : names.unique("", def + "_normals");
    if (!normal.isEmpty()) {
      out.open("Normal", "DEF", normal, "containerField", "skinNormal").ownLine();
      out.numbers("vector", Numbers.list(skin.atRest(surface.normals(), true))).close();
    }
    shapes.write(coordinate, normal);
    out.close();
  }

  private List<String> joints(Skin skin, List<Integer> nodes, List<Weight> weights) {
    Map<Integer, Influence> influences = new HashMap<>();
    for (Weight weight : weights) {
      Influence influence =
          influences.computeIfAbsent(skin.node(weight.joint()), unused -> new Influence());
      influence.vertices.append(weight.vertex()).append(' ');
      influence.weights.append(Numbers.of(weight.weight())).append(' ');
    }
    Map<Integer, List<Integer>> children = new HashMap<>();
    for (int node : nodes) {
      int parent = skin.nodes().get(node).parent();
      children.computeIfAbsent(parent, unused -> new ArrayList<>()).add(node);
    }
    List<String> written = new ArrayList<>();
    for (int root : children.getOrDefault(-1, List.of())) {
      joint(skin, root, "skeleton", children, influences, written);
    }
    return written;
  }

  private void joint(
      Skin skin,
      int node,
      String container,
      Map<Integer, List<Integer>> children,
      Map<Integer, Influence> influences,
      List<String> written) {
    ModelNode from = skin.nodes().get(node);
    JointBinding binding = skin.binding(node);
    String def = names.unique(from.name(), "joint" + node);
    written.add(def);
    animated.add(node, def, binding);
    out.open("HAnimJoint", "DEF", def, "containerField", container, "name", def);
    double[] t = from.place().translation();
    double[] r = from.place().rotation();
    double[] s = from.place().scale();
    field("center", 0, binding.position().x, binding.position().y, binding.position().z);
    field("translation", 0, binding.translation(t[0], t[1], t[2]));
    double[] turn = binding.rotation(r[0], r[1], r[2], r[3]);
    if (turn[3] != 0) {
      out.attribute("rotation", Numbers.of(turn));
    }
    field("scale", 1, binding.scale(s[0], s[1], s[2]));
    double[] axes =
        Numbers.axisAngle(
            new double[] {
              binding.rotation().x, binding.rotation().y, binding.rotation().z, binding.rotation().w
            });
    if (axes[3] != 0) {
      out.attribute("scaleOrientation", Numbers.of(axes));
    }
    Influence influence = influences.get(node);
    if (influence != null) {
      out.ownLine().numbers("skinCoordIndex", influence.vertices.toString().stripTrailing());
      out.ownLine().numbers("skinCoordWeight", influence.weights.toString().stripTrailing());
    }
    for (int child : children.getOrDefault(node, List.of())) {
      joint(skin, child, "children", children, influences, written);
    }
    out.close();
  }

  private void field(String name, double otherwise, double... value) {
    if (value[0] != otherwise || value[1] != otherwise || value[2] != otherwise) {
      out.attribute(name, Numbers.of(value));
    }
  }
}
