package org.selectiverenderer.authoring.nodes;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * The changes that rename a node, the metadata that is called after it, and what refers to them.
 */
final class NodeRenaming {
  private final SourceFormatter layout;
  private final List<TextEdit> changes = new ArrayList<>();

  private NodeRenaming(SourceFormatter layout) {
    this.layout = layout;
  }

  /**
   * Returns the changes.
   *
   * @param names names for the metadata
   * @param to a name that is checked to be free
   */
  static List<TextEdit> changes(
      SourceFormatter layout, UniqueNameGenerator names, DocumentElement node, String to) {
    NodeRenaming renaming = new NodeRenaming(layout);
    renaming.rename(node, to);
    node.def()
        .ifPresent(
            from -> {
              names.unused(to); // no metadata may take it
              UnaryOperator<String> renamed = name -> name.equals(from) ? to : name;
              node.children().forEach(child -> renaming.metadata(child, names, renamed));
              ElementScope.visit(
                  node,
                  each ->
                      QualityFieldNaming.change(layout, each, renamed)
                          .ifPresent(renaming.changes::add));
            });
    return renaming.changes;
  }

  private void metadata(
      DocumentElement element, UniqueNameGenerator names, UnaryOperator<String> renamed) {
    // What comes from an entity of the DOCTYPE is written elsewhere.
    if (!MetadataNaming.isMetadata(element) || element.isReference()) {
      return;
    }
    element
        .def()
        .ifPresent(
            def -> {
              String now = MetadataNaming.def(element, def, renamed);
              if (!now.equals(def)) {
                rename(element, names.unused(now));
              }
            });
    element
        .text("name")
        .ifPresent(
            said -> {
              String now = MetadataNaming.name(element, said, renamed);
              if (!now.equals(said)) {
                changes.add(layout.attribute(element, "name", now));
              }
            });
    element.children().forEach(child -> metadata(child, names, renamed));
  }

  /** Renames a node and all references to it; an EXPORT keeps the name that others know. */
  private void rename(DocumentElement node, String name) {
    String from = node.def().orElse("");
    NodeReferences references = NodeReferences.to(node);
    changes.add(layout.attribute(node, "DEF", name));
    references.uses().forEach(use -> changes.add(layout.attribute(use, "USE", name)));
    for (DocumentElement route : references.routes()) {
      for (String end : List.of("fromNode", "toNode")) {
        if (route.text(end).filter(from::equals).isPresent()) {
          changes.add(layout.attribute(route, end, name));
        }
      }
    }
    references.imports().forEach(in -> changes.add(layout.attribute(in, "inlineDEF", name)));
    for (DocumentElement export : references.exports()) {
      changes.add(layout.attribute(export, "localDEF", name));
      if (export.text("AS").isEmpty()) {
        changes.add(layout.attribute(export, "AS", from));
      }
    }
  }
}
