package org.selectiverenderer.document;

import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.x3d.source.ElementTree;

/** Gives out names that no node of the document has. For one edit. */
public final class FreeNames {
  private final ElementTree tree;
  private final Set<String> given = new HashSet<>();

  public FreeNames(ElementTree tree) {
    this.tree = tree;
  }

  /** The name wanted, made one of an XML identifier, or the first free one of it with a number. */
  public String free(String wanted) {
    return unused(identifier(wanted));
  }

  /** The name itself, or the first free one of it with a number. */
  public String unused(String base) {
    String name = base;
    for (int i = 2; tree.named(name).isPresent() || tree.used(name) || given.contains(name); i++) {
      name = base + "_" + i;
    }
    given.add(name);
    return name;
  }

  /** Whether a name can be that of a node. */
  public static boolean allowed(String name) {
    return !name.isEmpty()
        && identifier(name).equals(name)
        && "0123456789-".indexOf(name.charAt(0)) < 0;
  }

  /** A name without what cannot stand in one (X3D 4.0, 4.4.2.2): spaces, quotes and the like. */
  public static String identifier(String wanted) {
    StringBuilder name = new StringBuilder(wanted.length());
    wanted
        .codePoints()
        .map(c -> c <= ' ' || "\"'#+,.[]\\{}:<>&".indexOf(c) >= 0 ? '_' : c)
        .forEach(name::appendCodePoint);
    return name.toString();
  }
}
