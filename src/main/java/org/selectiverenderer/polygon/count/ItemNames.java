package org.selectiverenderer.polygon.count;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Names of the nodes of a file, as the controller names them: the DEF name, else type and number;
 * the names of the Inlines before it where it is made up or another file has it too.
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

  /** The name of a node, to be asked for once. */
  String of(ParsedNode node) {
    String type = node.type().name();
    int number = numbers.merge(type, 1, Integer::sum);
    String def = node.name();
    if (Structure.isInline(node)) { // Part of paths, which it need not be told from.
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
