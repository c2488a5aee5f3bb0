package org.selectiverenderer.authoring.editing;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.TextEdit;

/** Creates the edits of cutting, pasting and deleting elements. */
public final class ElementEdits {
  private static final Set<String> ROUTED = Set.of("fromNode", "toNode");
  private static final Set<String> KEPT = Set.of("X3D", "Scene");

  private final SceneDocument document;

  public ElementEdits(SceneDocument document) {
    this.document = document;
  }

  /**
   * Removes an element and all references to it or to its descendants: ROUTE, IMPORT, EXPORT.
   *
   * @param name name of the undo step
   * @throws EditRejectedException if a node in it is referenced by USE, or the element is mandatory
   */
  public Edit remove(DocumentElement element, String name) {
    return new Edit(name, new NodeEdits(document).removal(element));
  }

  private ElementTree tree() {
    return document
        .tree()
        .orElseThrow(
            () -> new EditRejectedException("The text is not well formed; correct it first"));
  }

  /**
   * Inserts an element after another one, or at the end of the scene. A number is appended to DEF
   * names that are taken.
   *
   * @param where the preceding element; X3D or Scene to insert at the end of the scene
   * @param text text of the element
   * @param name name of the undo step
   * @throws EditRejectedException if the text is not a well-formed element
   */
  public Edit paste(DocumentElement where, String text, String name) {
    boolean into = KEPT.contains(where.name());
    DocumentElement scene = where.name().equals("X3D") ? tree().scene().orElse(where) : where;
    List<String> lines = lines(renamed(text.strip(), where));
    TextEdit change =
        into
            ? document.layout().insertLast(scene, lines)
            : document.layout().insertAfter(where, lines);
    return new Edit(name, List.of(change));
  }

  private String renamed(String text, DocumentElement where) {
    SceneDocument pasted;
    try {
      pasted = SceneDocument.of("clipboard", text.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new EditRejectedException("The clipboard contains no element: " + e.getMessage());
    }
    ElementTree tree =
        pasted
            .tree()
            .orElseThrow(
                () ->
                    new EditRejectedException(
                        "The clipboard contains no well-formed element"
                            + pasted.fault().map(fault -> ": " + fault.message()).orElse("")));
    UniqueNameGenerator free = new UniqueNameGenerator(tree(), where);
    Map<String, String> names = new HashMap<>();
    ElementScope.visitWithin(
        tree.root(),
        each -> each.def().ifPresent(def -> names.computeIfAbsent(def, free::unused)));
    List<TextEdit> changes = new ArrayList<>();
    ElementScope.visitWithin(
        tree.root(),
            each -> {
              for (SourceAttribute written : pasted.tag(each).attributes()) {
                String now = names.get(written.value());
                boolean naming =
                    Set.of("DEF", "USE").contains(written.name())
                        || ROUTED.contains(written.name()) && each.name().equals("ROUTE");
                if (naming && now != null && !now.equals(written.value())) {
                  changes.add(new TextEdit(written.valueFrom(), written.valueTo(), now));
                }
              }
            });
    return TextEdit.applied(changes, text).toString();
  }

  /** Returns the lines without the common indentation of the lines after the first. */
  private static List<String> lines(String text) {
    String[] lines = text.split("\r\n|\r|\n", -1);
    int common = Integer.MAX_VALUE;
    for (int i = 1; i < lines.length; i++) {
      if (!lines[i].isBlank()) {
        common = Math.min(common, indentation(lines[i]));
      }
    }
    List<String> cut = new ArrayList<>(List.of(lines[0]));
    for (int i = 1; i < lines.length; i++) {
      cut.add(lines[i].substring(Math.min(common, indentation(lines[i]))));
    }
    return cut;
  }

  private static int indentation(String line) {
    int at = 0;
    while (at < line.length() && (line.charAt(at) == ' ' || line.charAt(at) == '\t')) {
      at++;
    }
    return at;
  }
}
