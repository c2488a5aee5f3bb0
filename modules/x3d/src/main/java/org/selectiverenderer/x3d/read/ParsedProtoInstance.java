package org.selectiverenderer.x3d.read;

import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * The interface of a prototype instance that has been expanded to the nodes of its body. The rest
 * of the scene, and its scripts, may access the instance by this interface only (X3D 4.0, 4.4.4.1).
 *
 * @param number the number of the instance; outer ones precede those in their bodies
 * @param within the number of the instance whose body contains it; -1 for none
 * @param location the ProtoInstance in the file; for one in a body, that of the body
 * @param node the first node of its body
 * @param others the further top-level nodes of its body
 * @param type the node type of the interface, the same for all instances of a prototype
 * @param values the values, by field index, of fields that no node stores; nodes as {@link
 *     ParsedNode}s
 * @param links the connections of its fields
 */
public record ParsedProtoInstance(
    int number,
    int within,
    SourceLocation location,
    ParsedNode node,
    List<ParsedNode> others,
    NodeType type,
    Map<Integer, Object> values,
    List<Link> links) {
  /**
   * An IS connection of an interface field and a node field in the body, possibly through the
   * interfaces of instances in the body.
   *
   * @param field the index of the interface field
   * @param takes whether the interface field passes events to the node field
   * @param sends whether the node field passes events to the interface field
   * @param holds whether the node field stores the value of the interface field
   */
  public record Link(
      int field, ParsedNode node, int nodeField, boolean takes, boolean sends, boolean holds) {}

  /**
   * The instances of a file.
   *
   * @param all the instances; inner ones precede those whose bodies contain them
   * @param scripts the number of the instance for each Script in a body
   */
  public record Listing(List<ParsedProtoInstance> all, Map<ParsedNode, Integer> scripts) {
    static final Listing NONE = new Listing(List.of(), Map.of());
  }
}
