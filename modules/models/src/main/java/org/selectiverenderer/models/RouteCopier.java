package org.selectiverenderer.models;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.ParsedProtoInstance;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.tessellate.GroupingNodeChildren;
import org.selectiverenderer.x3d.write.X3dNodeWriter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Copies what makes some nodes of a scene move: the ROUTEs among them, and the sensors, scripts and
 * interpolators that stand in the body of a prototype beside its first node and so in no field.
 */
final class RouteCopier {
  private final X3dFile scene;
  private final List<ParsedNode> beside = new ArrayList<>();
  private final List<X3dFile.ParsedRoute> routes = new ArrayList<>();

  RouteCopier(List<? extends NodeView> nodes, X3dFile scene) {
    this.scene = scene;
    Set<ParsedNode> inside = Collections.newSetFromMap(new IdentityHashMap<>());
    List<ParsedNode> parsed = new ArrayList<>();
    for (NodeView node : nodes) {
      if (node instanceof ParsedNode own) {
        parsed.add(own);
      }
    }
    NodeTraversal.visit(parsed, inside::add);
    gatherBeside(inside);
    for (X3dFile.ParsedRoute route : scene.routes()) {
      if (inside.contains(route.from()) && inside.contains(route.to())) {
        routes.add(route);
      }
    }
  }

  /** Adds the nodes beside those of instances, as long as these bring further instances. */
  private void gatherBeside(Set<ParsedNode> inside) {
    Set<Integer> known = new HashSet<>();
    boolean more = true;
    while (more) {
      more = false;
      for (ParsedProtoInstance instance : scene.instances().all()) {
        if (inside.contains(instance.node()) && known.add(instance.number())) {
          List<ParsedNode> active =
              instance.others().stream().filter(node -> !drawn(node)).toList();
          beside.addAll(active);
          NodeTraversal.visit(active, inside::add);
          more = true;
        }
      }
    }
  }

  /** Returns whether a node would be drawn at the top of a file, as it is not in a body. */
  private static boolean drawn(ParsedNode node) {
    return !node.type().is("X3DChildNode")
        || node.type().is("X3DShapeNode")
        || node.type().is("X3DLightNode")
        || node.type().is("X3DBindableNode")
        || node.type().name().equals("Inline")
        || GroupingNodeChildren.isGroup(node.type());
  }

  /** Returns the nodes that stand beside the first nodes of bodies. */
  List<ParsedNode> beside() {
    return beside;
  }

  /** Sees that all ends of the ROUTEs get names; to be called before the nodes are written. */
  void name(X3dNodeWriter writer) {
    for (X3dFile.ParsedRoute route : routes) {
      for (ParsedNode end : List.of(route.from(), route.to())) {
        if (end.name() == null) {
          writer.called(end, "Node");
        }
      }
    }
  }

  /** Writes the ROUTEs, when the nodes have been written. */
  void append(X3dWriter out, X3dNodeWriter writer) {
    for (X3dFile.ParsedRoute route : routes) {
      String from = writer.name(route.from());
      String to = writer.name(route.to());
      if (!from.isEmpty() && !to.isEmpty()) {
        out.route(
            from,
            route.from().type().fields().get(route.fromField()).name(),
            to,
            route.to().type().fields().get(route.toField()).name());
      }
    }
  }
}
