package org.selectiverenderer.control;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import org.web3d.x3d.sai.X3DNode;

/**
 * The names of nodes for events and messages: the DEF name, else a permanent name made of the type
 * and the number among the nodes of that type in its scene ({@code Switch#3}). Nodes in an Inline
 * are named in the same way, so that dividing a scene into files does not change the logged events.
 * Only where such a name is ambiguous or has no DEF name is it preceded by the names of the
 * Inlines: {@code Kitchen/Teapot}.
 *
 * <p>The SAI returns the node of a name, but not the name of a node. Therefore, unless the browser
 * tells names, all DEF names are looked up and their nodes compared, which is done only when a name
 * is asked for. A browser may return the same object for a node each time, or an equal one.
 */
final class NodeNameRegistry {
  private record Unnamed(SceneScope scope, String madeUp) {}

  private final Map<X3DNode, String> names = new HashMap<>();
  private final Set<String> taken = new HashSet<>();
  private final Map<X3DNode, Unnamed> unnamed = new LinkedHashMap<>();
  private final Map<SceneScope, Map<String, Integer>> numbers = new HashMap<>();

  /** Registers a new node; to be called in the order of the scene. */
  void add(X3DNode node, SceneScope scope) {
    String type = node.getNodeName();
    int number = count(numbers.computeIfAbsent(scope, known -> new HashMap<>()), type);
    unnamed.put(node, new Unnamed(scope, type + "#" + number));
  }

  private void look() {
    Map<X3DNode, String> defs = defs();
    Map<String, Integer> uses = new HashMap<>();
    defs.values().forEach(def -> count(uses, def));
    Map<SceneScope, String> paths = new HashMap<>();
    unnamed.forEach(
        (node, known) -> {
          String def = defs.get(node);
          String plain = def == null ? known.madeUp() : def;
          boolean clear = def != null && uses.get(def) == 1 && !taken.contains(def);
          names.put(
              node,
              clear || known.scope().isMain()
                  ? plain
                  : paths.computeIfAbsent(known.scope(), SceneScope::path) + plain);
        });
    unnamed.keySet().forEach(node -> taken.add(names.get(node)));
    unnamed.clear();
  }

  private static int count(Map<String, Integer> uses, String name) {
    return uses.merge(name, 1, Integer::sum);
  }

  private Map<X3DNode, String> defs() {
    Map<SceneScope, Set<X3DNode>> scopes = new LinkedHashMap<>();
    unnamed.forEach(
        (node, known) ->
            scopes.computeIfAbsent(known.scope(), any -> new LinkedHashSet<>()).add(node));
    Map<X3DNode, String> defs = new HashMap<>();
    scopes.forEach((scope, nodes) -> look(scope, nodes, defs));
    Set<X3DNode> rest = new LinkedHashSet<>(unnamed.keySet());
    rest.removeAll(defs.keySet());
    if (!rest.isEmpty()) { // Applications may put nodes of one scene into another.
      scopes.keySet().forEach(scope -> look(scope, rest, defs));
    }
    return defs;
  }

  private static void look(SceneScope scope, Set<X3DNode> nodes, Map<X3DNode, String> defs) {
    scope.namesOf(nodes).forEach((node, name) -> defs.put(node, name.strip()));
  }

  void remove(X3DNode node) {
    taken.remove(names.remove(node));
    unnamed.remove(node);
  }

  /** Returns the name of a registered node. */
  String of(X3DNode node) {
    if (unnamed.containsKey(node)) {
      look();
    }
    String name = names.get(node);
    if (name == null) {
      throw new IllegalArgumentException("no name was requested for " + node.getNodeName());
    }
    return name;
  }
}
