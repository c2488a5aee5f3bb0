package org.selectiverenderer.export;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/** Renames prototypes that go from one file into another, which may have the same names. */
final class PrototypeNames {
  /** Statements that must be directly in a Scene or a prototype, before its nodes. */
  static final Set<String> DECLARATIONS = Set.of("ProtoDeclare", "ExternProtoDeclare");

  private PrototypeNames() {}

  /** Returns the names of the prototypes that a document declares. */
  static Set<String> declared(SceneDocument document) {
    Set<String> names = new LinkedHashSet<>();
    SceneFiles.elements(document).stream()
        .filter(element -> DECLARATIONS.contains(element.name()))
        .forEach(element -> element.text("name").ifPresent(names::add));
    return names;
  }

  /**
   * Returns new names for those that are taken.
   *
   * @param own names of one file
   * @param taken names of the other
   */
  static Map<String, String> renamed(Collection<String> own, Collection<String> taken) {
    Set<String> used = new HashSet<>(taken);
    Map<String, String> renamed = new HashMap<>();
    for (String name : own) {
      String free = name;
      for (int i = 2; used.contains(free) || i > 2 && own.contains(free); i++) {
        free = name + "_" + i;
      }
      if (!free.equals(name)) {
        renamed.put(name, free);
        used.add(free);
      }
    }
    return renamed;
  }

  /** Returns the changes that rename prototypes where they are declared and where they are used. */
  static List<TextEdit> edits(SceneDocument document, Map<String, String> renamed) {
    List<TextEdit> edits = new ArrayList<>();
    for (DocumentElement element : SceneFiles.elements(document)) {
      boolean names =
          DECLARATIONS.contains(element.name()) || element.name().equals("ProtoInstance");
      String now = names ? renamed.get(element.text("name").orElse("")) : null;
      if (now != null) {
        edits.add(document.layout().attribute(element, "name", now));
      }
    }
    return edits;
  }
}
