package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;

/**
 * An X3D file as read: its head and its scene.
 *
 * @param source the file's name as the user or an Inline gave it
 * @param version for example {@code 4.0}
 * @param profile for example {@code Immersive}
 * @param components component name to level
 * @param meta the meta elements in order, name and content
 * @param units the unit elements: category, name, conversion factor to the standard's base unit
 * @param nodes the nodes at the top of the scene
 * @param loose Scripts behind the first node of a prototype's body, which stand in no other node
 * @param named DEF name to node, in document order
 * @param routes the ROUTE elements in document order
 * @param importedRoutes those of them that lead to or from an imported node
 * @param exportedInstances the fields of exported instances of prototypes, by the exported name
 * @param instances the instances of prototypes: what their interfaces stand for
 * @param externFaults what is wrong with prototypes of other files that it uses; told already
 * @param prototypes those that its scene declares, for instances made later; null for none
 */
public record X3dFile(
    String source,
    String version,
    String profile,
    Map<String, Integer> components,
    List<Meta> meta,
    List<Unit> units,
    List<ParsedNode> nodes,
    List<ParsedNode> loose,
    Map<String, ParsedNode> named,
    List<ParsedRoute> routes,
    List<Import> imports,
    List<Export> exports,
    List<ImportedRoute> importedRoutes,
    Map<String, InstanceFields> exportedInstances,
    ParsedInstance.Listing instances,
    List<Problem> externFaults,
    @Nullable PrototypeLibrary prototypes) {

  /** The nodes at the top of the scene, then those that stand in no other node. */
  public List<ParsedNode> allNodes() {
    if (loose.isEmpty()) {
      return nodes;
    }
    List<ParsedNode> all = new ArrayList<>(nodes);
    all.addAll(loose);
    return all;
  }

  /** The length factor that the units state: metres per unit (X3D 4.0, 4.3.6). */
  public double unitLength() {
    return units.stream()
        .filter(unit -> unit.category().equals("length"))
        .mapToDouble(Unit::conversionFactor)
        .findFirst()
        .orElse(1);
  }

  /** A file of which nothing could be read. */
  static X3dFile empty(String source) {
    return plain(source, List.of(), List.of());
  }

  /** A file of one node, for what is to be read of a node without a file of its own. */
  public static X3dFile of(ParsedNode node, double unitLength) {
    return plain(
        node.location().file(), List.of(new Unit("length", "", unitLength)), List.of(node));
  }

  /** A file of nodes without names, routes and what else a scene may have. */
  private static X3dFile plain(String source, List<Unit> units, List<ParsedNode> nodes) {
    return new X3dFile(
        source,
        "",
        "",
        Map.of(),
        List.of(),
        units,
        nodes,
        List.of(),
        Map.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        Map.of(),
        ParsedInstance.Listing.NONE,
        List.of(),
        null);
  }

  /** A meta statement of the head. */
  public record Meta(String name, String content) {}

  /** A UNIT statement. */
  public record Unit(String category, String name, double conversionFactor) {}

  /** A ROUTE whose ends are checked: nodes exist, fields exist, types agree. */
  public record ParsedRoute(ParsedNode from, int fromField, ParsedNode to, int toField) {}

  /** One end of a ROUTE. */
  public sealed interface End {
    /** A field of a node of this file. */
    record Own(ParsedNode node, int field) implements End {}

    /**
     * A field of a node of another file, which an IMPORT names.
     *
     * @param field as the ROUTE spells it
     */
    record Imported(String name, String field) implements End {}
  }

  /** A ROUTE of which one end at least becomes known when an Inline has its content. */
  public record ImportedRoute(End from, End to, Location location) {}

  /**
   * What the fields of an instance of a prototype stand for, by every name that a ROUTE may use.
   *
   * @param inputs of fields that take events
   * @param outputs of fields that send events
   */
  public record InstanceFields(
      Map<String, List<End.Own>> inputs, Map<String, List<End.Own>> outputs) {}

  /** An IMPORT statement. */
  public record Import(String inlineDef, String importedDef, String as, Location location) {}

  /** An EXPORT statement. */
  public record Export(String localDef, String as, Location location) {}
}
