package org.selectiverenderer.control;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import org.web3d.x3d.sai.X3DNode;

/**
 * Names of nodes for events and messages: the DEF name, else one made up of the type and the place
 * among the nodes of that type in its scene ({@code Switch#3}), which a node keeps. What stands in
 * an Inline is called the same, so that a scene that is divided into files keeps its time line.
 * Only where that does not tell it from others, or is made up, do the names of the Inlines stand
 * before it: {@code Kitchen/Teapot}.
 *
 * <p>The SAI does not tell a node's name, only the node of a name, so that nodes are compared: a
 * browser may hand out the same object for a node each time, or an equal one. All names are looked
 * up for that, so only when a name is asked for.
 */
final class NodeNames {
  private record Unnamed(SceneScope scope, String madeUp) {}

  private final Map<X3DNode, String> names = new HashMap<>();
  private final Set<String> taken = new HashSet<>();
  private final Map<X3DNode, Unnamed> unnamed = new LinkedHashMap<>();
  private final Map<SceneScope, Map<String, Integer>> numbers = new HashMap<>();

  /** Names a node that appeared, each in the order of its scene. */
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
    Set<SceneScope> scopes = new LinkedHashSet<>();
    unnamed.values().forEach(known -> scopes.add(known.scope()));
    Map<X3DNode, String> defs = new HashMap<>();
    for (SceneScope scope : scopes) {
      for (String name : scope.scene().getNamedNodes()) {
        X3DNode node = scope.named(name);
        if (unnamed.containsKey(node)) {
          defs.put(node, name.strip());
        }
      }
    }
    return defs;
  }

  void remove(X3DNode node) {
    taken.remove(names.remove(node));
    unnamed.remove(node);
  }

  /** The name of a node that was added. */
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
