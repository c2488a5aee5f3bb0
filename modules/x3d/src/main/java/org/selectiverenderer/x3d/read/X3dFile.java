package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * A scene read from a file, with its head statements.
 *
 * @param source the file's name as the user or an Inline gave it
 * @param version for example {@code 4.0}
 * @param profile for example {@code Immersive}
 * @param components component name to level
 * @param meta the meta elements in document order
 * @param units the unit elements in document order
 * @param nodes the root nodes of the scene
 * @param loose Scripts without a parent, after the first node of a prototype's body
 * @param named DEF name to node, in document order
 * @param routes the ROUTE elements in document order
 * @param importedRoutes the routes to or from imported nodes
 * @param exportedInstances the fields of exported prototype instances, by exported name
 * @param instances the prototype instances with their interfaces
 * @param externFaults the errors of EXTERNPROTO declarations; already reported
 * @param prototypes the prototypes of the scene, for instances created later; null for none
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
    ParsedProtoInstance.Listing instances,
    List<Problem> externFaults,
    @Nullable PrototypeLibrary prototypes) {

  /** Returns the root nodes of the scene, then the Scripts without a parent. */
  public List<ParsedNode> allNodes() {
    if (loose.isEmpty()) {
      return nodes;
    }
    List<ParsedNode> all = new ArrayList<>(nodes);
    all.addAll(loose);
    return all;
  }

  /** Returns the unit of length in metres (UNIT statement, X3D 4.0, 4.3.6). */
  public double unitLength() {
    return units.stream()
        .filter(unit -> unit.category().equals("length"))
        .mapToDouble(Unit::conversionFactor)
        .findFirst()
        .orElse(1);
  }

  /** Returns the empty scene of a file that could not be read. */
  static X3dFile empty(String source) {
    return plain(source, List.of(), List.of());
  }

  /** Returns a scene of one node. */
  public static X3dFile of(ParsedNode node, double unitLength) {
    return plain(
        node.location().file(), List.of(new Unit("length", "", unitLength)), List.of(node));
  }

  /** Returns a scene of nodes only. */
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
        ParsedProtoInstance.Listing.NONE,
        List.of(),
        null);
  }

  /** A meta statement of the head. */
  public record Meta(String name, String content) {}

  /** A UNIT statement. */
  public record Unit(String category, String name, double conversionFactor) {}

  /** A ROUTE whose nodes and fields exist and whose field types agree. */
  public record ParsedRoute(ParsedNode from, int fromField, ParsedNode to, int toField) {}

  /** One end of a ROUTE. */
  public sealed interface End {
    /** A field of a node of this file. */
    record Own(ParsedNode node, int field) implements End {}

    /**
     * A field of an imported node of another file.
     *
     * @param field the name of the field in the ROUTE
     */
    record Imported(String name, String field) implements End {}
  }

  /** A ROUTE to or from an imported node, which is resolved when its Inline is loaded. */
  public record ImportedRoute(End from, End to, SourceLocation location) {}

  /**
   * The node fields to which the fields of a prototype instance resolve, by every name that a ROUTE
   * may use.
   *
   * @param inputs the fields that receive events
   * @param outputs the fields that send events
   */
  public record InstanceFields(
      Map<String, List<End.Own>> inputs, Map<String, List<End.Own>> outputs) {}

  /** An IMPORT statement. */
  public record Import(String inlineDef, String importedDef, String as, SourceLocation location) {}

  /** An EXPORT statement. */
  public record Export(String localDef, String as, SourceLocation location) {}
}
