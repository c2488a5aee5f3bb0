package org.selectiverenderer.polygon.count;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Makes the names of a file's nodes as the controller does: the DEF name, else type and number. The
 * names of the Inlines that lead to the file are prefixed where the name is made up or occurs in
 * another file too.
 */
final class ItemNames {
  private final String path;
  private final Set<String> taken;
  private final Map<String, Integer> numbers = new HashMap<>();

  /**
   * @param path the names of the Inlines that lead to the file, each followed by a slash; empty for
   *     the scene's own file
   * @param taken names of Switches and ProximitySensors of all files so far, to which these are
   *     added
   */
  ItemNames(String path, Set<String> taken) {
    this.path = path;
    this.taken = taken;
  }

  String path() {
    return path;
  }

  /** Returns the name of a node; to be called once for each node. */
  String of(ParsedNode node) {
    String type = node.type().name();
    int number = numbers.merge(type, 1, Integer::sum);
    String def = node.name();
    if (Structure.isInline(node)) { // only a part of paths, which need not be unique
      return def != null ? def.strip() : type + "#" + number;
    }
    if (def == null) {
      return path + type + "#" + number;
    }
    String name = def.strip();
    boolean told = Structure.isSwitch(node) || Structure.isSensor(node);
    return !told || taken.add(name) ? name : path + name;
  }
}
