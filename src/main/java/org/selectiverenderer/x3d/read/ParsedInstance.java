package org.selectiverenderer.x3d.read;

import java.util.List;
import java.util.Map;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * An instance of a prototype, whose body's nodes stand in its place: what its interface stands for.
 * The rest of the scene, and what runs in it, may use an instance by this interface only (X3D 4.0,
 * 4.4.4.1).
 *
 * @param number in the order in which instances begin: outer ones before those in their bodies
 * @param within the number of the instance in whose body it stands; -1 for none
 * @param node the first node of its body
 * @param others the nodes behind the first at the top of its body
 * @param type its interface, the same for all instances of a prototype
 * @param values of fields that no node holds, by their indices; nodes as {@link ParsedNode}s
 * @param links what its fields are connected with
 */
public record ParsedInstance(
    int number,
    int within,
    ParsedNode node,
    List<ParsedNode> others,
    NodeType type,
    Map<Integer, Object> values,
    List<Link> links) {
  /**
   * A field of the interface, and one in the body that IS connects with it; through the interfaces
   * of instances in the body, if need be.
   *
   * @param field its index in the interface
   * @param takes whether events go from the interface to the node
   * @param sends whether events go from the node to the interface
   * @param holds whether the node's field has a value, which is that of the interface's field
   */
  public record Link(
      int field, ParsedNode node, int nodeField, boolean takes, boolean sends, boolean holds) {}

  /**
   * The instances of a file.
   *
   * @param all inner ones before those in whose bodies they stand
   * @param scripts for each Script in a body, the number of the instance
   */
  public record Listing(List<ParsedInstance> all, Map<ParsedNode, Integer> scripts) {
    static final Listing NONE = new Listing(List.of(), Map.of());
  }
}
