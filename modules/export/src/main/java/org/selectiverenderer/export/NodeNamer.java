package org.selectiverenderer.export;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/** Gives DEF names to nodes of a scene that have none, so that statements can name them. */
final class NodeNamer {
  private final SceneDocument document;
  private final UniqueNameGenerator names;
  private final Map<DocumentElement, String> given = new HashMap<>();
  private final List<TextEdit> edits = new ArrayList<>();

  /** Creates a namer for the nodes outside of prototypes. */
  NodeNamer(SceneDocument document) {
    this.document = document;
    var tree = document.tree().orElseThrow();
    this.names = new UniqueNameGenerator(tree, tree.scene().orElseThrow());
  }

  /** Returns the DEF name of a node; one without gets the wanted one, with a number if taken. */
  String name(DocumentElement element, String wanted) {
    return element
        .def()
        .orElseGet(
            () ->
                given.computeIfAbsent(
                    element,
                    unnamed -> {
                      String name = names.unused(wanted);
                      edits.add(document.layout().attribute(unnamed, "DEF", name));
                      return name;
                    }));
  }

  /** Returns a name that no node has yet. */
  String unused(String wanted) {
    return names.unused(wanted);
  }

  /** Returns the edits that write the names that were given. */
  List<TextEdit> edits() {
    return List.copyOf(edits);
  }
}
