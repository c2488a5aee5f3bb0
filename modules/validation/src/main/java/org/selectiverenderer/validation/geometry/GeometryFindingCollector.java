package org.selectiverenderer.validation.geometry;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Adds findings about fields of geometry at the attributes that give their values. One instance
 * serves one file.
 */
final class GeometryFindingCollector {
  private final FileContext file;
  private final FindingCollector findings;
  private @Nullable Map<SourceLocation, DocumentElement> elements;
  private @Nullable Set<SourceLocation> filled;

  GeometryFindingCollector(FileContext file, FindingCollector findings) {
    this.file = file;
    this.findings = findings;
  }

  void add(Rule rule, ParsedNode node, Object... words) {
    findings.add(rule, node, words);
  }

  /**
   * Adds a finding at the attribute of that field, or at the child node in it; at the node if the
   * value comes from elsewhere.
   */
  void addAt(Rule rule, ParsedNode node, String field, Object... words) {
    DocumentElement element = elements().get(node.location());
    DocumentAttribute attribute = element == null ? null : element.attribute(field).orElse(null);
    NodeView child = VertexDataAccessor.in(node, field);
    DocumentElement inside = child == null ? null : elements().get(child.location());
    if (attribute != null) {
      findings.add(rule, attribute, words);
    } else if (element != null && inside != null && inside.parent().orElse(null) == element) {
      findings.addWithin(rule, element, inside.location(), words);
    } else {
      findings.add(rule, node, words);
    }
  }

  /**
   * Returns whether values of a node may be set at run time, by IS, a route, or a script that
   * refers to the node, so that the file need not contain them.
   */
  boolean filledLater(NodeView node) {
    Set<SourceLocation> known = filled;
    if (known == null) {
      known = filled();
      filled = known;
    }
    return known.contains(node.location());
  }

  private Set<SourceLocation> filled() {
    Set<SourceLocation> places = new HashSet<>();
    Set<String> names = new HashSet<>();
    for (DocumentElement element : file.document().elements()) {
      switch (element.name()) {
        case "IS" -> element.parent().ifPresent(node -> places.add(node.location()));
        case "ROUTE" -> element.text("toNode").ifPresent(names::add);
        case "EXPORT" -> element.text("localDEF").ifPresent(names::add);
        default -> {
          boolean given =
              element
                  .parent()
                  .filter(p -> p.name().equals("field") || p.name().equals("fieldValue"))
                  .isPresent();
          if (given) {
            element.text("USE").ifPresent(names::add);
          }
        }
      }
    }
    for (DocumentElement element : file.document().elements()) {
      element.text("DEF").filter(names::contains).ifPresent(d -> places.add(element.location()));
    }
    return places;
  }

  private Map<SourceLocation, DocumentElement> elements() {
    Map<SourceLocation, DocumentElement> known = elements;
    if (known == null) {
      known = new HashMap<>();
      for (DocumentElement element : file.document().elements()) {
        known.put(element.location(), element);
      }
      elements = known;
    }
    return known;
  }
}
